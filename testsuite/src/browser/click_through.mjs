// Annex B.4 clicked through to its end: two bricks, both weights, eight seconds of mixing, tipped and back.

import assert from 'node:assert/strict';
import { control, drawn, lit, outputs, scan, set } from './page.mjs';

export default async function play(page) {
  assert.equal(await page.textContent('#state'), 'paused');
  assert.deepEqual(await lit(page), ['1', '9']);
  assert.deepEqual(await outputs(page), []);
  // A change waits for the next scan, and is marked as long as it does.
  await set(page, { z: 1, S0: 1, CS: 1 });
  await drawn(page);
  assert.equal(await page.locator('.waits').count(), 3);
  assert.deepEqual(await lit(page), ['1', '9']);
  // Transition (1) is cleared into both macro-steps.
  await scan(page);
  assert.equal(await page.locator('.waits').count(), 0);
  assert.deepEqual(await lit(page), ['E2', 'E3', '9'].sort(byPlace(await order(page))));
  assert.deepEqual(await outputs(page), ['VA', 'BM', 'BUSY']);
  assert.deepEqual(await page.$$eval('.step.macro.active', (all) => all.map((step) => step.dataset.step)), ['M2', 'M3']);
  assert.deepEqual(await page.$$eval('.transition.cleared', (all) => all.map((one) => one.dataset.transition)), ['1']);
  assert.deepEqual(await page.$$eval('.transition.enabled', (all) => all.map((one) => one.dataset.transition).sort()), ['20', '30']);
  assert.deepEqual(await page.$$eval('.action.acting', (all) => all.map((one) => one.dataset.variable).sort()), ['BM', 'BUSY', 'VA']);
  await scan(page, { CS: 0, z: 0, TD: 1 });
  await scan(page, { TD: 0 });
  await scan(page, { TD: 1, a: 1 });
  assert.deepEqual(await outputs(page), ['VB', 'BUSY']);
  await scan(page, { TD: 0, b: 1 });
  assert.deepEqual(await outputs(page), ['VC', 'BUSY']);
  // The last of the powder: both macro-steps are left in the same scan, by a micro-step that can be seen alone.
  await set(page, { a: 0, b: 0, z: 1 });
  await control(page, 'micro-step');
  await drawn(page);
  assert.equal(await page.getAttribute('#state', 'data-state'), 'within');
  assert.ok((await lit(page)).includes('S2'));
  assert.deepEqual(await outputs(page), ['VC', 'BUSY'], 'outputs stay published until the scan ends');
  await control(page, 'micro-step');
  await drawn(page);
  assert.ok((await lit(page)).includes('4'));
  await control(page, 'scan');
  await drawn(page);
  assert.equal(await page.getAttribute('#state', 'data-state'), 'paused');
  assert.deepEqual(await outputs(page), ['MR']);
  // What is left of the delay is shown, and can be jumped over.
  assert.match(await page.textContent('#delays'), /8\.000 s/);
  const before = await seconds(page);
  await control(page, 'jump');
  await drawn(page);
  assert.equal(Math.round((await seconds(page)) - before), 8);
  assert.deepEqual(await outputs(page), ['MR', 'TM_down']);
  await scan(page, { S0: 0 });
  await scan(page, { S1: 1 });
  assert.deepEqual(await outputs(page), ['TM_up']);
  await scan(page, { S1: 0, S0: 1 });
  assert.deepEqual(await lit(page), ['1', '9']);
  assert.deepEqual(await outputs(page), []);
}

async function seconds(page) {
  return Number((await page.textContent('#time')).replace(' s', ''));
}

/** The steps in the order of the drawing. */
async function order(page) {
  return page.$$eval('.step', (steps) => steps.map((step) => step.dataset.step));
}

function byPlace(labels) {
  return (a, b) => labels.indexOf(a) - labels.indexOf(b);
}

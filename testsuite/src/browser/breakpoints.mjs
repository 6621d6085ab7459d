// Breakpoints on a transition and on a step of annex B.4; undo; and what follows a stop within a scan.

import assert from 'node:assert/strict';
import { control, drawn, lit, scan } from './page.mjs';

export default async function play(page) {
  for (const inputs of [{ z: 1, S0: 1, CS: 1 }, { TD: 1, z: 0 }, { TD: 0 }, { TD: 1, a: 1 }, { b: 1 }, { z: 1 }]) await scan(page, inputs);
  assert.ok((await lit(page)).includes('4'));
  const since = await page.textContent('#time');
  // The delay of 8 s ends in a run, which stops in the micro-step that clears (3).
  await page.click('[data-transition="3"] .hit');
  await drawn(page);
  assert.equal(await page.getAttribute('[data-transition="3"].transition', 'aria-pressed'), 'true');
  await page.selectOption('[data-setting="speed"]', 'max');
  await control(page, 'run');
  await page.waitForSelector('#state[data-state="break"]');
  await drawn(page);
  assert.match(await page.textContent('#say'), /\(3\)/);
  const ms = (text) => Math.round(Number(text.replace(' s', '')) * 1000);
  assert.equal(ms(await page.textContent('#time')) - ms(since), 8000);
  assert.deepEqual(await page.$$eval('.transition.cleared', (all) => all.map((one) => one.dataset.transition)), ['3']);
  assert.ok((await lit(page)).includes('5'));
  // What was run is taken back as one.
  await control(page, 'undo');
  await drawn(page);
  assert.equal(await page.textContent('#time'), since);
  assert.ok((await lit(page)).includes('4'));
  // A step: from the list, and removed there.
  await page.selectOption('#breakpoint-add', { label: 'step 6' });
  await page.locator('#breakpoints li', { hasText: '(3)' }).locator('button').click();
  assert.equal(await page.locator('#breakpoints li').count(), 1);
  await control(page, 'jump');
  await scan(page, { S1: 1, S0: 0 });
  await drawn(page);
  assert.equal(await page.getAttribute('#state', 'data-state'), 'break');
  assert.ok((await lit(page)).includes('6'));
}

// Names and comments that would be markup or script are shown as what they are, exactly, and can be used.

import assert from 'node:assert/strict';
import { drawn, saved, scan } from './page.mjs';

export default async function play(page, job) {
  page.on('dialog', (dialog) => assert.fail(`a text spoke: ${dialog.message()}`));
  assert.equal(await page.evaluate(() => window.harmed), undefined);
  assert.equal(await page.locator('img, iframe, object, embed, script:not([type]):nth-of-type(n+4)').count(), 0);
  assert.deepEqual(await page.$$eval('[data-step]', (all) => all.map((one) => one.dataset.step)), job.steps);
  const names = await page.$$eval('[data-input]', (all) => all.map((one) => one.dataset.input));
  assert.deepEqual(names, job.inputs);
  for (const name of names) {
    // Selectors take any text this way.
    await page.evaluate((name) => [...document.querySelectorAll('[data-input]')].find((one) => one.dataset.input === name).click(), name);
  }
  await scan(page);
  await drawn(page);
  assert.deepEqual(await page.$$eval('.step.active', (all) => all.map((one) => one.dataset.step)), job.then);
  assert.equal(await page.evaluate(() => window.harmed), undefined);
  // No mark that turns the text around is shown as such, and the trace has the exact names.
  assert.doesNotMatch(await page.evaluate(() => document.body.innerText), /[\u202a-\u202e\u2066-\u2069]/);
  const trace = await saved(page, 'save-trace');
  assert.ok(trace.split('\n')[0].includes(job.inHeader), trace.split('\n')[0]);
}

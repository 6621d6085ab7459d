// A trace through the chart of a page at once: the table is the one that `grafc sim` writes, and so is a run of the page.

import assert from 'node:assert/strict';
import { control, drawn, load } from './page.mjs';

export default async function play(page, job) {
  await load(page, job.trace);
  await page.selectOption('[data-setting="speed"]', 'max');
  await control(page, 'run');
  // Until the run is drawn for the first time, the page is seen paused as before.
  await drawn(page);
  await page.waitForSelector('#state[data-state="paused"]');
  assert.equal(await page.evaluate(() => window.grafc.result()), job.result);
  if (job.vcd) assert.equal(await page.evaluate(() => window.grafc.vcd()), job.vcd);
  const last = job.result.trim().split('\n').at(-1).split(',');
  const shown = await page.$$eval('[data-output]', (items) => items.map((item) => item.dataset.value));
  assert.deepEqual(shown, last.slice(1, 1 + shown.length), 'the last row, as the page shows it');
}

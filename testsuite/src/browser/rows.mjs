// A trace on the page, scan by scan: each row shows what `grafc sim` writes in that row.

import assert from 'node:assert/strict';
import { load } from './page.mjs';

export default async function play(page, job) {
  await load(page, job.trace);
  const rows = await page.evaluate(async (count) => {
    const seen = [];
    for (let row = 0; row < count; row++) {
      if (row) document.querySelector('[data-control="scan"]').click();
      await new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(done)));
      const outputs = [...document.querySelectorAll('[data-output]')].map((item) => item.dataset.value);
      const steps = [...document.querySelectorAll('.step.active:not(.macro)')].map((step) => step.dataset.step);
      const flags = [...document.querySelectorAll('[data-flag]')].map((flag) => flag.dataset.flag);
      seen.push([outputs, steps.sort(), flags]);
    }
    return seen;
  }, job.rows.length);
  job.rows.forEach((row, at) => assert.deepEqual(rows[at], [row.outputs, row.situation.sort(), row.flags], `row ${at}`));
  // And the table that the page saves is the one that the command writes.
  assert.equal(await page.evaluate(() => window.grafc.result()), job.result);
  return `${rows.length} rows`;
}

// What was done is saved, and done again: the files are kept for `grafc sim`, and a replay ends where the first run did.

import assert from 'node:assert/strict';
import { writeFileSync } from 'node:fs';
import { control, drawn, lit, load, saved, scan } from './page.mjs';

export default async function play(page, job) {
  for (const inputs of [{ z: 1, S0: 1, CS: 1 }, { TD: 1, z: 0 }, { TD: 0 }, {}, { TD: 1, a: 1 }, { b: 1 }, { z: 1 }]) await scan(page, inputs);
  await page.selectOption('[data-setting="speed"]', '10');
  await control(page, 'run');
  await page.waitForTimeout(250);
  await control(page, 'pause');
  await control(page, 'jump');
  await drawn(page);
  const trace = await saved(page, 'save-trace');
  writeFileSync(`${job.out}.csv`, trace);
  writeFileSync(`${job.out}.result.csv`, await saved(page, 'save-result'));
  writeFileSync(`${job.out}.vcd`, await saved(page, 'save-vcd'));
  const end = [await lit(page), await page.textContent('#time'), await page.textContent('#outputs')];
  await page.selectOption('[data-setting="speed"]', 'max');
  await control(page, 'replay');
  await page.waitForSelector('#state[data-state="paused"]');
  await drawn(page);
  assert.deepEqual([await lit(page), await page.textContent('#time'), await page.textContent('#outputs')], end);
  assert.equal(await saved(page, 'save-trace'), trace);
  // A trace that does not fit is refused as a whole, with the reason.
  await load(page, 't_ms,CS,nothing\n0,0,0\n');
  assert.match(await page.textContent('#say'), /nothing/);
  assert.equal(await page.textContent('#time'), end[1]);
  await load(page, 't_ms,CS\n0,0\n20,2\n');
  assert.match(await page.textContent('#say'), /Line 3/);
  // A table of a spreadsheet, dropped onto the page.
  await page.evaluate(() => {
    const files = new DataTransfer();
    files.items.add(new File(['t_ms;z;S0;CS\n0;FALSCH;0;0\n500;1;WAHR;1\n'], 'a.csv', { type: 'text/csv' }));
    window.dispatchEvent(new DragEvent('drop', { dataTransfer: files }));
  });
  await page.waitForFunction(() => document.getElementById('time').textContent === '0.000 s');
  await control(page, 'scan');
  await drawn(page);
  assert.equal(await page.textContent('#time'), '0.500 s');
  assert.ok((await lit(page)).includes('E2'));
}

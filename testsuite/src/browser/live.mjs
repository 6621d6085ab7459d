// What a page keeps when it is loaded again, as a server asks for it.

import assert from 'node:assert/strict';
import { control, drawn, lit, output, scan, set } from './page.mjs';

export default async function play(page) {
  await scan(page, { z: 1, S0: 1, CS: 1 });
  await scan(page, { TD: 1, a: 1, z: 0 });
  await page.selectOption('[data-setting="theme"]', 'dark');
  await page.click('[data-transition="3"] .hit');
  await set(page, { b: 1 });
  const before = [await lit(page), await page.textContent('#time'), await page.textContent('#outputs')];
  await page.evaluate(() => sessionStorage.setItem('grafc-keep', JSON.stringify(window.grafc.keep())));
  await page.reload();
  await drawn(page);
  assert.deepEqual([await lit(page), await page.textContent('#time'), await page.textContent('#outputs')], before);
  assert.equal(await page.getAttribute('[data-input="b"]', 'aria-pressed'), 'true', 'an input that waits');
  assert.equal(await page.locator('#breakpoints li').count(), 1);
  await scan(page);
  assert.equal(await output(page, 'VC'), '1');
  // Only once: the next page begins anew.
  await page.reload();
  await drawn(page);
  assert.deepEqual(await lit(page), ['1', '9']);
  // A chart that has changed: what was done is done again with what it still knows.
  await scan(page, { z: 1, S0: 1, CS: 1 });
  await page.evaluate(() => {
    const kept = window.grafc.keep();
    kept.chart = 'another';
    kept.inputs.push(['gone', '1']);
    kept.trace[1].changes.push(['gone', '1']);
    kept.breaks.steps.push('gone');
    sessionStorage.setItem('grafc-keep', JSON.stringify(kept));
  });
  await page.reload();
  await drawn(page);
  assert.equal(await output(page, 'VA'), '1');
  await control(page, 'scan');
}

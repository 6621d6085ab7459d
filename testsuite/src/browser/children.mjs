// A child on the page: dark before it is started, in a dashed frame while a pulse order has frozen it.

import assert from 'node:assert/strict';
import { lit, scan } from './page.mjs';

export default async function play(page) {
  const frozen = () => page.$$eval('.frame.frozen', (all) => all.map((one) => one.dataset.grafcet));
  await scan(page);
  assert.deepEqual(await lit(page), ['0']);
  await scan(page, { m: 1 });
  assert.deepEqual(await lit(page), ['1', '10']);
  await scan(page, { a: 1 });
  assert.deepEqual(await lit(page), ['1', '11']);
  assert.deepEqual(await frozen(), []);
  // Step 2 freezes P, whose steps are dark then.
  await scan(page, { n: 1 });
  assert.deepEqual(await lit(page), ['2']);
  assert.deepEqual(await frozen(), ['P']);
  assert.match(await page.textContent('#grafcets'), /\{\} frozen/);
  // Step 3 resumes it where it was.
  await scan(page, { q: 1 });
  assert.deepEqual(await lit(page), ['3', '11']);
  assert.deepEqual(await frozen(), []);
}

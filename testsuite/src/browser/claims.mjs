// What is claimed of a chart: rows of a table in the drawing that are lit, and words for what does not hold.

import assert from 'node:assert/strict';
import { control, drawn, scan } from './page.mjs';

export default async function play(page) {
  const of = (selector, name) => page.$$eval(selector, (all, name) => all.map((one) => one.dataset[name]), name);
  assert.deepEqual(await of('.claim', 'claim'), ['0', '1', '2', '3']);
  assert.deepEqual(await of('.claim.broken', 'claim'), [], 'all of them hold in the initial situation');
  // Step 2 becomes active by the very call that must not last.
  await scan(page, { call_up: 1 });
  assert.deepEqual(await of('.claim.broken', 'claim'), ['2']);
  assert.match(await page.textContent('[data-broken="2"]'), /^assertNot so in this situation.* nobody calls while it goes up$/);
  await scan(page, { call_up: 0 });
  assert.deepEqual(await of('.claim.broken', 'claim'), []);
  assert.equal(await page.$('[data-broken]'), null);
  // An assumption is about the inputs alone.
  await scan(page, { up: 1, down: 1 });
  assert.deepEqual(await of('.claim.broken', 'claim'), ['0']);
  assert.deepEqual(await of('.claim.reached', 'claim'), []);
  await scan(page, { up: 0, down: 0, call_down: 1 });
  assert.deepEqual(await of('.claim.broken', 'claim'), []);
  assert.deepEqual(await of('.claim.reached', 'claim'), ['3']);
  // The way back shows what was shown.
  await control(page, 'undo');
  await drawn(page);
  assert.deepEqual(await of('.claim.broken', 'claim'), ['0']);
  assert.deepEqual(await of('.claim.reached', 'claim'), []);
}

// What a drawing shows of orders, of a livelock, of presses and numbers, and of what is folded away.

import assert from 'node:assert/strict';
import { control, drawn, lit, scan, set } from './page.mjs';

export default async function play(page) {
  const of = (selector, name) => page.$$eval(selector, (all, name) => all.map((one) => one.dataset[name]), name);
  // Step 1 orders G2{12} while it is active.
  await scan(page, { m: 1 });
  assert.deepEqual(await lit(page), ['1', '12', '20', '30']);
  assert.deepEqual(await of('.transition.cleared', 'number'), ['1'], 'not the other one of this designation');
  assert.deepEqual(await of('.step.forced', 'step'), ['12']);
  assert.deepEqual(await of('.order.in-force', 'forces'), ['G2']);
  // Step 2 freezes it.
  await scan(page, { m: 0, n: 1 });
  assert.deepEqual(await lit(page), ['2', '12', '20', '30']);
  assert.deepEqual(await of('.frame.frozen', 'grafcet'), ['G2']);
  assert.deepEqual(await of('.order.in-force', 'order'), ['1']);
  assert.match(await page.textContent('#grafcets'), /\{12\} frozen/);
  await scan(page, { n: 0, p: 1 });
  assert.deepEqual(await of('.frame.frozen', 'grafcet'), []);
  // A number by its field and by its slider; the counter follows.
  await page.fill('[data-input="level"]', '70');
  await scan(page);
  assert.equal(await page.getAttribute('[data-output="high"]', 'data-value'), '1');
  await page.fill('[data-input="level"]', '70000');
  assert.equal(await page.getAttribute('[data-input="level"]', 'aria-invalid'), 'true');
  await page.locator('[data-slider="level"]').fill('10');
  await scan(page);
  assert.equal(await page.getAttribute('[data-output="high"]', 'data-value'), '0');
  // A press that is held lasts as long as it is held.
  const box = await page.locator('[data-input="p"]').boundingBox();
  await set(page, { p: 0 });
  await page.mouse.move(box.x + 20, box.y + 10);
  await page.mouse.down();
  assert.equal(await page.getAttribute('[data-input="p"]', 'aria-pressed'), 'true');
  await page.waitForTimeout(450);
  await page.mouse.up();
  assert.equal(await page.getAttribute('[data-input="p"]', 'aria-pressed'), 'false');
  // A livelock is told in words, with the ring that it goes round in.
  await scan(page, { round: 1 });
  assert.equal(await page.textContent('[data-flag="LIVELOCK"] b'), 'LIVELOCK');
  const ring = await page.textContent('[data-ring] bdi');
  assert.match(ring, /^\{[^}]*(30|31)[^}]*\} → \{[^}]*(30|31)[^}]*\} → \{[^}]*(30|31)[^}]*\}$/);
  assert.ok(ring.includes('30') && ring.includes('31'));
  // A grafcet folds to its name, and comes back.
  await page.click('[data-fold="G2"]');
  await drawn(page);
  assert.equal(await page.isVisible('[data-step="10"]'), false);
  assert.ok(await page.isVisible('.frame[data-grafcet="G2"] > .name'));
  await page.click('[data-fold="G2"]');
  assert.ok(await page.isVisible('[data-step="10"]'));
  // The drawing is enlarged, moved, and shown whole again.
  const view = () => page.getAttribute('.canvas svg', 'viewBox');
  const whole = await view();
  await control(page, 'zoom-in');
  assert.notEqual(await view(), whole);
  await control(page, 'fit');
  assert.equal(await view(), whole);
}

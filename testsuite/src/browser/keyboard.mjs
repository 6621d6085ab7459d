// Everything by the keyboard alone.

import assert from 'node:assert/strict';
import { drawn, lit, output } from './page.mjs';

export default async function play(page) {
  const { keyboard } = page;
  const focus = () => page.evaluate(() => {
    const { dataset, id, localName } = document.activeElement;
    return dataset.control ?? dataset.input ?? dataset.step ?? dataset.setting ?? (id || localName);
  });
  // Tab reaches each of these, in the order of the page.
  const seen = [];
  for (let at = 0; at < 60; at++) {
    await keyboard.press('Tab');
    seen.push(await focus());
  }
  const wanted = ['run', 'scan', 'micro-step', 'jump', 'speed', 'period', 'undo', 'replay', 'save-trace', 'load-trace', 'language', 'theme', 'CS', 'S0', '1', 'fit', 'breakpoint-add', 'canvas'];
  assert.deepEqual(wanted.filter((name) => !seen.includes(name)), [], `in ${seen.join(' ')}`);
  const places = wanted.map((name) => seen.indexOf(name));
  assert.deepEqual(places, [...places].sort((a, b) => a - b));
  // The space bar toggles inputs; S does a scan.
  for (const name of ['CS', 'z', 'S0']) {
    await page.focus(`[data-input="${name}"]`);
    await keyboard.press('Space');
  }
  await keyboard.press('s');
  await drawn(page);
  assert.equal(await output(page, 'VA'), '1');
  // A key for an input: it toggles, and holds while it is held.
  await page.focus('.input:has([data-input="a"]) .key');
  await keyboard.press('Enter');
  await keyboard.press('q');
  await keyboard.down('q');
  assert.equal(await page.getAttribute('[data-input="a"]', 'aria-pressed'), 'true');
  await page.waitForTimeout(450);
  await keyboard.up('q');
  assert.equal(await page.getAttribute('[data-input="a"]', 'aria-pressed'), 'false', 'a long press ends');
  await keyboard.press('q');
  assert.equal(await page.getAttribute('[data-input="a"]', 'aria-pressed'), 'true', 'a short one stays');
  await keyboard.press('s');
  await drawn(page);
  assert.equal(await output(page, 'VB'), '1');
  // In the drawing arrows go from part to part, and Enter sets a breakpoint.
  await page.focus('[data-step="1"]');
  await keyboard.press('ArrowDown');
  assert.equal(await page.evaluate(() => document.activeElement.dataset.transition), '1');
  await keyboard.press('Enter');
  assert.equal(await page.locator('#breakpoints li').count(), 1);
  await keyboard.press('Enter');
  assert.equal(await page.locator('#breakpoints li').count(), 0);
  // U takes back, one after another.
  await keyboard.press('u');
  await drawn(page);
  assert.equal(await output(page, 'VB'), '0');
  await keyboard.press('u');
  await drawn(page);
  assert.deepEqual(await lit(page), ['1', '9']);
  // Run and pause.
  await keyboard.press('r');
  await page.waitForTimeout(120);
  assert.equal(await page.getAttribute('[data-control="run"]', 'aria-pressed'), 'true');
  await keyboard.press('p');
  await drawn(page);
  assert.equal(await page.getAttribute('#state', 'data-state'), 'paused');
  // The cursor of the timing diagram goes from change to change.
  await page.focus('.wave canvas');
  await keyboard.press('Home');
  assert.match(await page.textContent('#cursor'), /^0\.000 s: .*G1 \{1\}/);
}

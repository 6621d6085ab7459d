// Light, dark, narrow, on paper, and in both languages.

import assert from 'node:assert/strict';
import { drawn } from './page.mjs';

export default async function play(page) {
  const brightness = () => page.evaluate(() => {
    const [red, green, blue] = getComputedStyle(document.body).backgroundColor.match(/\d+/g).map(Number);
    return (red + green + blue) / 3;
  });
  assert.ok((await brightness()) > 200);
  await page.emulateMedia({ colorScheme: 'dark' });
  assert.ok((await brightness()) < 60, 'as the system');
  await page.selectOption('[data-setting="theme"]', 'light');
  assert.ok((await brightness()) > 200, 'the switch counts for more');
  await page.emulateMedia({ colorScheme: 'light' });
  await page.selectOption('[data-setting="theme"]', 'dark');
  assert.ok((await brightness()) < 60);
  await page.emulateMedia({ media: 'print' });
  assert.ok((await brightness()) > 250, 'paper is white');
  assert.equal(await page.isVisible('[data-control="run"]'), false);
  assert.ok(await page.isVisible('.step.active .dot'), 'paper shows which steps are active');
  await page.emulateMedia({ media: 'screen' });
  await page.selectOption('[data-setting="theme"]', 'auto');
  for (const width of [1280, 800, 400, 320]) {
    await page.setViewportSize({ width, height: 800 });
    await drawn(page);
    assert.ok(await page.evaluate(() => document.documentElement.scrollWidth <= window.innerWidth), `nothing stands out at ${width}`);
    assert.ok(await page.isVisible('.step.active'));
  }
  await page.setViewportSize({ width: 1280, height: 800 });
  // Whatever has a word has it in German, and everything that can be used has a name.
  const unnamed = () => page.evaluate(() => [...document.querySelectorAll('button, select, input:not([type=file]), canvas, .step, .transition')]
    .filter((one) => !one.hidden && !(one.getAttribute('aria-label') || one.textContent.trim() || one.closest('label')?.textContent.trim()))
    .map((one) => one.outerHTML.slice(0, 100)));
  assert.deepEqual(await unnamed(), []);
  await page.selectOption('[data-setting="language"]', 'de');
  await drawn(page);
  const english = await page.evaluate(() => {
    const table = JSON.parse(document.getElementById('words-data').textContent);
    const wrong = [...document.querySelectorAll('[data-text]')].filter((one) => one.textContent !== table[one.dataset.text].de);
    return wrong.map((one) => one.dataset.text);
  });
  assert.deepEqual(english, []);
  assert.equal(await page.getAttribute('html', 'lang'), 'de');
  assert.match(await page.getAttribute('[data-step="1"].step', 'aria-label'), /^Schritt 1, .*aktiv/);
  assert.deepEqual(await unnamed(), []);
  await page.selectOption('[data-setting="language"]', 'en');
}

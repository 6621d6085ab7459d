// What a user does on a page, and what one sees.

import { readFile } from 'node:fs/promises';

/** Presses a button of the toolbar. */
export async function control(page, name) {
  await page.click(`[data-control="${name}"]`);
}

/** Waits until what has changed is drawn. */
export async function drawn(page) {
  await page.evaluate(() => new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(done))));
}

/** Sets inputs that are true or false. */
export async function set(page, inputs) {
  for (const [name, value] of Object.entries(inputs)) {
    const button = page.locator(`[data-input=${JSON.stringify(name)}]`);
    if ((await button.getAttribute('aria-pressed')) !== String(Boolean(value))) await button.click();
  }
}

/** Sets inputs and does a scan. */
export async function scan(page, inputs = {}) {
  await set(page, inputs);
  await control(page, 'scan');
  await drawn(page);
}

/** The labels of the steps that are lit, without those of macro-steps. */
export async function lit(page) {
  return page.$$eval('.step.active:not(.macro)', (steps) => steps.map((step) => step.dataset.step));
}

/** What an output shows. */
export async function output(page, name) {
  return page.getAttribute(`[data-output=${JSON.stringify(name)}]`, 'data-value');
}

/** All outputs that are true. */
export async function outputs(page) {
  return page.$$eval('[data-output][data-value="1"]', (items) => items.map((item) => item.dataset.output));
}

/** The text of a file that a button saves. */
export async function saved(page, name) {
  const waiting = page.waitForEvent('download');
  await control(page, name);
  return readFile(await (await waiting).path(), 'utf8');
}

/** Loads a text as a trace, by the button. */
export async function load(page, text) {
  const waiting = page.waitForEvent('filechooser');
  await control(page, 'load-trace');
  await (await waiting).setFiles({ name: 'trace.csv', mimeType: 'text/csv', buffer: Buffer.from(text) });
  await page.waitForFunction(() => document.getElementById('say').textContent !== '');
  await drawn(page);
}

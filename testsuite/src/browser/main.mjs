// Does jobs in one browser: each names a script beside this file, and a page. What fails is printed, and the end is 1.

import { readFileSync, mkdtempSync, rmSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { dirname, join } from 'node:path';
import { pathToFileURL } from 'node:url';

const { chromium } = await import(pathToFileURL(join(process.env.PLAYWRIGHT_CORE, 'index.mjs')));
const file = process.argv[2];
const jobs = JSON.parse(readFileSync(file, 'utf8'));
const profile = mkdtempSync(join(tmpdir(), 'grafc-browser-'));
const context = await chromium.launchPersistentContext(profile, {
  executablePath: process.env.CHROMIUM,
  headless: true,
  viewport: { width: 1280, height: 800 },
  acceptDownloads: true,
  args: ['--no-sandbox', '--disable-gpu', '--disable-quic', '--no-first-run', '--disable-background-networking', '--disable-component-update', '--disable-sync'],
});
let failed = 0;
for (const job of jobs) {
  const page = await context.newPage();
  page.setDefaultTimeout(8000);
  const faults = [];
  page.on('pageerror', (error) => faults.push(`error on the page: ${error.message}`));
  page.on('console', (message) => message.type() === 'error' && faults.push(`console: ${message.text()}`));
  // Nobody is asked for anything but the page itself.
  page.on('request', (request) => !/^(file|blob|data):/.test(request.url()) && faults.push(`asked for ${request.url()}`));
  const started = performance.now();
  try {
    const { default: play } = await import(`./${job.do}.mjs`);
    await page.goto(pathToFileURL(join(dirname(file), job.page)).href);
    const said = await play(page, job, context);
    if (faults.length) throw new Error(faults.join('\n'));
    console.log(`${job.do} ${job.page}: ok in ${Math.round(performance.now() - started)} ms${said ? `: ${said}` : ''}`);
  } catch (error) {
    failed += 1;
    console.error(`${job.do} ${job.page}: ${error.stack}\n${faults.join('\n')}`);
  }
  await page.close();
}
await context.close();
rmSync(profile, { recursive: true, force: true });
process.exit(failed ? 1 : 0);

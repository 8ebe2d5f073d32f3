// npm run shots: a screenshot of every example, in each theme and on a phone, into
// test-results/shots, for people to look at.
import { mkdirSync } from 'node:fs';
import { chromium } from '@playwright/test';
import { GALLERY } from '../src/state/gallery/index.ts';
import { countPending, frames, framesDone } from './browser/support/pending.ts';
import { serveSite } from './serve-site.ts';

const LOOKS = [
  { name: 'light', theme: 'light', width: 1280, height: 720 },
  { name: 'dark', theme: 'dark', width: 1280, height: 720 },
  { name: 'projector', theme: 'projector', width: 1280, height: 720 },
  { name: 'phone', theme: 'light', width: 390, height: 844 },
] as const;

const [wanted = ''] = process.argv.slice(2);
mkdirSync('test-results/shots', { recursive: true });
const site = await serveSite();
// @ts-expect-error: a plain script, shared with the tests' runner.
const { ensureChromium, args } = await import('./browser.mjs');
const { executablePath } = await ensureChromium();
const browser = await chromium.launch({ args, ...(executablePath && { executablePath }) });
let taken = 0;
for (const { name, theme, width, height } of LOOKS) {
  const page = await browser.newPage({ viewport: { width, height } });
  await page.addInitScript(countPending);
  await page.addInitScript((t) => localStorage.setItem('graze.theme', t), theme);
  await page.goto(site.url);
  await page.waitForSelector('.scene-area canvas');
  for (const { id, link } of GALLERY.filter((example) => example.id.includes(wanted))) {
    await page.evaluate((hash) => {
      location.hash = hash;
    }, link);
    await frames(page, 2);
    await framesDone(page);
    taken++;
    await page.screenshot({ path: `test-results/shots/${id}-${name}.png` });
  }
  await page.close();
}
await browser.close();
site.close();
console.log(`${taken} pictures in test-results/shots`);

// What the page costs: the size of each built chunk, and the script time of one slider step in a
// real browser.
import { readdirSync, readFileSync } from 'node:fs';
import { join } from 'node:path';
import { chromium, type Page } from '@playwright/test';
import { firstLoad, packed } from '../first-load.ts';
import { serveSite } from '../serve-site.ts';

const SITE = 'dist/site';
const STEPS = 60;
const site = await serveSite();
sizes();
const browser = await launch();
const page = await browser.newPage({ viewport: { width: 1280, height: 720 } });
await sliderSteps(page, site.url);
await browser.close();
site.close();

function sizes(): void {
  console.log('| chunk | kB | kB gz |\n|---|---:|---:|');
  for (const name of readdirSync(join(SITE, 'assets')).sort()) {
    const bytes = readFileSync(join(SITE, 'assets', name));
    const sent = name.endsWith('.woff2') ? bytes.length : packed(bytes);
    console.log(`| ${name} | ${kB(bytes.length)} | ${kB(sent)} |`);
  }
  const first = [...firstLoad(SITE).values()].reduce((sum, size) => sum + size, 0);
  console.log(`\nFirst load: ${kB(first)} kB gz of scripts`);
}

function kB(bytes: number): string {
  return (bytes / 1000).toFixed(1);
}

async function launch() {
  // @ts-expect-error: a plain script, shared with the tests' runner.
  const { ensureChromium, args } = await import('../../tests/browser.mjs');
  const { executablePath } = await ensureChromium();
  return chromium.launch({ args, ...(executablePath && { executablePath }) });
}

/**
 * The page itself reports how long a step's script took (performance.measure 'graze step'): state
 * to numbers, formulas, plot.
 */
async function sliderSteps(target: Page, url: string): Promise<void> {
  await target.goto(url);
  await target.waitForFunction(() => document.querySelector('.scene-area canvas') !== null);
  const slider = target.getByLabel('c, slider');
  await slider.focus();
  for (let i = 0; i < STEPS; i++) {
    await target.keyboard.press(i % 20 < 10 ? 'ArrowRight' : 'ArrowLeft');
    await target.evaluate(() => new Promise(requestAnimationFrame));
  }
  const found = await target.evaluate(() =>
    ['graze step', 'graze scene'].map((name) => ({
      name,
      ms: performance
        .getEntriesByName(name)
        .map(({ duration }) => duration)
        .slice(10)
        .sort((a, b) => a - b),
    })),
  );
  console.log(
    '\n| script time of a slider step | least ms | median ms | quartiles | steps |\n' +
      '|---|---:|---:|---|---:|',
  );
  for (const { name, ms } of found) {
    const at = (share: number): string =>
      (ms[Math.floor(share * ms.length)] ?? Number.NaN).toFixed(2);
    const label = name === 'graze step' ? 'numbers, formulas, plot' : 'scene';
    console.log(`| ${label} | ${at(0)} | ${at(0.5)} | ${at(0.25)}–${at(0.75)} | ${ms.length} |`);
  }
}

// What the page costs: the size of each built chunk, and the script time of one slider step in a real browser.
import { readdirSync, readFileSync, statSync } from 'node:fs';
import { createServer } from 'node:http';
import { extname, join } from 'node:path';
import { gzipSync } from 'node:zlib';
import { chromium, type Page } from '@playwright/test';
import { build } from 'vite';

const SITE = 'dist/site';
const STEPS = 60;
const TYPES: Readonly<Record<string, string>> = {
  '.html': 'text/html',
  '.js': 'text/javascript',
  '.css': 'text/css',
  '.woff2': 'font/woff2',
};

await build({ logLevel: 'warn' });
sizes();
const server = serve();
const browser = await launch();
const { port } = server.address() as { port: number };
const page = await browser.newPage({ viewport: { width: 1280, height: 720 } });
await sliderSteps(page, `http://127.0.0.1:${port}/`);
await browser.close();
server.close();

function sizes(): void {
  console.log('| chunk | kB | kB gz |\n|---|---:|---:|');
  for (const name of readdirSync(join(SITE, 'assets')).sort()) {
    const bytes = readFileSync(join(SITE, 'assets', name));
    const packed = name.endsWith('.woff2') ? bytes.length : gzipSync(bytes, { level: 9 }).length;
    console.log(`| ${name} | ${kB(bytes.length)} | ${kB(packed)} |`);
  }
}

function kB(bytes: number): string {
  return (bytes / 1000).toFixed(1);
}

function serve() {
  return createServer((request, response) => {
    const path = (request.url ?? '/').split('?')[0] ?? '/';
    const file = join(SITE, path === '/' ? 'index.html' : path);
    try {
      statSync(file);
      response.setHeader('Content-Type', TYPES[extname(file)] ?? 'application/octet-stream');
      response.setHeader('Cross-Origin-Opener-Policy', 'same-origin');
      response.setHeader('Cross-Origin-Embedder-Policy', 'require-corp');
      response.end(readFileSync(file));
    } catch {
      response.statusCode = 404;
      response.end();
    }
  }).listen(0, '127.0.0.1');
}

async function launch() {
  // @ts-expect-error: a plain script, shared with the tests' runner.
  const { ensureChromium, args } = await import('../../tests/browser.mjs');
  const { executablePath } = await ensureChromium();
  return chromium.launch({ args, ...(executablePath && { executablePath }) });
}

/** The page itself reports how long a step's script took (performance.measure 'graze step'): state to numbers, formulas, plot. */
async function sliderSteps(target: Page, url: string): Promise<void> {
  await target.goto(url);
  await target.waitForFunction(() => document.querySelector('.scene-area canvas') !== null);
  const slider = target.getByLabel('c, slider');
  await slider.focus();
  for (let i = 0; i < STEPS; i++) {
    await target.keyboard.press(i % 20 < 10 ? 'ArrowRight' : 'ArrowLeft');
    await target.waitForTimeout(20);
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
    '\n| script time of a slider step | median ms | quartiles | steps |\n|---|---:|---|---:|',
  );
  for (const { name, ms } of found) {
    const at = (share: number): string =>
      (ms[Math.floor(share * ms.length)] ?? Number.NaN).toFixed(2);
    const label = name === 'graze step' ? 'numbers, formulas, plot' : 'scene';
    console.log(`| ${label} | ${at(0.5)} | ${at(0.25)}–${at(0.75)} | ${ms.length} |`);
  }
}

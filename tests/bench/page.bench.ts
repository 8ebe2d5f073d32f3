// What the page costs: the size of each built chunk, the script time of one slider step in a real
// browser, pictures a second while a hand turns the camera of Picture, and how long after a scene
// was opened its picture has stairs. `--scenes plain,mirror --seconds 2` for fewer and a shorter
// drag, of the first of them.
import { readdirSync, readFileSync } from 'node:fs';
import { join } from 'node:path';
import { chromium, type Page } from '@playwright/test';
import { EDGE_RAYS, EDGES } from '../../src/pages/picture/refiner.ts';
import { PRESETS } from '../../src/scene/presets/index.ts';
import { firstLoad, packed } from '../first-load.ts';
import { serveSite } from '../serve-site.ts';

const SITE = 'dist/site';
const STEPS = 60;
const option = (name: string): string | undefined => {
  const at = process.argv.indexOf(`--${name}`);
  return at < 0 ? undefined : process.argv[at + 1];
};
const scenes = option('scenes')?.split(',') ?? PRESETS.map(({ id }) => id);
const unknown = scenes.filter((one) => !PRESETS.some(({ id }) => id === one));
if (unknown.length > 0) throw new RangeError(`no scene ${unknown}`);
const dragged = scenes.includes('everything') ? 'everything' : (scenes[0] ?? '');
const DRAG_MS = 1000 * Number(option('seconds') ?? 6);
if (!(DRAG_MS > 1000)) throw new RangeError(`--seconds must be above 1, got ${option('seconds')}`);
const site = await serveSite();
sizes();
const browser = await launch();
const page = await browser.newPage({ viewport: { width: 1280, height: 720 } });
await sliderSteps(page, site.url);
await cameraDrag(await browser.newPage({ viewport: { width: 1280, height: 720 } }), site.url);
await stairs(site.url);
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

/** Every picture that is painted while a mouse goes to and fro without a pause. */
async function cameraDrag(target: Page, url: string): Promise<void> {
  await target.addInitScript(() => {
    const painted: [number, string][] = [];
    const put = CanvasRenderingContext2D.prototype.putImageData;
    CanvasRenderingContext2D.prototype.putImageData = function (
      this: CanvasRenderingContext2D,
      data: ImageData,
      ...rest: never[]
    ) {
      const of = `${data.width} × ${data.height}`;
      if (this.canvas.className === 'traced') painted.push([performance.now(), of]);
      return (put as (...all: unknown[]) => void).call(this, data, ...rest);
    } as typeof put;
    Object.assign(globalThis, { painted });
  });
  await target.goto(`${url}#/picture?scene=${dragged}`);
  await target.locator('.picture[data-trace="finished"]').waitFor({ timeout: 600_000 });
  const box = await target.locator('.picture-frame').boundingBox();
  if (!box) throw new Error('no picture');
  const [x, y] = [box.x + box.width / 3, box.y + box.height / 3];
  await target.mouse.move(x, y);
  await target.mouse.down();
  const begun = await target.evaluate(() => performance.now());
  const start = Date.now();
  for (let at = 0; at < DRAG_MS; at = Date.now() - start) {
    const turn = at / 800;
    await target.mouse.move(x + 100 * Math.sin(turn), y + 30 * Math.sin(0.7 * turn));
  }
  const all = await target.evaluate(() => (globalThis as unknown as Painted).painted);
  const says = await target.locator('[data-quantity="resolution"]').innerText();
  await target.mouse.up();
  // The first second finds the size.
  const steady = all.filter(([at]) => at > begun + 1000 && at < begun + DRAG_MS);
  const rate = (1000 * steady.length) / (DRAG_MS - 1000);
  const sizes = [...new Set(steady.map(([, of]) => of))].join(', ');
  console.log(
    `\n| turning the camera of ${dragged}, 752 × 424 | pictures a second | sizes | ledger |\n` +
      `|---|---:|---|---|\n| ${DRAG_MS / 1000} s | ${rate.toFixed(1)} | ${sizes} | ${says} |`,
  );
}

/**
 * Steep edges have got more rays when the line over the picture names some for them: after a scene
 * was opened, and again after a key has turned its camera.
 */
async function stairs(url: string): Promise<void> {
  console.log(
    '\n| scene, 752 × 424 | its picture stands after ms | pixels that differ by more than ' +
      `${EDGES[0]} levels from one beside them have ${EDGE_RAYS} rays after ms | and after a key ` +
      'that turns the camera |\n|---|---:|---:|---:|',
  );
  for (const id of scenes) {
    const context = await browser.newContext({ viewport: { width: 1280, height: 720 } });
    const target = await context.newPage();
    await target.addInitScript(() => {
      const seen: Partial<Seen> = {};
      const stamp = (key: keyof Seen, is: boolean): void => {
        if (is) seen[key] ??= performance.now();
      };
      const has = (selector: string): boolean => document.querySelector(selector) !== null;
      new MutationObserver(() => {
        const smooth = has('[data-quantity="rest"][data-edges]');
        stamp('begun', has('.picture[data-trace]:not([data-trace="waiting"])'));
        stamp('stands', has('.picture[data-trace="finished"]'));
        stamp('smooth', smooth);
        stamp('moves', seen.key !== undefined && !smooth);
        stamp('smoothAgain', seen.moves !== undefined && smooth);
      }).observe(document, { subtree: true, childList: true, attributes: true });
      addEventListener('keydown', () => stamp('key', true), true);
      Object.assign(globalThis, { seen });
    });
    await target.goto(`${url}#/picture?scene=${id}`);
    await target.locator('[data-quantity="rest"][data-edges]').waitFor({ timeout: 600_000 });
    await target.getByRole('application').focus();
    await target.keyboard.press('Shift+ArrowRight');
    await target.waitForFunction(
      () => (globalThis as unknown as { seen: Partial<Seen> }).seen.smoothAgain,
      undefined,
      { polling: 200, timeout: 600_000 },
    );
    const { begun, stands, smooth, key, smoothAgain } = await target.evaluate(
      () => (globalThis as unknown as { seen: Seen }).seen,
    );
    const ms = [stands - begun, smooth - begun, smoothAgain - key].map((one) => one.toFixed());
    console.log(`| ${id} | ${ms.join(' | ')} |`);
    await context.close();
  }
}

/** When in ms of the page. */
interface Seen {
  begun: number;
  stands: number;
  smooth: number;
  key: number;
  moves: number;
  smoothAgain: number;
}

interface Painted {
  readonly painted: readonly (readonly [number, string])[];
}

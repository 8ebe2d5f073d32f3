import { readFileSync } from 'node:fs';
import type { Page } from '@playwright/test';
import { createDerive } from '../../src/state/derive.ts';
import { exploreDetails } from '../../src/state/explore-details.ts';
import { EXPORTS } from '../../src/state/exports/index.ts';
import { GALLERY } from '../../src/state/gallery/index.ts';
import { decode } from '../../src/state/url.ts';
import { expectSaid, hashOf, linkWritten, open, problems, settle } from './support/page.ts';
import { expect, visit as test } from './support/test.ts';

test.describe.configure({ mode: 'default' });

test.use({
  viewport: { width: 1000, height: 680 },
  permissions: ['clipboard-read', 'clipboard-write'],
});

const LINK = '#/explore?shape=cone&V=0,3,0&c=0.5&E=3,1,1&d=-0.8,-0.2,-0.3&method=textbook';

async function openShare(page: Page) {
  await page.keyboard.press('e');
  const dialog = page.getByRole('dialog', { name: 'File and export' });
  await dialog.locator('[data-export]').first().waitFor();
  return dialog;
}

async function saved(page: Page, id: string): Promise<Buffer> {
  const dialog = await openShare(page);
  const [download] = await Promise.all([
    page.waitForEvent('download'),
    dialog.locator(`[data-export="${id}"]`).getByRole('button', { name: /^Save/ }).click(),
  ]);
  return readFileSync(await download.path());
}

test('what is copied is what the page shows, for every text', async ({ page }) => {
  await open(page, LINK);
  const model = createDerive()(decode(await hashOf(page)));
  for (const { id, title, text } of EXPORTS) {
    const dialog = await openShare(page);
    await dialog.locator(`[data-export="${id}"]`).getByRole('button', { name: /^Copy/ }).click();
    await expectSaid(page, `copied: ${title}`);
    expect(await page.evaluate(() => navigator.clipboard.readText()), id).toBe(text(model));
  }
});

test('GLSL compiles in WebGL2, for every example', async ({ page }) => {
  await open(page, LINK);
  const glsl = EXPORTS.find(({ id }) => id === 'glsl');
  const curved = '#/explore?shape=cone&between=-1,2&caps=1';
  const programs = [...GALLERY, { id: 'ends', link: curved }].map(({ id, link }) => [
    id,
    glsl?.text(createDerive(() => exploreDetails)(decode(link))) ?? '',
  ]);
  const faults = await page.evaluate((list) => {
    const gl = document.createElement('canvas').getContext('webgl2');
    if (!gl) return ['no WebGL2'];
    return list.flatMap(([id = '', body = '']) => {
      const head = body.includes('#version') ? '' : '#version 300 es\nprecision highp float;\n';
      const tail = body.includes('void main')
        ? ''
        : '\nout vec4 colour;\nvoid main() { colour = vec4(1.0); }';
      const shader = gl.createShader(gl.FRAGMENT_SHADER);
      if (!shader) return ['no shader'];
      gl.shaderSource(shader, head + body + tail);
      gl.compileShader(shader);
      const good = gl.getShaderParameter(shader, gl.COMPILE_STATUS);
      return good ? [] : [`${id}: ${gl.getShaderInfoLog(shader)}\n${head + body + tail}`];
    });
  }, programs);
  expect(faults).toEqual([]);
});

test('a saved state opens again, by dialog and by dropping it on the page', async ({ page }) => {
  await open(page, '#/explore?shape=square&P=1/3,0,-1&L=2&E=3,1,0.7&d=-1,0,0&method=exact');
  await expect.poll(() => hashOf(page)).not.toContain('L=2');
  const link = await hashOf(page);
  const [download] = await Promise.all([page.waitForEvent('download'), page.keyboard.press('s')]);
  expect(download.suggestedFilename()).toBe('graze.json');
  const path = await download.path();
  // Listening from early on: the browser has to be told that a program answers its dialogs.
  page.on('filechooser', (chooser) => void chooser.setFiles(path));
  await open(page, LINK);
  await expect.poll(() => hashOf(page)).toContain('method=textbook');
  await expect(async () => {
    await page.keyboard.press('o');
    await expect.poll(() => hashOf(page), { timeout: 4000 }).toBe(link);
  }).toPass();
  await open(page, LINK);
  await drop(page, readFileSync(path, 'utf8'));
  await expect.poll(() => hashOf(page)).toBe(link);
});

test('a file that is none of ours is refused in words, and nothing is lost', async ({ page }) => {
  await open(page, LINK);
  await linkWritten(page);
  const before = await hashOf(page);
  await drop(page, '<b>not a state</b>');
  const alert = problems(page);
  await expect(alert).toContainText("'<b>not a state</b>' is not a saved state");
  expect(await hashOf(page)).toBe(before);
  await page.getByRole('button', { name: 'Dismiss' }).click();
  await settle(page);
  await expect(alert).toHaveCount(0);
});

test.describe('with the picture', () => {
  test.use({ ink: true });

  test('the graph as SVG and the picture as PNG are whole', async ({ page }) => {
    await open(page, LINK);
    await page.locator('canvas').waitFor();
    const drawing = (await saved(page, 'graph-svg')).toString('utf8');
    expect(drawing).toMatch(/^<svg[^>]*xmlns="http:\/\/www.w3.org\/2000\/svg"/);
    expect(drawing).not.toMatch(/NaN|var\(--|undefined/);
    const png = await saved(page, 'picture-png');
    expect(png.subarray(1, 4).toString()).toBe('PNG');
    expect(await colours(page, png.toString('base64'))).toBeGreaterThan(200);
  });
});

/** How many different colours a picture has: a blank one has one. */
function colours(page: Page, base64: string): Promise<number> {
  return page.evaluate(async (data) => {
    const image = new Image();
    image.src = `data:image/png;base64,${data}`;
    await image.decode();
    const context = new OffscreenCanvas(image.width, image.height).getContext('2d');
    context?.drawImage(image, 0, 0);
    const pixels = context?.getImageData(0, 0, image.width, image.height).data ?? [];
    const seen = new Set<number>();
    for (let i = 0; i < pixels.length; i += 4) {
      seen.add(((pixels[i] ?? 0) << 16) | ((pixels[i + 1] ?? 0) << 8) | (pixels[i + 2] ?? 0));
    }
    return seen.size;
  }, base64);
}

async function drop(page: Page, text: string): Promise<void> {
  await page.evaluate((content) => {
    const dataTransfer = new DataTransfer();
    dataTransfer.items.add(new File([content], 'graze.json', { type: 'application/json' }));
    const event = new DragEvent('drop', { dataTransfer, bubbles: true, cancelable: true });
    document.body.dispatchEvent(event);
  }, text);
}

import { readFileSync } from 'node:fs';
import type { Locator, Page } from '@playwright/test';
import { byTurns } from '../unit/many.ts';
import { hashOf, linkWritten, open, quantities, settle } from './support/page.ts';
import { frames } from './support/pending.ts';
import { drawn, still } from './support/scene.ts';
import { expect, visit as test } from './support/test.ts';

test.use({ viewport: { width: 1280, height: 720 } });
test.describe.configure({ mode: 'default' });

const START = '#/explore?shape=cone&method=exact';
const VIEWS = ['iso', 'top', 'front', 'side', '-50,40,1.5'];
const E = ['E.x', 'E.y', 'E.z'];
const d = ['d.x', 'd.y', 'd.z'];
const V = ['V.x', 'V.y', 'V.z'];

interface Spot {
  readonly x: number;
  readonly y: number;
}

const handle = (page: Page, symbol: string): Locator =>
  page.locator(`[role="slider"][data-handle="${symbol}"]`);
const words = (page: Page): Locator => page.locator('.scene-tone-words');

async function openScene(page: Page, hash = START): Promise<void> {
  await open(page, hash);
  await page.locator('.scene-handle').first().waitFor();
  await still(page);
}

/** Where a mark or a handle is on the page, by its own translation. */
async function spotOf(target: Locator): Promise<Spot> {
  const place = await target.evaluate((g) => {
    const [, x, y] = /translate\((\S+) (\S+)\)/.exec(g.getAttribute('transform') ?? '') ?? [];
    const box = (g as SVGGraphicsElement).ownerSVGElement?.getBoundingClientRect();
    return { x: Number(x) + (box?.left ?? 0), y: Number(y) + (box?.top ?? 0) };
  });
  expect(Number.isFinite(place.x + place.y)).toBe(true);
  return place;
}

/** Presses at a spot and moves; the button stays down. */
async function drag(page: Page, from: Spot, dx: number, dy: number, steps = 8): Promise<void> {
  await page.mouse.move(from.x, from.y);
  await page.mouse.down();
  await page.mouse.move(from.x + dx, from.y + dy, { steps });
  await settle(page);
}

async function values(page: Page, names: readonly string[]): Promise<number[]> {
  const shown = await quantities(page);
  return names.map((name) => Number(shown[name]));
}

for (const view of byTurns(VIEWS)) {
  test(`E and the tip of d follow the mouse in the view ${view}`, async ({ page }) => {
    await openScene(page, `${START}&view=${view}`);
    for (const [symbol, names] of [
      ['E', E],
      ['d', d],
    ] as const) {
      const mark = page.locator(`[data-mark="${symbol}"]`);
      const from = await spotOf(mark);
      const before = await values(page, names);
      // Alt: no grid, nothing snaps.
      await page.keyboard.down('Alt');
      await drag(page, await spotOf(handle(page, symbol)), 47, -33);
      const to = await spotOf(mark);
      expect(Math.hypot(to.x - from.x - 47, to.y - from.y + 33), symbol).toBeLessThan(2);
      await page.mouse.up();
      await page.keyboard.up('Alt');
      expect(await values(page, names)).not.toEqual(before);
      await still(page);
    }
  });
}

test('without Alt a drag stays on the grid of the sliders; Shift leaves it at once', async ({
  page,
}) => {
  await openScene(page, '#/explore?shape=plane&method=exact');
  await drag(page, await spotOf(handle(page, 'E')), -61, 23);
  const there = await values(page, E);
  for (const x of there) expect(x).toBe(Number(x.toFixed(1)));
  await page.keyboard.down('Shift');
  await settle(page);
  const fine = await values(page, E);
  expect(fine).not.toEqual(there);
  for (const x of fine) expect(x).toBe(Number(x.toFixed(3)));
  await page.mouse.up();
  await page.keyboard.up('Shift');
});

test('a drag is one step of undo, and Escape goes back to where it began', async ({ page }) => {
  await openScene(page);
  const before = await values(page, E);
  await drag(page, await spotOf(handle(page, 'E')), -40, -50);
  await page.mouse.up();
  const after = await values(page, E);
  expect(after).not.toEqual(before);
  await page.keyboard.press('Control+z');
  await settle(page);
  expect(await values(page, E)).toEqual(before);
  await page.keyboard.press('Control+Shift+z');
  await settle(page);
  expect(await values(page, E)).toEqual(after);
  await still(page);
  await drag(page, await spotOf(handle(page, 'V')), 60, 40);
  expect(await values(page, V)).not.toEqual([0, 3, 0]);
  await page.keyboard.press('Escape');
  await settle(page);
  expect(await values(page, V)).toEqual([0, 3, 0]);
  await page.mouse.move(300, 300);
  await settle(page);
  expect(await values(page, V), 'the drag is over').toEqual([0, 3, 0]);
  await page.mouse.up();
});

test('an arrow of an axis moves one component only', async ({ page }) => {
  await openScene(page, `${START}&E=2.97,1.03,0.98`);
  for (const i of [0, 1, 2]) {
    const { x, y } = await spotOf(handle(page, 'E'));
    await page.mouse.move(5, 5);
    await page.mouse.move(x, y);
    const arm = page.locator(`.axis-arrow-hit[data-axis="${i}"]`);
    await expect(arm).toBeAttached();
    const box = await arm.boundingBox();
    if (!box) throw new Error('no arrow');
    const before = await values(page, E);
    await page.keyboard.down('Alt');
    await drag(page, { x: box.x + box.width / 2, y: box.y + box.height / 2 }, 40, -25);
    await page.mouse.up();
    await page.keyboard.up('Alt');
    const after = await values(page, E);
    const moved = after.map((value, k) => value !== before[k]);
    expect(moved).toEqual([i === 0, i === 1, i === 2]);
    await still(page);
  }
});

test('keys move a focused handle, along all three axes and in fine steps', async ({ page }) => {
  await openScene(page);
  const eye = handle(page, 'E');
  await expect(eye).toHaveAttribute('aria-label', /^E, eye/);
  await expect(eye).toHaveAttribute('aria-valuetext', '(3, 1, 1)');
  await eye.focus();
  for (const key of ['ArrowLeft', 'ArrowUp', 'ArrowUp', 'PageDown', 'Shift+ArrowRight']) {
    await page.keyboard.press(key);
    await settle(page);
  }
  expect(await values(page, E)).toEqual([2.91, 1.2, 0.9]);
  await expect(eye).toHaveAttribute('aria-valuetext', '(2.91, 1.2, 0.9)');
  await expect(eye).toBeFocused();
  await handle(page, 'c').focus();
  await page.keyboard.press('ArrowRight');
  await settle(page);
  expect(await values(page, ['c'])).toEqual([0.52]);
  const ring = handle(page, 'c').locator('.scene-focus');
  expect(await ring.evaluate((circle) => getComputedStyle(circle).stroke)).not.toBe('none');
});

test('what the math module refuses is not taken, and the reason is said', async ({ page }) => {
  await openScene(page, '#/explore?shape=cylinder&r=0.05&method=exact');
  await handle(page, 'r').focus();
  await page.keyboard.press('ArrowLeft');
  await settle(page);
  await page.keyboard.press('ArrowLeft');
  await settle(page);
  expect(await values(page, ['r'])).toEqual([0]);
  await expect(words(page)).toHaveText(/radius must be ≥ 0/);
  await open(page, '#/explore?shape=cone&E=0,0,0&d=0.05,0,0&method=exact');
  await still(page);
  await handle(page, 'd').focus();
  await page.keyboard.press('ArrowLeft');
  await settle(page);
  expect(await values(page, d), 'd is never zero').toEqual([0.05, 0, 0]);
  await expect(words(page)).toHaveText(/direction/);
});

test('tangency is found, said, held, left, and suspended by Alt', async ({ page }) => {
  const side = 'shape=cylinder&C=0,1,0&r=1&E=3,1,1.5&d=-1,0,0&view=top';
  await openScene(page, `#/explore?${side}&method=exact`);
  // From above z points down: 1.5 is a miss, 1 touches.
  const from = await spotOf(handle(page, 'E'));
  await page.mouse.move(from.x, from.y);
  await page.mouse.down();
  let [entered, left] = [0, 0];
  for (let k = 1; k < 90 && !left; k++) {
    await page.mouse.move(from.x, from.y - k);
    await settle(page);
    const said = await words(page).allTextContents();
    if (said[0] === 'snapped: tangent') {
      entered ||= k;
      expect((await quantities(page)).class).toBe('tangent');
      expect(await values(page, ['E.z', 'D'])).toEqual([1, 0]);
    } else if (entered) left = k;
  }
  expect(entered).toBeGreaterThan(0);
  // Taken 8 pixels before it, let go 13 behind it.
  expect(Math.abs(left - entered - 21)).toBeLessThanOrEqual(2);
  await page.mouse.move(from.x, from.y - left + 8);
  await settle(page);
  await expect(words(page)).toHaveText('snapped: tangent');
  await page.keyboard.down('Alt');
  await settle(page);
  await expect(words(page)).toHaveCount(0);
  expect((await quantities(page)).class).not.toBe('tangent');
  await page.mouse.up();
  await page.keyboard.up('Alt');
});

test('a radius that no double makes tangent is said to be near only', async ({ page }) => {
  await openScene(page, '#/explore?shape=cylinder&r=1.5&E=3,1,1&d=-1,0,-0.3&method=exact');
  const from = await spotOf(handle(page, 'r'));
  await page.mouse.move(from.x, from.y);
  await page.mouse.down();
  const said = new Set<string>();
  for (let k = 1; k < 140; k += 3) {
    await page.mouse.move(from.x - k, from.y);
    await settle(page);
    for (const text of await words(page).allTextContents()) said.add(text);
  }
  await page.mouse.up();
  expect([...said]).toContain('snapped: as near tangent as doubles come');
});

test('hidden results are not given away by snapping', async ({ page }) => {
  await openScene(page, '#/explore?shape=cylinder&r=1.5&E=3,1,1&d=-1,0,-0.3&method=exact');
  await page.keyboard.press('h');
  await still(page);
  const from = await spotOf(handle(page, 'r'));
  await page.mouse.move(from.x, from.y);
  await page.mouse.down();
  for (let k = 1; k < 140; k += 5) {
    await page.mouse.move(from.x - k, from.y);
    await settle(page);
    for (const text of await words(page).allTextContents()) expect(text).not.toContain('tangent');
  }
  await page.mouse.up();
  await page.keyboard.press('h');
});

test('d snaps to the directions of the axes', async ({ page }) => {
  await openScene(page, '#/explore?shape=plane&d=-0.8,-0.2,0&view=front&method=exact');
  await drag(page, await spotOf(handle(page, 'd')), 0, -14);
  await expect(words(page)).toHaveText('snapped: parallel to x');
  const [x = 0, ...rest] = await values(page, d);
  expect(rest).toEqual([0, 0]);
  expect(x).toBeLessThan(-0.5);
  await page.mouse.up();
});

const OF_SHAPES = [
  ['plane', ['P'], []],
  ['cylinder', ['C'], ['r']],
  ['cone', ['V'], ['c']],
  ['hyperboloid', ['C'], ['a', 'r']],
  ['circle', ['C'], ['r']],
  ['square', ['P'], ['L']],
] as const;

for (const [turn, [kind, points, lengths]] of OF_SHAPES.entries()) {
  test(`the handles of the ${kind} are dragged`, async ({ page }) => {
    for (const view of byTurns(['iso', 'side'], turn)) {
      for (const symbol of [...points, ...lengths]) {
        await open(page, `#/explore?shape=${kind}&view=${view}&method=exact`);
        await still(page);
        const target = handle(page, symbol);
        const from = await spotOf(target);
        const before = await target.getAttribute('aria-valuetext');
        await page.keyboard.down('Alt');
        await drag(page, from, 31, 3);
        const to = await spotOf(target);
        await page.mouse.up();
        await page.keyboard.up('Alt');
        const name = `${symbol} in ${view}`;
        expect(await target.getAttribute('aria-valuetext'), name).not.toBe(before);
        const off = Math.hypot(to.x - from.x - 31, to.y - from.y - 3);
        // A point goes with the mouse; a radius along its own line, which may be steep on the
        // screen.
        const isPoint = points.some((point) => point === symbol);
        expect(off, name).toBeLessThan(isPoint ? 2 : 32);
      }
    }
  });
}

test('far out of the picture a drag stays finite, and the rest of the picture where it is', async ({
  page,
}) => {
  await openScene(page);
  const vertex = page.locator('[data-mark="V"]');
  const before = await vertex.getAttribute('transform');
  await drag(page, await spotOf(handle(page, 'E')), 640, 380, 20);
  expect(await vertex.getAttribute('transform')).toBe(before);
  for (const x of await values(page, E)) expect(Math.abs(x)).toBeLessThan(50);
  await page.mouse.up();
  await still(page);
  expect(await vertex.getAttribute('transform'), 'then there is room for all').not.toBe(before);
  expect(await page.locator('.scene-root').innerHTML()).not.toMatch(/NaN|Infinity/);
});

test('no arrow is offered along the line of sight, and a key still moves there', async ({
  page,
}) => {
  await openScene(page, '#/explore?shape=cone&E=0,1.2,1&view=front&method=exact');
  // After the pointer the page keys are a clicker's, until one moves the focus.
  await page.keyboard.press('Tab');
  await handle(page, 'E').focus();
  await settle(page);
  await expect(page.locator('.axis-arrow-hit[data-axis="0"]')).toBeAttached();
  await expect(page.locator('.axis-arrow-hit[data-axis="2"]')).toHaveCount(0);
  await page.keyboard.press('PageUp');
  await settle(page);
  expect(await values(page, E)).toEqual([0, 1.2, 1.1]);
});

test('in the view along the ray E can be dragged too', async ({ page }) => {
  await openScene(page, `${START}&view=ray`);
  const from = await spotOf(handle(page, 'E'));
  await page.keyboard.down('Alt');
  await drag(page, from, 60, -40);
  const to = await spotOf(handle(page, 'E'));
  expect(Math.hypot(to.x - from.x - 60, to.y - from.y + 40)).toBeLessThan(2);
  await page.mouse.up();
  await page.keyboard.up('Alt');
});

test('a drag of a handle does not turn the scene, and a click on one moves nothing', async ({
  page,
}) => {
  await openScene(page);
  await drag(page, await spotOf(handle(page, 'V')), 40, 30);
  await page.mouse.up();
  await linkWritten(page);
  expect(await hashOf(page)).not.toContain('view=');
  await still(page);
  const { x, y } = await spotOf(handle(page, 'E'));
  await page.mouse.click(x + 5, y + 6);
  await settle(page);
  expect(await values(page, E)).toEqual([3, 1, 1]);
});

test('with a unit d the tip stands at the unit vector, and a drag sets the raw d', async ({
  page,
}) => {
  await openScene(page, '#/explore?shape=plane&d=-3,0,-4&unit=1&method=exact');
  await drag(page, await spotOf(handle(page, 'd')), 20, -30);
  await page.mouse.up();
  await linkWritten(page);
  const raw =
    /[?&]d=([^&]*)/
      .exec(await hashOf(page))?.[1]
      ?.split(',')
      .map(Number) ?? [];
  expect(Math.hypot(...raw)).toBeLessThan(2);
  expect(Math.hypot(...(await values(page, d)))).toBeCloseTo(1, 12);
});

test('after a drag a clicker still turns pages, after an arrow key it moves along z', async ({
  page,
}) => {
  await openScene(page);
  await drag(page, await spotOf(handle(page, 'E')), -30, -20);
  await page.mouse.up();
  const [x, y = 0, z = 0] = await values(page, E);
  await page.keyboard.press('ArrowUp');
  await settle(page);
  await page.keyboard.press('PageUp');
  await settle(page);
  const after = await values(page, E);
  expect(after[0]).toBe(x);
  expect(after[1]).toBeCloseTo(y + 0.1, 12);
  expect(after[2]).toBeCloseTo(z + 0.1, 12);
  await drag(page, await spotOf(handle(page, 'V')), -30, -20);
  await page.mouse.up();
  await page.keyboard.press('PageDown');
  await settle(page);
  await expect(page.locator('.example-name strong')).not.toHaveText('choose one');
});

test('a kept ray is drawn faintly, with its hits and a word', async ({ page }) => {
  await openScene(page);
  await page.keyboard.press('g');
  await handle(page, 'E').focus();
  for (let k = 0; k < 6; k++) await page.keyboard.press('ArrowUp');
  await still(page);
  await expect(page.locator('[data-mark^="ghost"]')).toHaveCount(3);
  await expect(page.locator('path.graph-ghost')).toHaveCount(1);
  await expect(page.locator('[data-step="C"] .was')).toHaveText(/^before \S+ →/);
  await expect(page.locator('.hit .row.t .was')).toHaveCount(2);
  await expect(page.locator('.scene-overlay').getByText('before')).toBeAttached();
  await page.keyboard.press('g');
  await still(page);
  await expect(page.locator('[data-mark^="ghost"]')).toHaveCount(0);
  await expect(page.locator('.graph-ghost')).toHaveCount(0);
});

test.describe('with the picture', () => {
  test.use({ ink: true });

  test('the picture is a PNG at twice the size, with the scene in it', async ({ page }) => {
    await openScene(page);
    await page.keyboard.press('e');
    const saved = page.waitForEvent('download');
    await page.locator('[data-export="picture-png"] button').click();
    const png = readFileSync(await (await saved).path()).toString('base64');
    const seen = await page.evaluate(async (src) => {
      const image = new Image();
      image.src = src;
      await image.decode();
      const canvas = document.createElement('canvas');
      [canvas.width, canvas.height] = [image.width, image.height];
      const context = canvas.getContext('2d');
      context?.drawImage(image, 0, 0);
      const data = context?.getImageData(0, 0, image.width, image.height).data ?? [];
      const count = (ink: readonly number[]): number => {
        let found = 0;
        for (let k = 0; k < data.length; k += 4) {
          if (ink.every((c, i) => Math.abs((data[k + i] ?? 0) - c) < 12)) found++;
        }
        return found;
      };
      const root = document.querySelector('.scene-root');
      return {
        width: image.width / (root?.clientWidth ?? 1),
        height: image.height / (root?.clientHeight ?? 1),
        paper: count([0xf3, 0xf1, 0xec]),
        inks: {
          E: count([0x0b, 0x41, 0x8f]),
          ray: count([0xb8, 0x4a, 0x00]),
          shape: count([0x8c, 0x4b, 0xcb]),
          hit: count([0x00, 0x5f, 0x58]),
          normal: count([0xcb, 0x1c, 0x80]),
        },
      };
    }, `data:image/png;base64,${png}`);
    expect(seen).toMatchObject({ width: 2, height: 2 });
    expect(seen.paper).toBeGreaterThan(100_000);
    for (const [ink, pixels] of Object.entries(seen.inks)) expect(pixels, ink).toBeGreaterThan(500);
  });
});

test('nothing is drawn while a handle is only looked at', async ({ page }) => {
  await openScene(page);
  const { x, y } = await spotOf(handle(page, 'E'));
  await page.mouse.move(x, y);
  const before = await still(page);
  await frames(page, 30);
  expect(await drawn(page)).toBe(before);
});

async function smallestRoom(page: Page): Promise<number> {
  const rooms = await page.locator('.scene-handle:not(.away) .scene-hit').all();
  const boxes = await Promise.all(rooms.map((room) => room.boundingBox()));
  expect(boxes.length).toBeGreaterThan(2);
  return Math.min(...boxes.flatMap((box) => [box?.width ?? 0, box?.height ?? 0]));
}

test('a mouse has 32 pixels to take a handle by', async ({ page }) => {
  await openScene(page);
  // Less a rounding of the frame's size.
  expect(await smallestRoom(page)).toBeGreaterThanOrEqual(31.9);
});

test.describe('on a phone', () => {
  test.use({ viewport: { width: 390, height: 844 }, hasTouch: true, isMobile: true });

  test('a finger has 44 pixels and drags a handle, and the page does not scroll', async ({
    page,
  }) => {
    await openScene(page, '#/explore?shape=plane&method=exact');
    expect(await smallestRoom(page)).toBeGreaterThanOrEqual(44);
    const { x, y } = await spotOf(handle(page, 'E'));
    const before = await values(page, E);
    const finger = await page.context().newCDPSession(page);
    const touch = (type: 'touchStart' | 'touchMove' | 'touchEnd', ...at: Spot[]) =>
      finger.send('Input.dispatchTouchEvent', { type, touchPoints: at });
    await touch('touchStart', { x, y });
    for (let k = 1; k <= 8; k++) await touch('touchMove', { x: x - 2 * k, y: y - 6 * k });
    await settle(page);
    const during = await values(page, E);
    await touch('touchEnd');
    await settle(page);
    expect(during).not.toEqual(before);
    expect(await values(page, E)).toEqual(during);
    expect(await page.evaluate(() => scrollY)).toBe(0);
    // Its arrows stay, for the next touch.
    await expect(page.locator('.axis-arrow-hit')).not.toHaveCount(0);
    await linkWritten(page);
    expect(await hashOf(page), 'the scene has not been turned').not.toContain('view=');

    // One finger beside the handles scrolls the page or turns the scene, never both: on the
    // background, and on a mark that is no handle.
    const mark = await page.locator('.scene-overlay [data-symbol="N"]').first().boundingBox();
    const starts = [
      { x: 60, y: 330 },
      { x: mark?.x ?? 0, y: mark?.y ?? 0 },
    ];
    const scrolls: boolean[] = [];
    for (const start of starts) {
      for (const [dx, dy] of [
        [0, -8],
        [2, -8],
        [6, -6],
        [8, -3],
        [8, 0],
      ] as const) {
        await open(page, `#/explore?shape=plane&method=exact&view=iso&t=${dx}`);
        // What the last swipe has set rolling has come to rest.
        await page.evaluate(async () => {
          for (let still = 0; still < 5; still = scrollY === 0 ? still + 1 : 0) {
            scrollTo(0, 0);
            await new Promise((drawn) => requestAnimationFrame(drawn));
          }
        });
        await touch('touchStart', start);
        for (let k = 1; k <= 16; k++) {
          await touch('touchMove', { x: start.x + k * dx, y: start.y + k * dy });
        }
        await touch('touchEnd');
        await linkWritten(page);
        const scrolled = (await page.evaluate(() => scrollY)) > 0;
        const turned = (await hashOf(page)).includes('view=');
        expect(scrolled, `${dx}, ${dy}`).not.toBe(turned);
        scrolls.push(scrolled);
      }
    }
    for (const at of [0, 5]) expect(scrolls.slice(at, at + 2)).toEqual([true, true]);
    for (const at of [3, 8]) expect(scrolls.slice(at, at + 2)).toEqual([false, false]);
  });
});

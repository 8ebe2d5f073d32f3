import type { Page } from '@playwright/test';
import { SHAPES } from '../../src/math/index.ts';
import { hashOf, linkWritten, NO_SCENE, open, settle, withoutScene } from './support/page.ts';
import { expect, visit as test } from './support/test.ts';
import { showTheme } from './support/theme.ts';

test.describe.configure({ mode: 'default' });

const CONE = '#/explore?shape=cone&V=0,1,0&c=0.5&E=4,2,1&d=-1,-0.25,-0.25&method=exact';
const CIRCLE = '#/explore?shape=circle&N=1,1,0&C=0,1,0&r=1.5&E=3,2,0.5&d=-1,-0.25,0&method=exact';
/** Along a generator's direction: A is 0. */
const STRAIGHT = '#/explore?shape=cone&V=0,1,0&c=0.5&E=4,2,1&d=-1,-2,0&method=exact';

/** By hand: C = 16 + 1 − 1²/4 and B = 2(−4 − 1/4 + 1/16); N·(E − C) = 3 + 1, N·d = −5/4. */
const ABC = [/^A > 0: .*outside/, /^B < 0: f falls at E/, /^C > 0: E is outside the cone/];
const FLAT = [/^N·\(E − P\) > 0: E is on the side that N points to/, /^N·d < 0: f falls at E/];

test.use({ provoked: NO_SCENE });
test.beforeEach(({ page }) => withoutScene(page));

const texOf = (page: Page, step: number): Promise<string[]> =>
  page
    .locator(`[data-derivation-step="${step}"] [data-tex]`)
    .evaluateAll((lines) => lines.map((line) => line.getAttribute('data-tex') ?? ''));

/** How many steps there are, by the bar. */
const stops = (page: Page): Promise<number> => page.locator('.walk-stop').count();

const steps = (page: Page) => page.locator('[data-derivation-step]');

/** Goes to the end by one key and back by the other; the lines of each step on the way. */
async function thereAndBack(page: Page, on: string, back: string): Promise<string[]> {
  const last = await stops(page);
  const seen: string[] = [];
  for (let step = 1; step <= last; step++) {
    await expect(steps(page)).toHaveCount(step);
    const tex = await texOf(page, step);
    expect(tex.length, `lines of step ${step}`).toBeGreaterThan(0);
    for (const line of tex) expect(line).toMatch(/\S (=|\\le) \S/);
    seen.push(tex.join('\n'));
    await page.keyboard.press(on);
  }
  await expect(steps(page)).toHaveCount(last);
  for (let step = last - 1; step >= 1; step--) {
    await page.keyboard.press(back);
    await expect(steps(page)).toHaveCount(step);
  }
  return seen;
}

test('the walk by keys and by a clicker: each step says something new', async ({ page }) => {
  for (const link of [CONE, CIRCLE]) {
    await open(page, link);
    await page.locator('button.derive').click();
    await expect(page.locator('.walk')).toBeFocused();
    const byKeys = await thereAndBack(page, 'ArrowRight', 'ArrowLeft');
    const byClicker = await thereAndBack(page, 'PageDown', 'PageUp');
    expect(byClicker).toEqual(byKeys);
    await page.locator('.walk-stop', { hasText: link === CONE ? 'A, B, C' : 'expand' }).click();
    await expect(page.locator('.walk-sign')).toContainText(link === CONE ? ABC : FLAT);
    for (const [i, lines] of byKeys.entries()) expect(lines).not.toBe(byKeys[i - 1]);
    await page.keyboard.press('End');
    await expect(steps(page)).toHaveCount(await stops(page));
    await page.keyboard.press('Home');
    await expect(steps(page)).toHaveCount(1);
    await page.keyboard.press('Escape');
    await expect(page.locator('.walk')).toBeHidden();
    await expect(page.locator('button.derive')).toBeFocused();
  }
});

test('every line of the card leads to the step that has it', async ({ page }) => {
  const squares = '#/explore?shape=square&P=0,0,-1&L=2&axis=x&E=3,1,1&d=-0.75,-0.25,-0.25';
  // Two roots: −B ± √D, as in the step.
  for (const link of [CONE.replace('d=-1,-0.25,-0.25', 'd=-1,-0.25,-0.125'), squares]) {
    await open(page, link);
    // A flat shape's N is given.
    const all = page
      .locator('.algebra :is(.step, .condition)')
      .filter({ has: page.locator('.why') });
    const given = link === squares ? 1 : 0;
    await expect(page.locator('.normal-line .in-symbols')).toBeVisible();
    const lines = await all.count();
    expect(lines).toBeGreaterThan(3);
    await expect(page.locator('.algebra :is(.step, .condition)')).toHaveCount(lines + given);
    for (let i = 0; i < lines; i++) {
      const line = all.nth(i);
      const symbols = await line
        .locator('.in-symbols')
        .evaluate((element) => element.textContent?.replace(/\s/g, ''));
      await line.locator('.why').click();
      const present = page.locator('.walk-step.present');
      await present.waitFor();
      const said = await present.evaluate((element) => element.textContent?.replace(/\s/g, ''));
      // The walk has the components of N one under the other.
      const parts = symbols?.startsWith('(x') ? symbols.slice(1, -1).split(',') : [symbols];
      for (const part of parts) expect(said).toContain(part);
      await page.keyboard.press('Escape');
      await expect(line.locator('.why')).toBeFocused();
    }
  }
});

test('on the projector numbers put in, and why, are one click away', async ({ page }) => {
  await page.setViewportSize({ width: 1024, height: 768 });
  // Another method than the page's own stands where the button does.
  await open(page, CONE.replace('method=exact', 'method=certified'));
  await showTheme(page, 'projector');
  const lines = page.locator('.algebra .step:has(.why):not(.normal-line)');
  const more = page.locator('.algebra .step.stacked .in-numbers, .algebra .step .why');
  await expect(page.locator('.algebra .derive')).toBeVisible();
  expect(await more.evaluateAll((all) => all.filter((one) => one.checkVisibility()).length)).toBe(
    0,
  );
  await page.getByLabel('in full').check();
  for (const line of await lines.all()) {
    await expect(line.locator('.in-numbers')).toBeVisible();
    await line.locator('.why').click();
    await page.locator('.walk-step.present').waitFor();
    await page.keyboard.press('Escape');
  }
  await page.getByLabel('in full').uncheck();
  await expect(page.locator('.algebra .why').first()).toBeHidden();
  await showTheme(page, 'light');
});

test('hidden results are not told by any step', async ({ page }) => {
  await open(page, CONE);
  for (const link of [CONE, STRAIGHT]) {
    await open(page, `${link}&hide=1&derive=1`);
    await page.locator('.walk').waitFor();
    const last = await stops(page);
    await expect(page.locator('.walk-bar')).not.toContainText('A = 0');
    for (let step = 1; step <= last; step++) {
      await expect(steps(page)).toHaveCount(step);
      await expect(page.locator('.walk-numbers, .walk-results, .walk .value')).toHaveCount(0);
      await page.keyboard.press('PageDown');
    }
  }
  await open(page, `${STRAIGHT}&hide=0&derive=6`);
  await expect(page.locator('.walk-bar')).toContainText('A = 0');
});

test('the link has the step: closed, reloaded, back and forth', async ({ page }) => {
  await open(page, CONE);
  await linkWritten(page);
  await page.keyboard.press('d');
  await page.locator('.walk').waitFor();
  for (let i = 0; i < 3; i++) await page.keyboard.press('PageDown');
  await linkWritten(page);
  expect(await hashOf(page)).toMatch(/&derive=4$/);
  await page.reload();
  await expect(steps(page)).toHaveCount(4);
  await page.locator('.walk-close').click();
  await expect(page.locator('.walk')).toBeHidden();
  await linkWritten(page);
  expect(await hashOf(page)).not.toContain('derive');
  await page.goBack();
  await expect(steps(page)).toHaveCount(4);
  await page.goBack();
  await expect(page.locator('.walk')).toBeHidden();
  await page.goForward();
  await expect(steps(page)).toHaveCount(4);
  await open(page, `${CONE}&derive=9`);
  await expect(page.locator('.walk')).toBeHidden();
  await expect(page.locator('.problems')).toContainText(
    'opened without derive: 9 is not a step from 1 to 8',
  );
});

test('a term lights where it came from, and travels there', async ({ page }) => {
  await open(page, `${CONE}&derive=5`);
  await page.locator('.walk').waitFor();
  const first = page.locator('.walk-step.present .term').first();
  const litIn = (): Promise<(string | null)[]> =>
    page
      .locator('[data-derivation-step]:has(.term-lit)')
      .evaluateAll((all) => all.map((one) => one.getAttribute('data-derivation-step')));
  await first.hover();
  expect(await litIn()).toEqual(['1', '2', '3', '4', '5']);
  // (Ex − Vx + t dx)² is where dx² came from.
  await expect(page.locator('[data-derivation-step="2"] .term-lit')).toHaveCount(1);
  await page.locator('.walk-head').hover();
  expect(await litIn()).toEqual([]);
  await first.focus();
  expect(await litIn()).toEqual(['1', '2', '3', '4', '5']);
  // As by a finger, which points at nothing once it is lifted: a square of an earlier step.
  await page.locator('[data-derivation-step="2"] .term').nth(1).dispatchEvent('click');
  expect(await litIn()).toEqual(['1', '2', '3', '4', '5']);
  await expect(first).not.toHaveClass(/term-lit/);

  /** How far the terms of the step still have to go, as soon as it is drawn. */
  const travelling = (stop: number): Promise<number> =>
    page.evaluate(async (n) => {
      const frame = () => new Promise((done) => requestAnimationFrame(done));
      document.querySelectorAll<HTMLElement>('.walk-stop')[n - 1]?.click();
      const terms = () => [...document.querySelectorAll('.walk-step.present .term')];
      const present = () => document.querySelector(`[data-derivation-step="${n}"].present`);
      while (!present()) await frame();
      return terms().filter((term) => term.getAnimations().length > 0).length;
    }, stop);
  await page.locator('.walk-stop').nth(2).click();
  await expect(steps(page)).toHaveCount(3);
  expect(await travelling(4)).toBe(9);
  await page.emulateMedia({ reducedMotion: 'reduce' });
  await page.locator('.walk-stop').nth(2).click();
  await expect(steps(page)).toHaveCount(3);
  expect(await travelling(4)).toBe(0);
});

/** Of a step, in the page: what its threads join, and the texts that they cross. */
const threadsOf = (page: Page) =>
  page.evaluate(() => {
    const present = document.querySelector('.walk-step.present') as Element;
    const before = present.previousElementSibling as Element;
    const terms = (element: Element) => (element.getAttribute('data-terms') ?? '').split(' ');
    const boxOf = (element: Element) =>
      (element.querySelector('math') ?? element).getBoundingClientRect();
    const texts = [...document.querySelectorAll('.walk-steps :is(math, .value, .walk-name)')].map(
      (element) => {
        const range = document.createRange();
        range.selectNodeContents(element);
        return { box: range.getBoundingClientRect(), name: element.textContent?.trim() };
      },
    );
    return [...document.querySelectorAll('.walk-thread')].map((thread) => {
      const own = terms(thread);
      const path = thread.querySelector('path:last-child') as SVGGeometryElement;
      const toScreen = path.getScreenCTM() as DOMMatrix;
      const length = path.getTotalLength();
      const points = Array.from({ length: Math.ceil(length / 3) + 1 }, (_, i) =>
        path.getPointAtLength(Math.min(3 * i, length)).matrixTransform(toScreen),
      );
      const near = (at: DOMPoint | undefined, { left, right, top, bottom }: DOMRect) =>
        at !== undefined &&
        at.x > left - 24 &&
        at.x < right + 24 &&
        at.y > top - 12 &&
        at.y < bottom + 12;
      const all = [...document.querySelectorAll('.walk-step .term')];
      const square = own.length > 1;
      const lines =
        square && present.querySelector('.walk-bill')
          ? [before.previousElementSibling, before]
          : [before, present];
      const [from, to] = lines.map((line) =>
        all.filter((one) => line?.contains(one) && terms(one).every((id) => own.includes(id))),
      );
      return {
        terms: own,
        starts: from?.some((term) => near(points[0], boxOf(term))) ?? false,
        ends: to?.some((term) => near(points.at(-1), boxOf(term))) ?? false,
        crossed: texts
          .filter(({ box }) =>
            points.some(
              ({ x, y }) =>
                x > box.left + 1 && x < box.right - 1 && y > box.top + 1 && y < box.bottom - 1,
            ),
          )
          .map(({ name }) => name),
      };
    });
  });

test('threads join each term to what it came from, and cross no text', async ({ page }) => {
  await page.emulateMedia({ reducedMotion: 'reduce' });
  await page.setViewportSize({ width: 1280, height: 720 });
  await open(page, CONE);
  for (const { kind } of SHAPES) {
    for (const step of [3, 4]) {
      await open(page, `#/explore?shape=${kind}&derive=${step}`);
      await expect(steps(page)).toHaveCount(step);
      // A flat shape has nothing to collect.
      if (step === 4 && (await page.locator('.walk-bill').count()) === 0) continue;
      const threads = await threadsOf(page);
      const sources = await page
        .locator(`[data-derivation-step="2"] .term`)
        .evaluateAll((all) => all.map((one) => one.getAttribute('data-terms') ?? ''));
      const rows = await page
        .locator('.walk-row .term')
        .evaluateAll((all) => all.map((one) => one.getAttribute('data-terms') ?? ''));
      const joined = threads.map(({ terms }) => terms.join(' '));
      const squares = sources.filter((terms) => terms.includes(' '));
      expect(joined.sort(), `${kind}, step ${step}`).toEqual([...squares, ...rows].sort());
      for (const thread of threads) {
        expect(thread, `${kind}, step ${step}`).toMatchObject({
          ...{ starts: true, ends: true, crossed: [] },
        });
      }
    }
  }
  await open(page, `${CONE}&derive=4`);
  await expect(steps(page)).toHaveCount(4);
  // Pointed at, with both of its ends and the square that they came from.
  await page.locator('.walk-row .term').first().focus();
  await expect(page.locator('.walk-thread.term-lit')).toHaveCount(2);
});

const SCREENS = [
  { width: 1280, height: 720, theme: 'light' },
  { width: 1024, height: 768, theme: 'projector' },
  { width: 390, height: 844, theme: 'light' },
  { width: 844, height: 390, theme: 'light' },
] as const;

for (const { width, height, theme } of SCREENS) {
  test(`${width} × ${height}, ${theme}: in every step there is what it speaks of`, async ({
    page,
  }) => {
    await page.emulateMedia({ reducedMotion: 'reduce' });
    await page.setViewportSize({ width, height });
    await open(page, `${CONE}&derive=1`);
    await showTheme(page, theme);
    await page.locator('.walk').waitFor();
    const last = await stops(page);
    for (let step = 1; step <= last; step++) {
      await expect(steps(page)).toHaveCount(step);
      await expect(page.locator('.scene-area')).toBeInViewport({ ratio: 0.99 });
      for (const part of ['.walk-close', '.walk-bar']) {
        await expect(page.locator(part), `${part}, step ${step}`).toBeInViewport({ ratio: 0.99 });
      }
      const words = await page.locator('.walk-step.present').innerText();
      if (/\bf (falls|turns|is 0|rises)\b/.test(words)) {
        await expect(page.locator('.graph-svg'), words).toBeInViewport({ ratio: 0.99 });
      }
      const found = await page.evaluate(() => {
        const box = (name: string) => document.querySelector(name)?.getBoundingClientRect();
        const [name, step, head, bar] = [
          '.walk-step.present .walk-name',
          '.walk-step.present',
          '.walk-head',
          '.walk-bar',
        ].map(box);
        const ends = [...document.querySelectorAll('.walk-last')].map((end) => {
          const tops = [...end.querySelectorAll('math')].map((m) => m.getBoundingClientRect());
          return tops.every(({ top, bottom }) =>
            tops.every((o) => o.top < bottom && top < o.bottom),
          );
        });
        return {
          wide: document.documentElement.scrollWidth,
          clear: (name?.top ?? 0) >= (head?.bottom ?? 0) - 1,
          over: (name?.bottom ?? 0) <= (bar?.top ?? 0) + 1,
          // The whole step, or as much of it as there is room for.
          seen:
            (step?.bottom ?? 0) <= (bar?.top ?? 0) + 1 ||
            (name?.top ?? 0) - (head?.bottom ?? 0) < 40,
          ends,
        };
      });
      expect(found, `step ${step}`).toMatchObject({
        ...{ wide: width, clear: true, over: true, seen: true },
      });
      expect(found.ends).not.toContain(false);
      await page.keyboard.press('PageDown');
    }
    await settle(page);
    await showTheme(page, 'light');
  });
}

import type { Page } from '@playwright/test';
import { open, settle } from './support/page.ts';
import { expect, test } from './support/test.ts';

test.use({ viewport: { width: 390, height: 844 }, hasTouch: true });

/** The least size under a finger, in px. */
const FINGER = 44;

/**
 * What can be pressed and is smaller than a finger's 44 px, so that a press beside it does
 * something else. A target in a line of text is as high as the line, and its neighbours in the
 * text are as near as the text has them.
 */
async function tooSmall(page: Page, within: string): Promise<string[]> {
  return page.evaluate(
    ([within, finger]) => {
      const TARGETS = 'a[href], button, select, summary, input, textarea, label:has(input)';
      const rowsOf = 'p, li, td, th, dd, .body, .lesson-text, .lesson-answer';
      const targetAt = (x: number, y: number): Element | null =>
        document.elementFromPoint(x, y)?.closest(`${TARGETS}, [role=slider]`) ?? null;
      const same = (one: Element, other: Element | null): boolean =>
        other === null ||
        one === other ||
        one.contains(other) ||
        other.contains(one) ||
        (one instanceof HTMLInputElement && [...(one.labels ?? [])].some((l) => l === other));
      const inText = (one: Element): boolean => {
        const row = one.closest(rowsOf);
        const own = one.textContent?.trim() ?? '';
        return row !== null && one.matches('a, button') && (row.textContent ?? '').trim() !== own;
      };
      const found: string[] = [];
      for (const one of document.querySelectorAll<HTMLElement>(`${within} :is(${TARGETS})`)) {
        if (!one.checkVisibility({ visibilityProperty: true, opacityProperty: true })) continue;
        // The label around a box is the target.
        const isLabelled = one instanceof HTMLInputElement && one.closest('label') !== null;
        if (one.matches('.visually-hidden, :disabled') || isLabelled || inText(one)) continue;
        one.scrollIntoView({ block: 'center', inline: 'center', behavior: 'instant' });
        const { left, top, width, height } = one.getBoundingClientRect();
        if (width < 2 || (width >= finger - 0.5 && height >= finger - 0.5)) continue;
        const [x, y] = [left + width / 2, top + height / 2];
        // Covered by what is over it: it is pressed after scrolling.
        if (!same(one, targetAt(x, y)) || targetAt(x, y) === null) continue;
        const around = (far: number) =>
          [
            [x - far, y],
            [x + far, y],
            [x, y - far],
            [x, y + far],
          ].map(([u = 0, v = 0]) => targetAt(u, v));
        const other = around(finger / 2 - 1).find((hit) => !same(one, hit));
        // However free it stands, half of a finger has to hit it.
        const small = around(finger / 4).some((hit) => hit === null || !same(one, hit));
        if (!other && !small) continue;
        const name = (one.getAttribute('aria-label') ?? one.textContent ?? '').trim().slice(0, 30);
        const beside = other ? ` beside ${other.getAttribute('class') ?? other.tagName}` : '';
        found.push(
          `${one.className} “${name}” ${Math.round(width)} × ${Math.round(height)}${beside}`,
        );
      }
      return [...new Set(found)];
    },
    [within, FINGER] as const,
  );
}

/** Each page, and the states of Explore and of lessons that have controls of their own. */
const LINKS = [
  '#/explore?shape=hyperboloid',
  '#/explore?shape=cone&E=4,1,0.5&d=-1,0,0&hide=1',
  '#/explore?shape=cone&derive=4',
  '#/lesson',
  '#/lesson/ray?step=5',
  '#/lesson/discriminant?step=3',
  '#/lesson/ray?step=6',
  '#/lesson/effects?step=3',
  '#/accuracy?shape=cone',
  '#/picture?size=64x36',
  '#/check?seed=41',
];

test('under a finger every target has 44 px, or nothing else as near', async ({ page }) => {
  await open(page, '#/explore');
  for (const link of LINKS) {
    await open(page, link);
    await page.locator('main :is(h2, canvas, table)').filter({ visible: true }).first().waitFor();
    await settle(page);
    expect.soft(await tooSmall(page, 'body'), link).toEqual([]);
  }
  await open(page, '#/explore');
  for (const [key, name] of [
    ['x', 'Examples'],
    ['e', 'File and export'],
    ['?', 'Help'],
  ] as const) {
    await page.keyboard.press(key);
    const dialog = page.getByRole('dialog', { name });
    await expect(dialog.getByRole('button').nth(1).or(dialog.locator('kbd').first())).toBeVisible();
    expect.soft(await tooSmall(page, 'dialog[open]'), name).toEqual([]);
    await page.keyboard.press('Escape');
    await expect(dialog).toBeHidden();
  }
});

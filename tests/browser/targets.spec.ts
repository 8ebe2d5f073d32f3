import type { Page } from '@playwright/test';
import { byTurns } from '../unit/many.ts';
import { open, settle } from './support/page.ts';
import { expect, test } from './support/test.ts';

test.use({ viewport: { width: 390, height: 844 }, hasTouch: true });

/** The least size under a finger, in px. */
const FINGER = 44;

/**
 * What can be pressed and takes a finger in less than 44 × 44 px, whether it stands in a row, in a
 * line of text or in a drawing: what is hit around its middle, up to where something else is.
 */
async function tooSmall(page: Page, within: string): Promise<string[]> {
  return page.evaluate(
    ([within, finger]) => {
      const TARGETS =
        'a[href], button, select, summary, input, textarea, label:has(input), ' +
        '[role=slider], [role=application], [data-handle]';
      const targetAt = (x: number, y: number): Element | null =>
        document.elementFromPoint(x, y)?.closest(TARGETS) ?? null;
      const same = (one: Element, other: Element | null): boolean =>
        other !== null &&
        (one === other ||
          one.contains(other) ||
          (one instanceof HTMLInputElement && [...(one.labels ?? [])].some((l) => l === other)));
      /** How far a press beside its middle still hits it, in px, along one axis. */
      const reach = (one: Element, x: number, y: number, dx: number, dy: number): number => {
        let far = 0;
        while (far < finger && same(one, targetAt(x + (far + 1) * dx, y + (far + 1) * dy))) far++;
        return far;
      };
      const found: string[] = [];
      for (const one of document.querySelectorAll<HTMLElement>(`${within} :is(${TARGETS})`)) {
        if (!one.checkVisibility({ visibilityProperty: true, opacityProperty: true })) continue;
        // The label around a box is the target.
        const isLabelled = one instanceof HTMLInputElement && one.closest('label') !== null;
        if (one.matches('.visually-hidden, :disabled') || isLabelled) continue;
        one.scrollIntoView({ block: 'center', inline: 'center', behavior: 'instant' });
        const { left, top, width, height } = one.getBoundingClientRect();
        if (width < 2 || (width >= finger - 0.5 && height >= finger - 0.5)) continue;
        const [x, y] = [left + width / 2, top + height / 2];
        // Covered by what is over it: it is pressed after scrolling, or is the nearer of two.
        if (!same(one, targetAt(x, y))) continue;
        const wide = reach(one, x, y, -1, 0) + 1 + reach(one, x, y, 1, 0);
        const high = reach(one, x, y, 0, -1) + 1 + reach(one, x, y, 0, 1);
        if (wide >= finger - 1 && high >= finger - 1) continue;
        const name = (one.getAttribute('aria-label') ?? one.textContent ?? '').trim().slice(0, 30);
        found.push(`${one.getAttribute('class')} “${name}” takes ${wide} × ${high}`);
      }
      return [...new Set(found)];
    },
    [within, FINGER] as const,
  );
}

/** Each page, and the states of Explore and of lessons that have controls of their own. */
const LINKS = [
  '#/explore?shape=hyperboloid&between=-1,2&caps=1',
  '#/explore?shape=cone&E=4,1,0.5&d=-1,0,0&hide=1',
  '#/explore?shape=cone&derive=4',
  '#/lesson',
  '#/lesson/ray?step=5',
  '#/lesson/discriminant?step=3',
  '#/lesson/ray?step=6',
  '#/lesson/effects?step=3',
  '#/accuracy?shape=cone',
  '#/accuracy?shape=sphere&atlas=E.z,E.x',
  '#/picture?size=64x36',
  '#/check?seed=41',
  '#/check?part=program',
];

test('under a finger every target takes 44 px', async ({ page }) => {
  await open(page, '#/explore');
  for (const [n, size] of [
    { width: 844, height: 390 },
    { width: 390, height: 844 },
  ].entries()) {
    await page.setViewportSize(size);
    for (const link of byTurns(LINKS, n)) {
      await open(page, link);
      await page.locator('main :is(h2, canvas, table)').filter({ visible: true }).first().waitFor();
      await settle(page);
      expect.soft(await tooSmall(page, 'body'), `${link}, ${size.width} px`).toEqual([]);
    }
    await open(page, '#/explore');
    for (const [key, name] of [
      ['x', 'Examples'],
      ['e', 'File and export'],
      ['?', 'Help'],
    ] as const) {
      await page.keyboard.press(key);
      const dialog = page.getByRole('dialog', { name });
      await expect(
        dialog.getByRole('button').nth(1).or(dialog.locator('kbd').first()),
      ).toBeVisible();
      expect.soft(await tooSmall(page, 'dialog[open]'), `${name}, ${size.width} px`).toEqual([]);
      const embed = dialog.getByRole('button', { name: 'Embed' });
      if (await embed.isVisible()) {
        await embed.tap();
        await page.getByRole('dialog', { name: 'Embed' }).waitFor();
        expect.soft(await tooSmall(page, 'dialog[open]'), `Embed, ${size.width} px`).toEqual([]);
      }
      await page.keyboard.press('Escape');
      await expect(page.locator('dialog[open]')).toHaveCount(0);
    }
  }
  // The parts in a host's page.
  await page.goto('about:blank');
  await page.goto('./#/explore?embed=scene,graph,algebra,parameters,caption&shape=cone');
  await page.locator('.value').first().waitFor();
  expect.soft(await tooSmall(page, 'body'), 'embedded').toEqual([]);
});

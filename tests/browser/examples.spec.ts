import type { Page } from '@playwright/test';
import { GALLERY } from '../../src/state/gallery/index.ts';
import { open } from './support/page.ts';
import { framesDone } from './support/pending.ts';
import { expect, test } from './support/test.ts';

const SIZES = [
  { width: 1280, height: 720 },
  { width: 1024, height: 768 },
  { width: 390, height: 844 },
];

/** Texts of the scene and of the graph that lie on another one, as they are drawn. */
async function met(page: Page): Promise<string[]> {
  return page.evaluate(() => {
    const GROUPS = [
      '.scene-overlay text',
      '.scene-views button, .example-name, .scene-bar .ray-tool',
      '.graph text',
    ];
    return GROUPS.flatMap((selector) => {
      const all = [...document.querySelectorAll(selector)].map((element) => ({
        name: element.textContent?.replace(/\s+/g, ' ').trim() ?? '',
        box: element.getBoundingClientRect(),
        math: element.classList.contains('scene-label'),
      }));
      // A line of type is higher than its letters.
      const high = (one: (typeof all)[number]) => (one.math ? 0.26 : 0.12) * one.box.height;
      return all.flatMap((a, i) =>
        all.slice(i + 1).flatMap((b) => {
          const x = Math.min(a.box.right, b.box.right) - Math.max(a.box.left, b.box.left);
          const y =
            Math.min(a.box.bottom - high(a), b.box.bottom - high(b)) -
            Math.max(a.box.top + high(a), b.box.top + high(b));
          return x > 1 && y > 1 ? [`${a.name} on ${b.name}: ${x.toFixed()} × ${y.toFixed()}`] : [];
        }),
      );
    });
  });
}

// Dark is light in other colours: tests/unit/ui/themes.test.ts.
for (const [turn, theme] of ['light', 'projector'].entries()) {
  test(`${theme}: no text of an example's pictures lies on another one`, async ({ page }) => {
    await page.addInitScript((name) => localStorage.setItem('graze.theme', name), theme);
    await page.emulateMedia({ reducedMotion: 'reduce' });
    for (const [n, size] of SIZES.entries()) {
      await page.setViewportSize(size);
      // Every example in every window, in the two sizes of type by turns; what lies in the scene is
      // looked at in all of them by tests/unit/canvas/examples.test.ts.
      for (const { id, link } of GALLERY.filter((_, i) => (i + n) % 2 === turn)) {
        await open(page, link);
        await page.locator('.scene-overlay .scene-mark').first().waitFor();
        await framesDone(page);
        expect.soft(await met(page), `${id} at ${size.width} × ${size.height}`).toEqual([]);
      }
    }
  });
}

import type { Page } from '@playwright/test';
import { frames } from './pending.ts';

/** Shows the page in a theme: the style sheets and the canvas know it by the attribute alone. */
export async function showTheme(page: Page, theme: string): Promise<void> {
  await page.evaluate(async (name) => {
    document.documentElement.dataset.theme = name;
    await Promise.all(document.getAnimations().map(({ finished }) => finished.catch(() => null)));
  }, theme);
  await frames(page, 2);
}

import { AxeBuilder } from '@axe-core/playwright';
import type { Page } from '@playwright/test';
import { THEMES } from '../../../src/ui/theme.ts';
import { frames } from './pending.ts';

/** What a theme can break: it changes colours, and on the projector sizes. */
const OF_A_THEME = ['color-contrast', 'link-in-text-block', 'scrollable-region-focusable'];

/** One line a violation: the rule, and the elements that break it; of these rules, or of all. */
async function violations(page: Page, rules?: string[]): Promise<string[]> {
  const axe = new AxeBuilder({ page }).setLegacyMode(true);
  const { violations: found } = await (rules ? axe.withRules(rules) : axe).analyze();
  return found.flatMap(({ id, nodes }) =>
    nodes.map(({ target, any }) => `${id}: ${target.join(' ')} (${any[0]?.message ?? ''})`),
  );
}

/** All rules in the theme that is shown, and in the other ones those that a theme can break. */
export async function violationsInThemes(page: Page): Promise<string[]> {
  const root = page.locator('html');
  const shown = await root.getAttribute('data-theme');
  const found = await violations(page);
  for (const theme of THEMES) {
    if (theme === 'system' || theme === shown) continue;
    await show(page, theme);
    found.push(...(await violations(page, OF_A_THEME)).map((line) => `${theme}: ${line}`));
  }
  await show(page, shown ?? '');
  return found;
}

/** The style sheets know the theme by the attribute alone. */
async function show(page: Page, theme: string): Promise<void> {
  await page.evaluate(async (name) => {
    document.documentElement.dataset.theme = name;
    await Promise.all(document.getAnimations().map(({ finished }) => finished.catch(() => null)));
  }, theme);
  await frames(page, 2);
}

import { readFileSync } from 'node:fs';
import { createRequire } from 'node:module';
import type { Page } from '@playwright/test';
import type { AxeResults, RunOptions } from 'axe-core';
import { THEMES } from '../../../src/ui/theme.ts';
import { showTheme } from './theme.ts';

const AXE = readFileSync(createRequire(import.meta.url).resolve('axe-core/axe.min.js'), 'utf8');

/** What a theme can break: it changes colours, and on the projector sizes. */
const OF_A_THEME: RunOptions = {
  runOnly: ['color-contrast', 'link-in-text-block', 'scrollable-region-focusable'],
};
/** As they are applied; 'system' is one of them. */
const APPLIED = THEMES.filter((theme) => theme !== 'system');

/** What axe runs by itself without the dearest rule, for states that bring no colour. */
export const BUT_CONTRAST: RunOptions = { rules: { 'color-contrast': { enabled: false } } };

type Axe = { readonly run: (where: Element, options: RunOptions) => Promise<AxeResults> };

/**
 * One line a violation within the first element of a selector: the rule, and the elements that
 * break it; of the rules of these options, or of all that axe runs by itself. Elements that pass
 * are not described, which takes most of axe's time. The page has no frame that shows anything.
 */
export async function violations(
  page: Page,
  within = 'html',
  rules: RunOptions = {},
): Promise<string[]> {
  if (!(await page.evaluate(() => 'axe' in window))) await page.evaluate(AXE);
  const options: RunOptions = {
    resultTypes: ['violations'],
    preload: false,
    iframes: false,
    ...rules,
  };
  return page.evaluate(
    async ([within, options]) => {
      const { axe } = window as unknown as { readonly axe: Axe };
      const root = document.querySelector(within);
      if (!root) return [`there is no ${within}`];
      const { violations: found } = await axe.run(root, options);
      return found.flatMap(({ id, nodes }) =>
        nodes.map(({ target, any }) => `${id}: ${target.join(' ')} (${any[0]?.message ?? ''})`),
      );
    },
    [within, options] as const,
  );
}

/**
 * All rules in the theme that is shown, and in the other ones those that a theme can break; there
 * within `sample`, where what follows it repeats its colours.
 */
export async function violationsInThemes(
  page: Page,
  within = 'html',
  sample = within,
): Promise<string[]> {
  const root = page.locator('html');
  const shown = await root.getAttribute('data-theme');
  const found = await violations(page, within);
  for (const theme of APPLIED) {
    if (theme === shown) continue;
    await showTheme(page, theme);
    found.push(...(await violations(page, sample, OF_A_THEME)).map((line) => `${theme}: ${line}`));
  }
  await showTheme(page, shown ?? '');
  return found;
}

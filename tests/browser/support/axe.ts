import { readFileSync } from 'node:fs';
import { createRequire } from 'node:module';
import type { Page } from '@playwright/test';
import type { AxeResults, RunOptions } from 'axe-core';
import { THEMES } from '../../../src/ui/theme.ts';
import { byTurns } from '../../unit/many.ts';
import { showTheme } from './theme.ts';

const AXE = readFileSync(createRequire(import.meta.url).resolve('axe-core/axe.min.js'), 'utf8');

const CONTRAST = 'color-contrast';
/** What a theme can break beside contrast: it changes colours, and on the projector sizes. */
const OF_A_THEME: RunOptions = { runOnly: ['link-in-text-block', 'scrollable-region-focusable'] };
/** As they are applied; 'system' is one of them. */
const APPLIED = THEMES.filter((theme) => theme !== 'system');

/** What axe runs by itself without the dearest rule, for states that bring no colour. */
export const BUT_CONTRAST: RunOptions = { rules: { [CONTRAST]: { enabled: false } } };

type Axe = {
  readonly run: (where: Element | Element[], options: RunOptions) => Promise<AxeResults>;
};

/**
 * One line a violation within the first element of a selector: the rule, and the elements that
 * break it; of the rules of these options, or of all that axe runs by itself. Elements that pass
 * are not described, which takes most of axe's time. The page has no frame that shows anything.
 * Contrast, which takes most of what is left, is looked for once for each look of a text: the rows
 * of a table have one. With LONG it is looked for in every text.
 */
export async function violations(
  page: Page,
  within = 'html',
  rules: RunOptions = {},
): Promise<string[]> {
  if (rules.runOnly || rules.rules) return found(page, within, rules);
  return [
    ...(await found(page, within, BUT_CONTRAST)),
    ...(await contrast(page, within, 'of each look')),
  ];
}

/**
 * Which texts are looked at: of each colour, ground, size and class only the first, or of these
 * those whose styles do not tell that their contrast is enough.
 */
type Texts = 'all' | 'of each look' | 'unsure';

const contrast = (page: Page, within: string, texts: Texts): Promise<string[]> =>
  found(page, within, { runOnly: [CONTRAST] }, process.env.LONG ? 'all' : texts);

async function found(
  page: Page,
  within: string,
  rules: RunOptions,
  texts: Texts = 'all',
): Promise<string[]> {
  if (!(await page.evaluate(() => 'axe' in window))) await page.evaluate(AXE);
  const options: RunOptions = {
    resultTypes: ['violations'],
    preload: false,
    iframes: false,
    ...rules,
  };
  return page.evaluate(
    async ([within, options, texts]) => {
      const { axe } = window as unknown as { readonly axe: Axe };
      const root = document.querySelector(within);
      if (!root) return [`there is no ${within}`];

      const grounds = new Map<Element | null, string>([[null, '']]);
      /** What lies behind an element, and how it is faded, from its ancestors. */
      const groundOf = (element: Element | null): string => {
        const known = grounds.get(element);
        if (known !== undefined || !element) return known ?? '';
        const style = getComputedStyle(element);
        const { backgroundColor, backgroundImage, opacity, filter, position } = style;
        const own = [backgroundColor, backgroundImage, opacity, filter].join();
        const behind = groundOf(element.parentElement);
        // What is put somewhere lies on something else than its parent.
        const place = position === 'static' ? '' : element.getAttribute('class');
        const isBare = own === 'rgba(0, 0, 0, 0),none,1,none' && !place;
        const ground = isBare ? behind : `${behind} ${own} ${place}`;
        grounds.set(element, ground);
        return ground;
      };
      const lookOf = (element: Element): string => {
        const { color, fill, fontSize, fontWeight, textShadow } = getComputedStyle(element);
        const names = [element, element.parentElement].map(
          (one) => `${one?.tagName} ${one?.getAttribute('class')}`,
        );
        const isOff = element.matches(':disabled, [aria-disabled=true]');
        const text = [color, fill, fontSize, fontWeight, textShadow, isOff];
        return [...text, ...names, groundOf(element)].join();
      };
      const hasText = (element: Element): boolean =>
        element.matches('input, select, textarea') ||
        [...element.childNodes].some(
          (node) => node.nodeType === Node.TEXT_NODE && node.textContent?.trim(),
        );
      /** Null for what is not opaque, or written otherwise. */
      const luminance = (css: string): number | null => {
        const [r, g, b] = /^rgb\((\d+), (\d+), (\d+)\)$/.exec(css)?.slice(1).map(Number) ?? [];
        if (r === undefined || g === undefined || b === undefined) return null;
        const [R, G, B] = [r, g, b].map((level) => {
          const x = level / 255;
          return x <= 0.04045 ? x / 12.92 : ((x + 0.055) / 1.055) ** 2.4;
        }) as [number, number, number];
        return 0.2126 * R + 0.7152 * G + 0.0722 * B;
      };
      /** The text lies in its parents, the nearest ground is of one colour, and it stands out. */
      const isSure = (element: Element): boolean => {
        const { color, fontSize, fontWeight } = getComputedStyle(element);
        const ink = luminance(color);
        if (ink === null || element instanceof SVGElement) return false;
        for (let at: Element | null = element; at; at = at.parentElement) {
          const style = getComputedStyle(at);
          const isPlain =
            style.opacity === '1' && style.filter === 'none' && style.backgroundImage === 'none';
          if (!isPlain || style.mixBlendMode !== 'normal') return false;
          const ground = luminance(style.backgroundColor);
          if (ground !== null) {
            const px = Number.parseFloat(fontSize);
            const isLarge = px >= 24 || (px >= 18.67 && Number(fontWeight) >= 700);
            const ratio = (Math.max(ink, ground) + 0.05) / (Math.min(ink, ground) + 0.05);
            return ratio > (isLarge ? 3 : 4.5);
          }
          if (style.backgroundColor !== 'rgba(0, 0, 0, 0)') return false;
          if (!['static', 'relative'].includes(style.position)) return false;
        }
        return false;
      };
      const looks = new Map<string, Element>();
      if (texts !== 'all') {
        for (const element of root.querySelectorAll('*')) {
          if (!hasText(element) || !element.checkVisibility()) continue;
          const look = lookOf(element);
          if (!looks.has(look)) looks.set(look, element);
        }
      }
      const some = [...looks.values()].filter((one) => texts !== 'unsure' || !isSure(one));
      if (texts !== 'all' && some.length === 0) return [];
      const { violations } = await axe.run(texts === 'all' ? root : some, options);
      return violations.flatMap(({ id, nodes }) =>
        nodes.map(({ target, any }) => `${id}: ${target.join(' ')} (${any[0]?.message ?? ''})`),
      );
    },
    [within, options, texts] as const,
  );
}

/** How often each page has been looked at in another theme than its own. */
const looks = new WeakMap<Page, number>();

/**
 * All rules in the theme that is shown, and in another one, by turns, those that a theme can break:
 * there axe looks for the contrast of texts whose styles do not tell that it is enough.
 */
export async function violationsInThemes(page: Page, within = 'html'): Promise<string[]> {
  const root = page.locator('html');
  const shown = await root.getAttribute('data-theme');
  const all = await violations(page, within);
  const turn = looks.get(page) ?? 0;
  looks.set(page, turn + 1);
  const others = APPLIED.filter((theme) => theme !== shown);
  for (const theme of byTurns(others, turn, others.length)) {
    await showTheme(page, theme);
    const broken = [
      ...(await found(page, within, OF_A_THEME)),
      ...(await contrast(page, within, 'unsure')),
    ];
    all.push(...broken.map((line) => `${theme}: ${line}`));
  }
  await showTheme(page, shown ?? '');
  return all;
}

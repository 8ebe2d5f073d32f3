import { InvalidInput } from '../math/index.ts';
import { quote } from '../math/shapes.ts';

/** What can be shown alone in a host's page. */
export const PARTS = ['scene', 'graph', 'algebra', 'parameters', 'hits', 'caption'] as const;
export type Part = (typeof PARTS)[number];

/** Themes that a link may ask for; without one the device's choice counts. */
export const LINK_THEMES = ['light', 'dark', 'projector'] as const;
export type LinkTheme = (typeof LINK_THEMES)[number];

/** The list that a text with commas names; each must be one of `known`. */
export function listOf<T extends string>(text: string, known: readonly T[], what: string): T[] {
  return text
    .split(',')
    .filter(Boolean)
    .map((name) => {
      const found = known.find((one) => one === name);
      if (found === undefined) throw new InvalidInput(`${quote(name)} is not ${what}`);
      return found;
    });
}

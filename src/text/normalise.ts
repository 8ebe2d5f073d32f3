import { UNSIGNED } from './literal.ts';
import { plainPowers } from './scripts.ts';

/** Replacements of typed spellings by those that are read, in this order. */
const SPELLINGS: readonly (readonly [RegExp, string])[] = [
  [/[\u2212\u2013\uFE63\uFF0D]/g, '-'],
  [/[\u00A0\u2000-\u200A\u202F]/g, ' '],
  [/\*\*/g, '^'],
  [/[·×⋅∙•]/g, '*'],
  [/[÷∕]/g, '/'],
  [/π/g, 'pi'],
  [/∞/g, 'infinity'],
  [/°/g, ' deg'],
  [/\bmath\./g, ''],
  // A decimal comma. A thousands comma cannot be told from it, so '1,234,567' is left with two
  // points and refused.
  [/,(?=\d)/g, '.'],
  // √2^2 is (√2)², as on paper.
  [new RegExp(String.raw`√\s*(${UNSIGNED}|pi\b)`, 'g'), 'sqrt($1)'],
  [/√/g, ' sqrt '],
];

/** The text in the one spelling that is read: '−0,5 · π' → '-0.5 * pi'. */
export function normalise(text: string): string {
  const plain = plainPowers(text.trim().toLowerCase());
  return SPELLINGS.reduce((line, [from, to]) => line.replace(from, to), plain);
}

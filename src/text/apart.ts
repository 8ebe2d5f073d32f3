import { ALL_DIGITS, display } from './format.ts';

/** So many significant digits, or as many more as two doubles need to be printed differently. */
export function digitsToTell(a: number, b: number, least = 6): number {
  for (let digits = least; digits < ALL_DIGITS; digits++) {
    if (a.toPrecision(digits) !== b.toPrecision(digits)) return digits;
  }
  return ALL_DIGITS;
}

/**
 * One or two roots as they are printed: with more digits where so few would make two of them look
 * alike.
 */
export function rootTexts(roots: readonly number[], digits = 6): string[] {
  const [a, b] = roots;
  const alike = a !== undefined && b !== undefined && display(a, digits) === display(b, digits);
  const needed = alike && a !== b ? digitsToTell(a, b, digits) : digits;
  return roots.map((t) => display(t, needed));
}

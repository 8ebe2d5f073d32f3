import { ALL_DIGITS, display } from './format.ts';

/**
 * Number of significant digits, `least` or more, at which two different doubles print differently.
 */
export function digitsToTell(a: number, b: number, least = 6): number {
  for (let digits = least; digits < ALL_DIGITS; digits++) {
    if (a.toPrecision(digits) !== b.toPrecision(digits)) return digits;
  }
  return ALL_DIGITS;
}

/** One or two roots as printed, with more digits if both would print the same. */
export function rootTexts(roots: readonly number[], digits = 6): string[] {
  const [a, b] = roots;
  const alike = a !== undefined && b !== undefined && display(a, digits) === display(b, digits);
  const needed = alike && a !== b ? digitsToTell(a, b, digits) : digits;
  return roots.map((t) => display(t, needed));
}

import { div, fromNumber, isZero, type Surd, sub, toNumber } from '../math/exact.ts';
import { MINUS } from '../text/format.ts';

/**
 * A double has 53 bits: log10 2^53. No number that is rounded to one has more right digits to show.
 */
export const MOST_DIGITS = 15.95;
/** Number of digits with which a marked number is written. */
export const PLACES = 16;
/** Added before rounding down, so that MOST_DIGITS counts as 16 and 7.9 as 7. */
const SLACK = 0.05;

/**
 * Limit for any double but the nearest one: one ulp off always counts as 15 digits, never as 16.
 */
const MOST_BUT_NEAREST = 15.9;

/** −log10 of a relative error, between 0 and MOST_DIGITS; 0 for NaN. */
function digitsOfError(relative: number): number {
  if (relative === 0) return MOST_DIGITS;
  return relative < 1 ? Math.min(MOST_DIGITS, Math.max(0, -Math.log10(relative))) : 0;
}

/**
 * Number of right digits of x, 0 … 15.95. The double nearest to the exact number has all by
 * definition, even where doubles are sparse (subnormals) or end (±Infinity).
 */
export function rightDigits(x: number, exact: Surd): number {
  const nearest = toNumber(exact);
  if (x === nearest) return MOST_DIGITS;
  return Math.min(MOST_BUT_NEAREST, trustedDigits(x, exact));
}

/**
 * Number of right digits of an intermediate result. Other than in `rightDigits` the nearest double
 * is no exception: digits that under- or overflow lose are lost to all later steps.
 */
export function trustedDigits(x: number, exact: Surd): number {
  if (isZero(exact)) return x === 0 ? MOST_DIGITS : 0;
  if (!Number.isFinite(x)) return 0;
  return digitsOfError(Math.abs(toNumber(div(sub(fromNumber(x), exact), exact))));
}

/**
 * The same as `rightDigits` against the correctly rounded number, for many at a time: at most half
 * a unit in the last place apart from `rightDigits`.
 */
export function rightDigitsOfDouble(x: number, nearest: number): number {
  if (x === nearest) return MOST_DIGITS;
  if (!Number.isFinite(x) || !Number.isFinite(nearest) || nearest === 0) return 0;
  return Math.min(MOST_BUT_NEAREST, digitsOfError(Math.abs((x - nearest) / nearest)));
}

/** Right digits as a whole number, 0 … 16: what a table says and what is printed bold. */
export const digitCount = (digits: number): number =>
  Math.min(PLACES, Math.max(0, Math.floor(digits + SLACK)));

/** A number with 16 digits, split after its last right one. */
export interface Marked {
  /** With sign and leading zeros. */
  readonly right: string;
  readonly wrong: string;
  /** Exponent of the power of ten behind it; null if the number is written without one. */
  readonly exponent: number | null;
}

const FIXED_BELOW = 6;
const FIXED_FROM = -4;

/**
 * x in 16 places with `count` digits marked as right: exactly so many digits are in `right`,
 * leading zeros not counted.
 */
export function markDigits(x: number, count: number): Marked {
  if (!Number.isFinite(x)) {
    const text = `${x < 0 ? MINUS : ''}∞`;
    return count > 0
      ? { right: text, wrong: '', exponent: null }
      : { right: '', wrong: text, exponent: null };
  }
  const [figures, power] = scientific(Math.abs(x));
  const outright = x === 0 || (power >= FIXED_FROM && power < FIXED_BELOW);
  const zeros = outright && power < 0 ? `0.${'0'.repeat(-power - 1)}` : '';
  const pointAfter = outright ? (power < 0 ? 0 : power + 1) : 1;
  const lead = (x < 0 || Object.is(x, -0) ? MINUS : '') + zeros;
  const written = (from: number, to: number): string =>
    [...figures.slice(from, to)]
      .map((figure, i) =>
        from + i === pointAfter && from + i > 0 && !zeros ? `.${figure}` : figure,
      )
      .join('');
  const right = count > 0 ? lead + written(0, count) : '';
  const wrong = (count > 0 ? '' : lead) + written(count, PLACES);
  return { right, wrong, exponent: outright ? null : power };
}

/** toExponential rounds the exact value of the double. */
function scientific(x: number): [figures: string, exponent: number] {
  const [mantissa = '', exponent = ''] = x.toExponential(PLACES - 1).split('e');
  return [mantissa.replace('.', ''), Number(exponent)];
}

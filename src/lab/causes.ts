import {
  add,
  compare,
  div,
  fromNumber,
  isZero,
  mul,
  neg,
  type Surd,
  sign,
  sub,
} from '../math/exact.ts';
import { MOST_DIGITS } from './digits.ts';
import type { Operation } from './trace.ts';

/**
 * Why the result of one operation has fewer right digits than what went into it. The first that
 * holds:
 *
 * - input: nothing was computed yet. The number does not fit into the format.
 * - division: what comes out is not finite, and the divisor is 0, or not known to be another
 *   number.
 * - overflow: what comes out is not finite, what went in is.
 * - underflow: a product, square or quotient of what went in is exactly not 0, but below the
 *   smallest normal number of the format, where digits run out. Never a sum: the sum of two
 *   floating-point numbers is exact where it is that small (Hauser 1996).
 * - zero: the sum is exactly 0, and what comes out is not.
 * - total: a sum whose exact value is no larger than the errors that its terms bring along, so that
 *   no digit is left.
 * - cancellation: a sum that is exactly 10^digits times smaller than its largest term, or less;
 *   digits ≥ 1.
 * - rounding: none of these.
 */
export type Cause =
  | { readonly kind: 'input' | 'division' | 'zero' | 'total' | 'rounding' }
  /**
   * `within`: not the result itself overflowed, but a partial sum or product without a line of its
   * own.
   */
  | { readonly kind: 'overflow'; readonly within: boolean }
  /** `flushed`: the number became 0. */
  | { readonly kind: 'underflow'; readonly within: boolean; readonly flushed: boolean }
  | { readonly kind: 'cancellation'; readonly digits: number };

/**
 * Smallest normal and largest number of each format; formats not listed have the doubles' range.
 */
const LEAST_NORMAL: Readonly<Record<string, number>> = { float32: 2 ** -126 };
const LARGEST: Readonly<Record<string, number>> = { float32: (2 - 2 ** -23) * 2 ** 127 };

/** The cause for a method whose numbers are those of the arithmetic `format`. */
export function causeOf(operation: Operation, format: string): Cause {
  if (operation.inputs.length === 0) return { kind: 'input' };
  const links = [operation, ...hiddenIn(operation)];
  const over = links.find(overflows);
  if (over?.expr.op === 'quotient' && !over.inputs[1]?.sign) return { kind: 'division' };
  if (over) return { kind: 'overflow', within: over !== operation || !isBeyond(over, format) };
  const least = LEAST_NORMAL[format] ?? 2 ** -1022;
  const under = links.find((link) => underflows(link, least));
  if (under) return { kind: 'underflow', within: under !== operation, flushed: under.own === 0 };
  return operation.expr.op === 'sum' ? causeOfSum(operation) : { kind: 'rounding' };
}

function causeOfSum(operation: Operation): Cause {
  const { exact, digits } = operation;
  if (exact === null) return { kind: 'rounding' };
  if (isZero(exact)) return { kind: 'zero' };
  if (digits !== null && digits < 1 && compare(size(exact), errorsOf(operation)) <= 0) {
    return { kind: 'total' };
  }
  const cancelled = agreeing(operation);
  return cancelled >= 1 ? { kind: 'cancellation', digits: cancelled } : { kind: 'rounding' };
}

/** Whether the result of finite inputs is not finite. */
export const overflows = ({ own, inputs }: Operation): boolean =>
  !Number.isFinite(own) && inputs.length > 0 && inputs.every((input) => Number.isFinite(input.own));

function underflows(link: Operation, least: number): boolean {
  const truth = Math.abs(link.own) < least && link.expr.op !== 'sum' ? ofOwn(link) : null;
  if (truth === null || isZero(truth)) return false;
  const below = compare(size(truth), fromNumber(least)) < 0;
  return below && compare(truth, fromNumber(link.own)) !== 0;
}

function isBeyond(link: Operation, format: string): boolean {
  const truth = ofOwn(link);
  return truth !== null && compare(size(truth), fromNumber(LARGEST[format] ?? MAX_VALUE)) > 0;
}

/** The exact result for the method's own inputs; null for a root, which cannot leave the range. */
function ofOwn({ expr, inputs }: Operation): Surd | null {
  const numbers = inputs.map(({ own }) => own);
  const [a, b] = numbers;
  if (a === undefined || !numbers.every(Number.isFinite)) return null;
  if (expr.op === 'square') return mul(fromNumber(a), fromNumber(a));
  if (b === undefined) return null;
  if (expr.op === 'sum') {
    return (expr.terms.at(-1)?.sign === 1 ? add : sub)(fromNumber(a), fromNumber(b));
  }
  if (expr.op === 'product') return mul(fromNumber(a), fromNumber(b));
  return expr.op === 'quotient' && b !== 0 ? div(fromNumber(a), fromNumber(b)) : null;
}

/** Sum of the absolute errors of the numbers that enter the last step of the sum. */
function errorsOf({ inputs }: Operation): Surd {
  return inputs.reduce(
    (sum, { own, exact }) =>
      exact !== null && Number.isFinite(own) ? add(sum, size(sub(fromNumber(own), exact))) : sum,
    fromNumber(0),
  );
}

/** Number of powers of ten between the exact sum and its largest exact term; at most all digits. */
function agreeing(operation: Operation): number {
  const terms = inputsOf(operation).flatMap(({ exact }) => (exact === null ? [] : [size(exact)]));
  const largest = terms.reduce((most, term) => (compare(term, most) > 0 ? term : most));
  let left = size(operation.exact as Surd);
  let digits = -1;
  while (digits < 2 * MOST_DIGITS && compare(left, largest) <= 0) {
    digits += 1;
    left = mul(left, TEN);
  }
  return Math.max(0, digits);
}

const { MAX_VALUE } = Number;
const TEN = fromNumber(10);
export const size = (x: Surd): Surd => (sign(x) < 0 ? neg(x) : x);

/**
 * A partial sum of a longer sum, or partial product of a longer product, gets no line of its own.
 */
export function absorbedBy({ expr, inputs }: Operation): readonly Operation[] {
  const [first] = inputs;
  const grew = first && first.letter === null && first.expr.op === expr.op;
  return grew && (expr.op === 'sum' || expr.op === 'product') ? [first] : [];
}

/** The partial sums or products that have no line of their own. */
const hiddenIn = (operation: Operation): readonly Operation[] =>
  absorbedBy(operation).flatMap((part) => [part, ...hiddenIn(part)]);

/** The terms or factors of the whole sum or product, instead of its partial sums or products. */
export function inputsOf(operation: Operation): readonly Operation[] {
  const [first, ...rest] = operation.inputs;
  return first && absorbedBy(operation).includes(first)
    ? [...inputsOf(first), ...rest]
    : operation.inputs;
}

import { decimalDigits, type Surd } from '../math/exact.ts';
import { type Derivation, exact, type Step } from '../math/formula.ts';
import type { Intersection } from '../math/index.ts';
import { digitsToTell } from '../text/distinguish.ts';
import {
  CERTAIN_DIGITS,
  type DisplayParts,
  display,
  displayParts,
  inOne,
  MINUS,
} from '../text/format.ts';
import type { ExactResult } from './exact-result.ts';

const DIGITS = 6;
/** The largest and the smallest positive double, as texts. */
const LARGEST = display(Number.MAX_VALUE, 2);
const SMALLEST = display(Number.MIN_VALUE, 2);

/** How a result stands on the page. */
interface ShownResult {
  /**
   * Shown in place of the double's digits if it overflowed, is NaN, or is a 0 that is not exact.
   */
  readonly text: string | null;
  /** Words beside the number. */
  readonly beside: string | null;
}

/**
 * Whether the method decides by more than the doubles it shows. A float method (`formula`) decides
 * by them: its 0 and its ∞ count as such.
 */
const knowsMore = ({ decidedBy }: Pick<Intersection, 'decidedBy'>): boolean =>
  decidedBy !== 'formula';

/** A step's value by the chosen method, with what has to stand beside it. */
export function shownResult(
  id: string,
  value: number,
  found: Pick<Intersection, 'decidedBy'>,
  { quantities }: ExactResult,
): ShownResult {
  const exactly = quantities[id];
  if (exactly === undefined) return { text: null, beside: null };
  if (Number.isNaN(value)) return { text: 'no value', beside: `exact: ${exactText(exactly)}` };
  const rounded = exact.toNumber(exactly);
  if (knowsMore(found) && isOutOfRange(value, exactly) && Object.is(value + 0, rounded + 0)) {
    return { text: exactText(exactly), beside: null };
  }
  const text = exactBeside(value, rounded, exactly);
  return { text: null, beside: text && `exact: ${text}` };
}

const isOutOfRange = (value: number, exactly: Surd): boolean =>
  !Number.isFinite(value) || (value === 0 && exact.sign(exactly) !== 0);

/** Which results are out of the doubles' range, and how they were solved; null if none is. */
export function rangeNote(
  { steps }: Pick<Derivation, 'steps'>,
  found: Intersection,
  { quantities }: ExactResult,
): string | null {
  const over = steps.filter(({ value }) => value !== null && !Number.isFinite(value));
  const under = steps.filter(({ id, value }) => {
    const exactly = quantities[id];
    return value === 0 && exactly && knowsMore(found) && exact.sign(exactly) !== 0;
  });
  const parts = [
    ...(over.length > 0 ? [`${named(over)} beyond ${LARGEST}`] : []),
    ...(under.length > 0 ? [`${named(under)} below ${SMALLEST}`] : []),
  ];
  if (parts.length === 0) return null;
  const how = found.decidedBy === 'exact' ? '; solved exactly' : '';
  return `${parts.join(', ')} as a double${how}`;
}

const named = (steps: readonly Step[]): string =>
  steps.map(({ id }) => id.replace('.', '·').replace('-', ` ${MINUS} `)).join(', ');

/**
 * The exact digits beside a number whose shown digits differ from them: so many that the difference
 * shows; null if they are the same. `exactly`, if known, gives digits also beyond the doubles.
 */
export function exactBeside(value: number, rounded: number, exactly?: Surd): string | null {
  if (value === rounded && (value !== 0 || !exactly || exact.sign(exactly) === 0)) return null;
  const isBeyond = !Number.isFinite(rounded) || (rounded === 0 && exactly !== undefined);
  if (isBeyond) return exactly ? exactText(exactly) : display(rounded);
  if (display(value) === display(rounded)) return null;
  return display(rounded, digitsToTell(value, rounded));
}

/** Six digits of an exact number, also beyond the doubles. */
export const exactText = (a: Surd): string => inOne(exactParts(a));

export function exactParts(a: Surd): DisplayParts {
  const rounded = exact.toNumber(a);
  if (exact.sign(a) === 0 || (Number.isFinite(rounded) && rounded !== 0)) {
    return displayParts(rounded);
  }
  const { negative, digits, exponent } = decimalDigits(a, DIGITS);
  const more = decimalDigits(a, CERTAIN_DIGITS).digits;
  // As `display` does it: zeros at the end are kept if digits were rounded away.
  const figures = /^0*$/.test(more.slice(DIGITS)) ? digits.replace(/0+$/, '') : digits;
  const fraction = figures.slice(1);
  const mantissa = `${negative ? MINUS : ''}${figures.charAt(0)}${fraction ? `.${fraction}` : ''}`;
  return { mantissa, exponent };
}

/** The distance of two roots that are the same in six digits; null for other roots. */
export function rootGap(found: Intersection, exactly: ExactResult): string | null {
  const [first, second] = found.hits;
  if (!first || !second || display(first.t) !== display(second.t)) return null;
  const { A, D } = exactly.quantities;
  if (exactly.found.class === 'two' && A && D) {
    const size = exact.sign(A) < 0 ? exact.neg(A) : A;
    return `exact: t₂ − t₁ = ${exactText(exact.div(exact.sqrt(D), size))}`;
  }
  return first.t === second.t ? 't₁ and t₂ are the same number here' : null;
}

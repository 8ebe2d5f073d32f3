import {
  asPrinted,
  asSurd,
  type ConditionStep,
  type Derivation,
  type Expr,
  isWritable,
  type Ratio,
  ratios,
  recomputed,
  reproduces,
  type Step,
  type Values,
  type Written,
} from '../math/formula.ts';
import type { Intersection } from '../math/index.ts';
import { exactText, shownResult } from './exact-digits.ts';
import type { Exactly } from './exactly.ts';
import { rootsOf } from './window.ts';

/** How a line is written with its numbers put in. */
export interface PutIn {
  readonly digits: number;
  /**
   * Whether its printed numbers give the printed result in all its digits; else it is written with
   * ≈.
   */
  readonly isFaithful: boolean;
}

/**
 * Digits of a number in a line: six as everywhere, more where the result needs them, fewer where
 * there is no room.
 */
const MORE = [6, 7, 8, 9, 10, 11, 12, 13, 14, 15, 17] as const;
const FEWER = [5, 4] as const;
/** Of a line that no number of digits makes faithful. */
const COMPACT = [6, 5, 4, 3] as const;

/**
 * The digits that make the line give its result when it is worked out again, in the first of the
 * spaces that they fit into; and without such digits as many as fit, for a line with ≈. Null where
 * a number of the line is not finite.
 */
export function putIn<Space>(
  step: Pick<Step, 'expr' | 'worked'>,
  { numbers }: Pick<Derivation, 'numbers'>,
  results: readonly Result[],
  spaces: readonly Space[],
  fits: (digits: number, space: Space) => boolean,
): (PutIn & { readonly space: Space | null }) | null {
  const { expr, worked } = step;
  if (!isWritable(expr, numbers, worked)) return null;
  const known = new Map<number, boolean>();
  const isFaithful = (digits: number): boolean => {
    const before = known.get(digits);
    if (before !== undefined) return before;
    const now = givesAll(expr, numbers, { worked, digits }, results);
    known.set(digits, now);
    return now;
  };
  for (const space of spaces) {
    for (const digits of [...MORE, ...FEWER]) {
      if (fits(digits, space) && isFaithful(digits)) return { digits, isFaithful: true, space };
    }
  }
  for (const space of spaces) {
    const digits = COMPACT.find((n) => fits(n, space));
    if (digits !== undefined) return { digits, isFaithful: false, space };
  }
  return { digits: 2, isFaithful: false, space: null };
}

/** Whether the line as it is printed gives each of its results in all printed digits. */
const givesAll = (
  expr: Expr,
  numbers: Values<number>,
  written: Written,
  results: readonly Result[],
): boolean =>
  results.every(({ value, branch, text }) =>
    text === null
      ? reproduces(expr, numbers, written, value, branch)
      : exactTextOf(recomputed(expr, numbers, written, branch)) === text,
  );

/**
 * One number of digits for lines that are written side by side, a point's components or both sides
 * of a condition, where room is no matter. Null where a number of them is not finite.
 */
export function putInSideBySide(
  lines: readonly { readonly expr: Expr; readonly results: readonly Result[] }[],
  numbers: Values<number>,
  worked: boolean,
): PutIn | null {
  if (!lines.every(({ expr }) => isWritable(expr, numbers, worked))) return null;
  const digits = MORE.find((n) =>
    lines.every(({ expr, results }) => givesAll(expr, numbers, { worked, digits: n }, results)),
  );
  return { digits: digits ?? 6, isFaithful: digits !== undefined };
}

const exactTextOf = (x: Ratio | null): string | null => x && exactText(asSurd(x));

/** A number that a line ends with, and the sign that it takes at ±. */
interface Result {
  readonly value: number;
  /** What is printed for a number that no double can hold. */
  readonly text: string | null;
  readonly branch: 1 | -1;
}

/** What a line has to give: its one value, or for ± the smaller root and the larger one. */
export function valuesAsResults(values: readonly number[], A: number | undefined): Result[] {
  const first = values.length === 2 && !(A !== undefined && A < 0) ? -1 : 1;
  return values.map((value, i) => ({
    value,
    text: null,
    branch: i === 0 ? first : first === 1 ? -1 : 1,
  }));
}

/** What the line has to give: its value, or for t the roots that are listed below. */
export function resultsOf({ id, value }: Step, found: Intersection, exactly: Exactly): Result[] {
  if (value !== null) {
    return [{ value, text: shownResult(id, value, found, exactly).text, branch: 1 }];
  }
  const { details } = found;
  return valuesAsResults(rootsOf(found), details.family === 'curved' ? details.A : undefined);
}

/**
 * The digits with which two numbers compare as printed as was decided of them; undefined where none
 * do.
 */
export const comparableDigits = (
  left: number,
  right: number,
  holds: boolean,
): number | undefined =>
  [left, right].every(Number.isFinite)
    ? MORE.find((n) => isAtMost(asPrinted(left, n), asPrinted(right, n)) === holds)
    : undefined;

const isAtMost = (a: Ratio, b: Ratio): boolean => ratios.sign(ratios.sub(a, b)) <= 0;

/**
 * The digits with which a condition, put in and read as it stands, says what the method decided.
 */
export function conditionDigits(
  { relation, left, right, holds }: ConditionStep,
  numbers: Values<number>,
): PutIn {
  const agrees = (digits: number): boolean => {
    const [a, b] = sides(digits);
    return a != null && b != null && isAtMost(a, b) === holds;
  };
  // Of a length only the value is told.
  const sides = (digits: number): (Ratio | null)[] =>
    relation.left.op === 'norm'
      ? [left, right].map((x) => (Number.isFinite(x) ? asPrinted(x, digits) : null))
      : [relation.left, relation.right].map((e) =>
          recomputed(e, numbers, { worked: false, digits }),
        );
  const digits = [5, ...MORE].find(agrees);
  return digits === undefined
    ? { digits: 5, isFaithful: holds === null }
    : { digits, isFaithful: true };
}

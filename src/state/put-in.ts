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
import { ALL_DIGITS } from '../text/format.ts';
import { exactText, shownResult } from './exact-digits.ts';
import type { ExactResult } from './exact-result.ts';
import { rootsOf } from './graph-window.ts';

/** How a formula is written with numbers put in for its symbols. */
export interface PutIn {
  readonly digits: number;
  /** Whether the printed numbers give the printed result in all digits; else ≈ is written for =. */
  readonly isFaithful: boolean;
}

/** Digits to try for the numbers of a line: six, more if the result needs them, fewer for space. */
const MORE = [6, 7, 8, 9, 10, 11, 12, 13, 14, 15, 17] as const;
const FEWER = [5, 4] as const;
/** Digits to try for a line that no number of digits makes faithful. */
const COMPACT = [6, 5, 4, 3] as const;

/**
 * The digits (six, else more, else fewer) with which a line, evaluated as printed, gives its
 * printed result, in the first of the spaces into which it fits. If there are none: as many as fit,
 * and ≈. Null if a number of the line is not finite.
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
 * A common number of digits for lines side by side (a point's components, both sides of a
 * condition), without a limit of space but `most` digits at most. Null if one of their numbers is
 * not finite.
 */
export function putInSideBySide(
  lines: readonly { readonly expr: Expr; readonly results: readonly Result[] }[],
  numbers: Values<number>,
  worked: boolean,
  most = ALL_DIGITS,
): PutIn | null {
  if (!lines.every(({ expr }) => isWritable(expr, numbers, worked))) return null;
  const digits = MORE.find(
    (n) =>
      n <= most &&
      lines.every(({ expr, results }) => givesAll(expr, numbers, { worked, digits: n }, results)),
  );
  return { digits: digits ?? 6, isFaithful: digits !== undefined };
}

const exactTextOf = (x: Ratio | null): string | null => x && exactText(asSurd(x));

/** The result of a line, and the sign at ± that gives it. */
interface Result {
  readonly value: number;
  /** What is printed if the number is out of the doubles' range; null otherwise. */
  readonly text: string | null;
  readonly branch: 1 | -1;
}

/** The results of a line: its value, or for ± the smaller and the larger root. */
export function valuesAsResults(values: readonly number[], A: number | undefined): Result[] {
  const first = values.length === 2 && !(A !== undefined && A < 0) ? -1 : 1;
  return values.map((value, i) => ({
    value,
    text: null,
    branch: i === 0 ? first : first === 1 ? -1 : 1,
  }));
}

/** The results of a step's line: its value, or for t the roots. */
export function resultsOf(
  { id, value }: Step,
  found: Intersection,
  exactly: ExactResult,
): Result[] {
  if (value !== null) {
    return [{ value, text: shownResult(id, value, found, exactly).text, branch: 1 }];
  }
  const { details } = found;
  return valuesAsResults(rootsOf(found), details.family === 'curved' ? details.A : undefined);
}

/** The digits at which two numbers, as printed, compare as `holds` says; undefined if none do. */
export const comparableDigits = (
  left: number,
  right: number,
  holds: boolean,
): number | undefined =>
  [left, right].every(Number.isFinite)
    ? MORE.find((n) => isAtMost(asPrinted(left, n), asPrinted(right, n)) === holds)
    : undefined;

const isAtMost = (a: Ratio, b: Ratio): boolean => ratios.sign(ratios.sub(a, b)) <= 0;

/** The digits at which a condition, read as printed, holds or fails as the method decided. */
export function conditionDigits(
  { relation, left, right, holds }: ConditionStep,
  numbers: Values<number>,
): PutIn {
  const agrees = (digits: number): boolean => {
    const [a, b] = sides(digits);
    return a != null && b != null && isAtMost(a, b) === holds;
  };
  // For a norm the page shows the value without the formula.
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

import { asSurd, type Ratio, ratios } from '../math/arithmetic/ratios.ts';
import type { ConditionStep, Derivation, Step } from '../math/derivation.ts';
import type { Values } from '../math/formula/evaluate.ts';
import { asPrinted, isWritable, recomputed, reproduces } from '../math/formula/recompute.ts';
import type { Intersection } from '../math/intersection.ts';
import { type Exactly, exactText, shownResult } from './exact-digits.ts';
import { rootsOf } from './window.ts';

/** How a line is written with its numbers put in. */
export interface PutIn {
  readonly digits: number;
  /** Whether its printed numbers give the printed result in all its digits; else it is written with ≈. */
  readonly isFaithful: boolean;
}

/** Digits of a number in a line: six as everywhere, more where the result needs them, fewer where there is no room. */
const MORE = [6, 7, 8, 9, 10, 11, 12, 13, 14, 15, 17] as const;
const FEWER = [5, 4] as const;
/** Of a line that no number of digits makes faithful. */
const COMPACT = [6, 5, 4, 3] as const;

/**
 * The digits that make the line give its result when it is worked out again, in the first of the rooms that they fit
 * into; and without such digits as many as fit, for a line with ≈. Null where a number of the line is not finite.
 */
export function putIn<Room>(
  step: Pick<Step, 'expr' | 'worked'>,
  { numbers }: Derivation,
  results: readonly Result[],
  rooms: readonly Room[],
  fits: (digits: number, room: Room) => boolean,
): (PutIn & { readonly room: Room | null }) | null {
  const { expr, worked } = step;
  if (!isWritable(expr, numbers, worked)) return null;
  const known = new Map<number, boolean>();
  const isFaithful = (digits: number): boolean => {
    const before = known.get(digits);
    if (before !== undefined) return before;
    const now = results.every(({ value, branch, text }) =>
      text === null
        ? reproduces(expr, numbers, { worked, digits }, value, branch)
        : exactTextOf(recomputed(expr, numbers, { worked, digits }, branch)) === text,
    );
    known.set(digits, now);
    return now;
  };
  for (const room of rooms) {
    for (const digits of [...MORE, ...FEWER]) {
      if (fits(digits, room) && isFaithful(digits)) return { digits, isFaithful: true, room };
    }
  }
  for (const room of rooms) {
    const digits = COMPACT.find((n) => fits(n, room));
    if (digits !== undefined) return { digits, isFaithful: false, room };
  }
  return { digits: 2, isFaithful: false, room: null };
}

const exactTextOf = (x: Ratio | null): string | null => x && exactText(asSurd(x));

/** A number that a line ends with, and the sign that it takes at ±. */
export interface Result {
  readonly value: number;
  /** What is printed for a number that no double can hold. */
  readonly text: string | null;
  readonly branch: 1 | -1;
}

/** What the line has to give: its value, or for t the roots that are listed below. */
export function resultsOf({ id, value }: Step, found: Intersection, exactly: Exactly): Result[] {
  if (value !== null) {
    return [{ value, text: shownResult(id, value, found, exactly).text, branch: 1 }];
  }
  const { details } = found;
  const roots = rootsOf(found);
  const downwards = details.family === 'curved' && details.A < 0;
  const first = roots.length === 2 && !downwards ? -1 : 1;
  return roots.map((t, i) => ({
    value: t,
    text: null,
    branch: i === 0 ? first : first === 1 ? -1 : 1,
  }));
}

/** The digits with which a condition, put in and read as it stands, says what the method decided. */
export function conditionDigits(
  { relation, left, right, holds }: ConditionStep,
  numbers: Values<number>,
): PutIn {
  const agrees = (digits: number): boolean => {
    const [a, b] = sides(digits);
    return a != null && b != null && ratios.sign(ratios.sub(a, b)) <= 0 === holds;
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

import { type Arithmetic, bySign } from '../arithmetic/arithmetic.ts';
import { A, B, C, D, DOUBLE_ROOT, LINEAR_ROOT, ROOTS, TWO } from '../formula/common.ts';
import { evaluate, type Values } from '../formula/evaluate.ts';
import type { Expr, Term } from '../formula/expr.ts';
import type { Verdict } from '../intersection.ts';

/** The solution of A t² + B t + C = 0 in an arithmetic. */
interface Solved<T> {
  readonly class: Verdict;
  readonly D: T;
  /** Ascending; one for a tangent. */
  readonly roots: readonly T[];
}

/**
 * A formula for both roots of A t² + B t + C, for A ≠ 0 and D > 0, in any order. D is given: a
 * method may know a better one than B² − 4AC.
 */
export type Solver = <T>(values: Values<T>, ar: Arithmetic<T>) => readonly [T, T];

/**
 * The course's case distinction around a formula for the two roots: A = 0 leaves a line, and the
 * sign of D decides. Nothing is compared with an epsilon: where the arithmetic's own value is zero,
 * it is taken for zero.
 *
 * @param solver what is asked where there are two roots.
 * @param A of the arithmetic, as B, C and D: D may be another than B² − 4AC.
 * @param ar the number system.
 * @example
 * solveBy(textbookSolver, 1, -20, 84, 64, float64).roots; // → [6, 14]
 */
export function solveBy<T>(solver: Solver, A: T, B: T, C: T, D: T, ar: Arithmetic<T>): Solved<T> {
  const values = { scalars: { A, B, C, D }, vectors: {} };
  const signA = ar.sign(A);
  const signD = ar.sign(D);
  if (Number.isNaN(signA)) return { class: 'undecided', D, roots: [] };
  if (signA === 0) return { ...solveLinear(A, B, C, ar), D };
  if (Number.isNaN(signD)) return { class: 'undecided', D, roots: [] };
  if (signD < 0) return { class: 'none', D, roots: [] };
  if (signD === 0) return { class: 'tangent', D, roots: [evaluate(DOUBLE_ROOT, ar, values)] };
  return { class: 'two', D, roots: ascending(solver(values, ar), ar) };
}

function solveLinear<T>(A: T, B: T, C: T, ar: Arithmetic<T>): Pick<Solved<T>, 'class' | 'roots'> {
  const signB = ar.sign(B);
  const signC = ar.sign(C);
  if (Number.isNaN(signB)) return { class: 'undecided', roots: [] };
  if (signB !== 0) {
    const values = { scalars: { A, B, C }, vectors: {} };
    return { class: 'one', roots: [evaluate(LINEAR_ROOT, ar, values)] };
  }
  if (Number.isNaN(signC)) return { class: 'undecided', roots: [] };
  return { class: signC === 0 ? 'contained' : 'none', roots: [] };
}

/** In ascending order; compared as doubles where t − s overflows. */
function ascending<T>([t, s]: readonly [T, T], ar: Arithmetic<T>): readonly [T, T] {
  if (ar.sorted) return ar.sorted(t, s);
  const sign = ar.sign(ar.sub(t, s));
  const swapped = Number.isNaN(sign) ? ar.toNumber(t) > ar.toNumber(s) : sign > 0;
  return swapped ? [s, t] : [t, s];
}

/**
 * t = (−B ± √D) / 2A as it stands.
 *
 * @param values of A, B, C and D.
 * @param ar the number system.
 * @example
 * textbookSolver({ scalars: { A: 1, B: -20, C: 84, D: 64 }, vectors: {} }, float64); // → [6, 14]
 */
export const textbookSolver: Solver = (values, ar) => [
  evaluate(ROOTS, ar, values, -1),
  evaluate(ROOTS, ar, values, 1),
];

const Q: Expr = { op: 'scalar', id: 'q' };
const ROOT_OF_D: Expr = { op: 'root', of: D };
const AWAY_FROM_B: readonly Term[] = [
  { sign: 1, expr: ROOT_OF_D },
  { sign: -1, expr: B },
];
const WITH_B: readonly Term[] = [
  { sign: 1, expr: B },
  { sign: 1, expr: ROOT_OF_D },
];

/** q = −(B + √D)/2 for B ≥ 0 and (√D − B)/2 for B < 0: B and √D never cancel. */
export const STABLE_Q: readonly [Expr, Expr] = [
  { op: 'quotient', over: { op: 'negative', of: { op: 'sum', terms: WITH_B } }, under: TWO },
  { op: 'quotient', over: { op: 'sum', terms: AWAY_FROM_B }, under: TWO },
];

/** t = q/A and t = C/q; q = 0 needs B = D = 0, and then the roots are equal. */
export const STABLE_ROOTS: readonly [Expr, Expr] = [
  { op: 'quotient', over: Q, under: A },
  { op: 'quotient', over: C, under: Q },
];

/** The larger root by addition only, the other one from their product C/A. */
export const stableSolver: Solver = (values, ar) => {
  const of = (which: 0 | 1) => evaluate(STABLE_Q[which], ar, values);
  const q = bySign(
    values.scalars.B ?? ar.of(0),
    () => of(1),
    () => of(0),
    ar,
  );
  const withQ = { scalars: { ...values.scalars, q }, vectors: {} };
  return [evaluate(STABLE_ROOTS[0], ar, withQ), evaluate(STABLE_ROOTS[1], ar, withQ)];
};

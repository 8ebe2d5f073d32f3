import { NONE, TWO } from '../../batch/batch.ts';
import type { RootSlot } from '../../batch/exact-quadric.ts';
import { scale } from '../../float/bits.ts';
import * as dd from '../../float/double-double.ts';
import { FAITHFUL } from './faithful.ts';
import { nearSurface } from './near-surface.ts';
import {
  ABSOLUTE_ERROR,
  DISCRIMINANT_ERROR,
  ERROR_A,
  ERROR_B,
  ERROR_C,
  ERROR_QUOTIENT,
  ERROR_ROOT,
  ERROR_SUM,
} from './slow-bounds.ts';
import {
  A,
  B,
  BOUND,
  C,
  D,
  discriminant,
  FLARE,
  get,
  PX,
  PY,
  PZ,
  R,
  RHO,
  S,
  setA,
  setB,
  setC,
  T,
  U,
  X,
  Y,
  Z,
} from './slow-registers.ts';

export const UNKNOWN = -1;

/** Everything is in the registers; t counts in 2^e. */
export function solveScaled(e: number, slot: RootSlot): number {
  setA();
  discriminant();
  const size = Math.abs(get(FLARE));
  const Am = get(X) ** 2 + get(Z) ** 2 + size * get(Y) ** 2;
  const Cm = get(PX) ** 2 + get(PZ) ** 2 + size * get(PY) ** 2 + get(RHO);
  const error = DISCRIMINANT_ERROR * Am * Cm + ABSOLUTE_ERROR;
  const d = get(D);
  if (!(Math.abs(d) > error)) return UNKNOWN;
  return d < 0 ? NONE : roots(e, Am, Cm, error, slot);
}

/**
 * q = −(b + √D) with b's sign, then q/A and C/q. |δ√D| ≤ δD/√D for any δD < D, and the root's own; δq adds δb and a sum. Then what the other operand is off,
 * and the quotient's own. Products of two such errors are nothing to the half of u/2 that FAITHFUL leaves.
 */
function roots(e: number, Am: number, Cm: number, errorD: number, slot: RootSlot): number {
  setB();
  setC();
  dd.sqrt(R, D, D);
  const s = get(D);
  const negative = get(B) < 0;
  if (negative) dd.sub(R, U, D, B);
  else {
    dd.add(R, U, B, D);
    dd.neg(R, U, U);
  }
  const size = Math.abs(get(U));
  const errorQ =
    (ERROR_B * Math.sqrt(Am * Cm) + errorD / s + ERROR_ROOT * s + ABSOLUTE_ERROR) / size +
    ERROR_SUM;
  const errorC = (ERROR_C * Cm + ABSOLUTE_ERROR) / Math.abs(get(C));
  // A = 0 makes it 'one' and not 'two': where A is known to so many digits it is not 0.
  const errorA = (ERROR_A * Am + ABSOLUTE_ERROR) / Math.abs(get(A));
  R[BOUND] = errorQ + errorA + ERROR_QUOTIENT;
  if (!(get(BOUND) < FAITHFUL)) return UNKNOWN;
  R[BOUND + 1] = errorQ + errorC + ERROR_QUOTIENT;
  if (!(get(BOUND + 1) < FAITHFUL)) {
    R[BOUND + 1] = errorQ + nearSurface(Cm) + ERROR_QUOTIENT;
    if (!(get(BOUND + 1) < FAITHFUL)) return UNKNOWN;
  }
  dd.div(R, S, U, A);
  if (get(C) === 0) dd.set(R, T, 0);
  else dd.div(R, T, C, U);
  // Rounding twice, to 53 bits and then into the subnormals, stays faithful: a neighbour in the coarser grid is one in the finer.
  const t = scale(get(S), e);
  const other = scale(get(T), e);
  const ascending = get(S) <= get(T);
  slot.t0 = ascending ? t : other;
  slot.t1 = ascending ? other : t;
  return TWO;
}

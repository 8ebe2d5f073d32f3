import { NONE, TWO } from '../../batch/batch.ts';
import type { RootSlot } from '../../batch/exact-quadric.ts';
import { scale } from '../../float/bits.ts';
import * as dd from '../../float/double-double.ts';
import { nearSurface } from './near-surface.ts';
import { ABSOLUTE_ERROR, DISCRIMINANT_ERROR, EPSILON, FAITHFUL } from './slow-bounds.ts';
import {
  A,
  B,
  C,
  D,
  discriminant,
  FLARE,
  form,
  get,
  PX,
  PY,
  PZ,
  R,
  RHO,
  S,
  T,
  U,
  X,
  Y,
  Z,
} from './slow-registers.ts';

export const UNKNOWN = -1;

/** Everything is in the registers; t counts in 2^e. */
export function solveScaled(e: number, slot: RootSlot): number {
  form(A, X, X, Y, Y, Z, Z);
  discriminant();
  const size = Math.abs(get(FLARE));
  const Am = get(X) ** 2 + get(Z) ** 2 + size * get(Y) ** 2;
  const Cm = get(PX) ** 2 + get(PZ) ** 2 + size * get(PY) ** 2 + get(RHO);
  const error = DISCRIMINANT_ERROR * Am * Cm + ABSOLUTE_ERROR;
  const d = get(D);
  if (!(Math.abs(d) > error)) return UNKNOWN;
  // A = 0 makes it 'one' and not 'two': A must be known not to vanish.
  const a = Math.abs(get(A));
  const errorA = 4 * EPSILON * Am + ABSOLUTE_ERROR;
  if (d < 0) return NONE;
  if (!(a > errorA)) return UNKNOWN;
  return roots(e, a, errorA, Am, Cm, error, slot);
}

/**
 * q = −(b + √D) with b's sign, then q/A and C/q. |δ√D| ≤ δD/√D + 4ε√D, twice what is needed (√(D + δ) − √D ≤ δ/(2√D)·(1 + …) for δ ≪ D, and
 * δD/√D for any δ < D); δq adds 5ε bm and a sum's ε|q|. The quotients' own error is under 2ε.
 */
function roots(
  e: number,
  a: number,
  errorA: number,
  Am: number,
  Cm: number,
  errorD: number,
  slot: RootSlot,
): number {
  form(B, X, PX, Y, PY, Z, PZ);
  form(C, PX, PX, PY, PY, PZ, PZ);
  dd.sub(R, C, C, RHO);
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
    (5 * EPSILON * Math.sqrt(Am * Cm) + errorD / s + 4 * EPSILON * s + ABSOLUTE_ERROR) / size +
    EPSILON;
  const c = Math.abs(get(C));
  const large = errorQ + errorA / a + 2 * EPSILON;
  if (!(large < FAITHFUL)) return UNKNOWN;
  const small = errorQ + (6 * EPSILON * Cm + ABSOLUTE_ERROR) / c + 2 * EPSILON;
  if (!(small < FAITHFUL) && !nearSurface(errorQ, Cm)) return UNKNOWN;
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

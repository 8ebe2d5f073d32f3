import { CONTAINED, NONE, ONE, TANGENT, TWO, UNDECIDED } from './batch.ts';
import type { Quadric } from './quadric.ts';

/**
 * What the course's formula makes of one ray, written out operation by operation in the order of
 * its trees.
 */
interface CurvedSlot {
  A: number;
  B: number;
  C: number;
  D: number;
  t0: number;
  t1: number;
}

export const curvedSlot = (): CurvedSlot => ({ A: 0, B: 0, C: 0, D: 0, t0: 0, t1: 0 });

const finite = (x: number): boolean => x - x === 0;

/** A, B, C in float64. */
function textbookCoefficients(
  q: Quadric,
  Ex: number,
  Ey: number,
  Ez: number,
  dx: number,
  dy: number,
  dz: number,
  slot: CurvedSlot,
): void {
  const px = Ex - q.Cx;
  const pz = Ez - q.Cz;
  let A = dx * dx + dz * dz;
  let B = 2 * dx * px + 2 * dz * pz;
  let C = px * px + pz * pz;
  if (q.hasY) {
    const a = q.squared ? q.flare * q.flare : q.flare;
    const py = Ey - q.Cy;
    A -= a * (dy * dy);
    B -= 2 * a * dy * py;
    C -= a * (py * py);
  }
  if (q.hasR) C -= q.r * q.r;
  slot.A = A;
  slot.B = B;
  slot.C = C;
  slot.D = B * B - 4 * A * C;
}

/**
 * The case distinction of methods/solvers.ts on the slot's A, B, C, D; roots ascending, NaN where
 * there is none.
 */
function solveSlot(slot: CurvedSlot, stable: boolean): number {
  const { A, B, C, D } = slot;
  slot.t0 = Number.NaN;
  slot.t1 = Number.NaN;
  if (!finite(A)) return UNDECIDED;
  if (A === 0) return solveLinear(slot);
  if (!finite(D)) return UNDECIDED;
  if (D < 0) return NONE;
  if (D === 0) return keep(slot, TANGENT, -B / (2 * A), Number.NaN);
  const s = Math.sqrt(D);
  if (!stable) return keepTwo(slot, (-B - s) / (2 * A), (-B + s) / (2 * A));
  const q = B < 0 ? (s - B) / 2 : -(B + s) / 2;
  return keepTwo(slot, q / A, C / q);
}

function solveLinear(slot: CurvedSlot): number {
  const { B, C } = slot;
  if (!finite(B)) return UNDECIDED;
  if (B !== 0) return keep(slot, ONE, -C / B, Number.NaN);
  if (!finite(C)) return UNDECIDED;
  return C === 0 ? CONTAINED : NONE;
}

function keepTwo(slot: CurvedSlot, t: number, s: number): number {
  if (!finite(t) || !finite(s)) return UNDECIDED;
  return t > s ? keep(slot, TWO, s, t) : keep(slot, TWO, t, s);
}

/** A root that overflowed, or is NaN, is no answer. */
function keep(slot: CurvedSlot, verdict: number, t0: number, t1: number): number {
  if (!finite(t0)) return UNDECIDED;
  slot.t0 = t0;
  slot.t1 = t1;
  return verdict;
}

/**
 * Whether a hit at t has a normal: a·(y − Cy) is NaN if the point is so far away that y overflows
 * and a is 0. Then the tree-walked method answers 'undecided', and so must the fast forms.
 */
function hasNormal(q: Quadric, Ey: number, dy: number, t: number): boolean {
  if (!vanishingFlare(q)) return true;
  return Number.isNaN(t) || finite(Ey + t * dy - q.Cy);
}

/** A formula with a term in y whose a is 0 in float64. */
const vanishingFlare = (q: Quadric): boolean =>
  q.hasY && (q.flare === 0 || (q.squared && q.flare * q.flare === 0));

/** The whole answer for one ray. */
export function solveCurved(
  q: Quadric,
  Ex: number,
  Ey: number,
  Ez: number,
  dx: number,
  dy: number,
  dz: number,
  slot: CurvedSlot,
  stable: boolean,
): number {
  textbookCoefficients(q, Ex, Ey, Ez, dx, dy, dz, slot);
  const verdict = solveSlot(slot, stable);
  if (verdict === NONE || verdict === CONTAINED || verdict === UNDECIDED) return verdict;
  if (hasNormal(q, Ey, dy, slot.t0) && hasNormal(q, Ey, dy, slot.t1)) return verdict;
  slot.t0 = Number.NaN;
  slot.t1 = Number.NaN;
  return UNDECIDED;
}

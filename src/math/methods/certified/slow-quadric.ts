import { TWO } from '../../batch/batch.ts';
import { type RootSlot, solveExactly } from '../../batch/exact-quadric.ts';
import type { Quadric } from '../../batch/quadric.ts';
import { exponentOf, scale } from '../../float/bits.ts';
import type { Ray } from '../../ray.ts';
import type { Vec3 } from '../../vec3.ts';
import { plainRoots, UNKNOWN } from './plain-roots.ts';

/** Roots and the stage that stood for them. */
export interface CertifiedSlot extends RootSlot {
  exact: boolean;
}

export const certifiedSlot = (): CertifiedSlot => ({
  t0: Number.NaN,
  t1: Number.NaN,
  exact: false,
});

/** max |d| and the largest length between 2^-40 and 2^40: a scale would change nothing. */
export const ORDINARY = 2 ** 40;
const ordinary = (x: number): boolean => x < ORDINARY && x > 1 / ORDINARY;

/** One ray that the filters left open; returns its verdict and fills the slot: twice the digits, the same in other units, whole numbers. */
export function solveSlowly(q: Quadric, ray: Ray, slot: CertifiedSlot): number {
  slot.exact = false;
  let verdict = plainRoots(q, ray, slot);
  if (verdict === UNKNOWN) verdict = inUnits(q, ray, slot);
  if (verdict !== UNKNOWN) return verdict;
  slot.exact = true;
  const { origin: E, direction: d } = ray;
  return solveExactly(q, E[0], E[1], E[2], d[0], d[1], d[2], slot);
}

const longest = (v: Vec3, hasY: boolean): number =>
  Math.max(Math.abs(v[0]), hasY ? Math.abs(v[1]) : 0, Math.abs(v[2]));

/** In powers of two as units, by which d and the lengths are about 1. UNKNOWN where a number would lose bits by that: E could seem to be on the surface then. */
function inUnits(q: Quadric, { origin: E, direction: d }: Ray, slot: RootSlot): number {
  const { hasY } = q;
  const speed = longest(d, hasY);
  const length = Math.max(longest(E, hasY), longest([q.Cx, q.Cy, q.Cz], hasY), q.r);
  if (speed === 0 || length === 0 || (ordinary(speed) && ordinary(length))) return UNKNOWN;
  const k = exponentOf(speed);
  const l = exponentOf(length);
  let lossless = true;
  const inUnit = (x: number, unit: number): number => {
    const y = scale(x, -unit);
    if (scale(y, unit) !== x) lossless = false;
    return y;
  };
  const shape: Quadric = {
    ...q,
    Cx: inUnit(q.Cx, l),
    Cy: hasY ? inUnit(q.Cy, l) : 0,
    Cz: inUnit(q.Cz, l),
    r: inUnit(q.r, l),
  };
  const origin: Vec3 = [inUnit(E[0], l), hasY ? inUnit(E[1], l) : 0, inUnit(E[2], l)];
  const direction: Vec3 = [inUnit(d[0], k), hasY ? inUnit(d[1], k) : 0, inUnit(d[2], k)];
  if (!lossless) return UNKNOWN;
  const verdict = plainRoots(shape, { origin, direction }, slot);
  if (verdict === TWO) {
    // Rounding twice, to 53 bits and then into the subnormals, stays faithful: a neighbour in the coarser grid is one in the finer.
    slot.t0 = scale(slot.t0, l - k);
    slot.t1 = scale(slot.t1, l - k);
  }
  return verdict;
}

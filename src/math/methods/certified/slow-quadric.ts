import { type RootSlot, solveExactly } from '../../batch/exact-quadric.ts';
import type { Quadric } from '../../batch/quadric.ts';
import { exponentOf, scale } from '../../float/bits.ts';
import { ORDINARY } from './slow-bounds.ts';
import { setDirection, setFlare, setLengths } from './slow-registers.ts';
import { solveScaled, UNKNOWN } from './slow-roots.ts';

/** Roots and the stage that stood for them. */
export interface CertifiedSlot extends RootSlot {
  exact: boolean;
}

export const certifiedSlot = (): CertifiedSlot => ({
  t0: Number.NaN,
  t1: Number.NaN,
  exact: false,
});

/** One ray that a filter left open; returns its verdict and fills the slot. */
export function solveSlowly(
  q: Quadric,
  Ex: number,
  Ey: number,
  Ez: number,
  dx: number,
  dy: number,
  dz: number,
  slot: CertifiedSlot,
): number {
  slot.exact = false;
  const verdict = inDoubleDouble(q, Ex, q.hasY ? Ey : 0, Ez, dx, q.hasY ? dy : 0, dz, slot);
  if (verdict >= 0) return verdict;
  slot.exact = true;
  return solveExactly(q, Ex, Ey, Ez, dx, dy, dz, slot);
}

/**
 * Fills the registers, scaled where it must be; UNKNOWN where a length would lose bits by that, since E could seem to be on the surface then. What d loses
 * is within ABSOLUTE_ERROR.
 */
function inDoubleDouble(
  q: Quadric,
  Ex: number,
  Ey: number,
  Ez: number,
  dx: number,
  dy: number,
  dz: number,
  slot: CertifiedSlot,
): number {
  const Cy = q.hasY ? q.Cy : 0;
  if (!setFlare(q)) return UNKNOWN;
  const speed = Math.max(Math.abs(dx), Math.abs(dy), Math.abs(dz));
  const length = Math.max(
    Math.max(Math.abs(Ex), Math.abs(Ey), Math.abs(Ez)),
    Math.max(Math.abs(q.Cx), Math.abs(Cy), Math.abs(q.Cz)),
    q.r,
  );
  // d = 0 about a cylinder's axis, or nothing but zeros: the exact stage knows what that means.
  if (speed === 0 || length === 0) return UNKNOWN;
  if (ordinary(speed) && ordinary(length)) {
    setDirection(dx, dy, dz);
    setLengths(Ex, Ey, Ez, q.Cx, Cy, q.Cz, q.r);
    return solveScaled(0, slot);
  }
  const k = exponentOf(speed);
  const l = exponentOf(length);
  setDirection(scale(dx, -k), scale(dy, -k), scale(dz, -k));
  setLengths(
    scale(Ex, -l),
    scale(Ey, -l),
    scale(Ez, -l),
    scale(q.Cx, -l),
    scale(Cy, -l),
    scale(q.Cz, -l),
    scale(q.r, -l),
  );
  const lossless =
    restores(Ex, l) &&
    restores(Ey, l) &&
    restores(Ez, l) &&
    restores(q.Cx, l) &&
    restores(Cy, l) &&
    restores(q.Cz, l) &&
    restores(q.r, l);
  return lossless ? solveScaled(l - k, slot) : UNKNOWN;
}

const ordinary = (x: number): boolean => x < ORDINARY && x > 1 / ORDINARY;

const restores = (x: number, l: number): boolean => scale(scale(x, -l), l) === x;

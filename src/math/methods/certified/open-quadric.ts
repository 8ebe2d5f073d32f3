import type { Quadric } from '../../batch/quadric.ts';
import type { Ray } from '../../ray.ts';
import { plainRoots } from './plain-roots.ts';
import { type CertifiedSlot, solveSlowly } from './slow-quadric.ts';
import { UNKNOWN } from './slow-roots.ts';

/** One ray that the filters left open; returns its verdict and fills the slot: twice the digits in plain numbers, then in registers, then whole numbers. */
export function solveOpen(q: Quadric, ray: Ray, slot: CertifiedSlot): number {
  slot.exact = false;
  const verdict = plainRoots(q, ray, slot);
  if (verdict !== UNKNOWN) return verdict;
  const { origin: E, direction: d } = ray;
  return solveSlowly(q, E[0], E[1], E[2], d[0], d[1], d[2], slot);
}

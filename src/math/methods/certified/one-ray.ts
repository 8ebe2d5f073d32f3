import { createAnswers, createRays, NONE, TWO } from '../../batch/batch.ts';
import type { Quadric } from '../../batch/quadric.ts';
import type { DecidedBy } from '../../intersection.ts';
import type { Ray } from '../../ray.ts';
import { bothRoots, type OpenRays } from './roots-quadric.ts';
import { certifiedQuadric } from './scaled-quadric.ts';
import { type CertifiedSlot, certifiedSlot, solveSlowly } from './slow-quadric.ts';

/*
 * A batch of one: an object's roots are the batch's, to the bit, as a faithful root can be either of two doubles.
 */
export const rays = Object.assign(createRays(1), { count: 1 });
export const out = createAnswers(1);
export const left: OpenRays = { count: 0, open: new Int32Array(1) };
export const slot: CertifiedSlot = certifiedSlot();

/** What was found of the last ray; NaN where there is no root. */
export const found: { verdict: number; t0: number; t1: number; decidedBy: DecidedBy } = {
  verdict: NONE,
  t0: Number.NaN,
  t1: Number.NaN,
  decidedBy: 'filter',
};

export function setRay({ origin: E, direction: d }: Ray): void {
  rays.Ex[0] = E[0];
  rays.Ey[0] = E[1];
  rays.Ez[0] = E[2];
  rays.dx[0] = d[0];
  rays.dy[0] = d[1];
  rays.dz[0] = d[2];
}

/** Fills `found` by the stages that a batch goes through. */
export function findRoots(q: Quadric, ray: Ray): void {
  const c = certifiedQuadric(q);
  if (c.inBox) {
    setRay(ray);
    bothRoots(q, c, rays, out, left);
    if (left.count === 0) {
      found.t0 = out.t0[0] as number;
      found.t1 = out.t1[0] as number;
      found.verdict = Number.isNaN(found.t0) ? NONE : TWO;
      found.decidedBy = 'filter';
      return;
    }
  }
  const { origin: E, direction: d } = ray;
  found.verdict = solveSlowly(q, E[0], E[1], E[2], d[0], d[1], d[2], slot);
  found.t0 = slot.t0;
  found.t1 = slot.t1;
  found.decidedBy = stageOf(slot);
}

export const stageOf = ({ exact }: CertifiedSlot): DecidedBy => (exact ? 'exact' : 'double-double');

import { createAnswers, createRays, NONE, TWO } from '../../batch/batch.ts';
import type { Quadric } from '../../batch/quadric.ts';
import type { DecidedBy } from '../../intersection.ts';
import type { Ray } from '../../ray.ts';
import { bothRoots, type OpenRays } from './roots-quadric.ts';
import { type CertifiedQuadric, certifiedQuadric } from './scaled-quadric.ts';
import { type CertifiedSlot, certifiedSlot, solveSlowly } from './slow-quadric.ts';

/*
 * A batch of one: an object's roots are the batch's, to the bit, as a faithful root can be either of two doubles.
 */
export const rays = Object.assign(createRays(1), { count: 1 });
export const out = createAnswers(1);
export const left: OpenRays = { count: 0, open: new Int32Array(1) };
export const slot: CertifiedSlot = certifiedSlot();

/** What was found of the last ray: the two roots, NaN where there is none, the verdict, and whether by which stage. In doubles: fields of an object would be boxed. */
export const FOUND = new Float64Array(4);
export const T0 = 0;
export const T1 = 1;
export const VERDICT = 2;
export const STAGE = 3;
const STAGES: readonly DecidedBy[] = ['filter', 'double-double', 'exact'];
export const stageFound = (): DecidedBy => STAGES[FOUND[STAGE] as number] ?? 'exact';

export function setRay({ origin: E, direction: d }: Ray): void {
  rays.Ex[0] = E[0];
  rays.Ey[0] = E[1];
  rays.Ez[0] = E[2];
  rays.dx[0] = d[0];
  rays.dy[0] = d[1];
  rays.dz[0] = d[2];
}

/** Fills FOUND by the stages that a batch goes through. */
export function findRoots(q: Quadric, ray: Ray, c: CertifiedQuadric = certifiedQuadric(q)): void {
  if (c.inBox) {
    setRay(ray);
    bothRoots(q, c, rays, out, left);
    if (left.count === 0) {
      const t0 = out.t0[0] as number;
      FOUND[T0] = t0;
      FOUND[T1] = out.t1[0] as number;
      FOUND[VERDICT] = Number.isNaN(t0) ? NONE : TWO;
      FOUND[STAGE] = 0;
      return;
    }
  }
  const { origin: E, direction: d } = ray;
  FOUND[VERDICT] = solveSlowly(q, E[0], E[1], E[2], d[0], d[1], d[2], slot);
  FOUND[T0] = slot.t0;
  FOUND[T1] = slot.t1;
  FOUND[STAGE] = slot.exact ? 2 : 1;
}

export const stageOf = ({ exact }: CertifiedSlot): DecidedBy => (exact ? 'exact' : 'double-double');

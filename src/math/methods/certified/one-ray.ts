import { createAnswers, createRays, NONE, type Rays, TWO } from '../../batch/batch.ts';
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

/** Closures over their arrays, as in lattice-scratch.ts. */
export const setRay = into(rays);
export const findRoots = finder();

function into({ Ex, Ey, Ez, dx, dy, dz }: Rays): (ray: Ray) => void {
  return ({ origin: E, direction: d }) => {
    Ex[0] = E[0];
    Ey[0] = E[1];
    Ez[0] = E[2];
    dx[0] = d[0];
    dy[0] = d[1];
    dz[0] = d[2];
  };
}

/** Fills FOUND by the stages that a batch goes through. `c` is what certifiedQuadric makes of `q`, for whoever has it at hand. */
function finder(): (q: Quadric, ray: Ray, c?: CertifiedQuadric) => void {
  const found = FOUND;
  const one = rays;
  const open = left;
  const answers = out;
  const { t0, t1 } = out;
  return (q, ray, c = certifiedQuadric(q)) => {
    if (c.inBox) {
      setRay(ray);
      bothRoots(q, c, one, answers, open);
      if (open.count === 0) {
        const t = t0[0] as number;
        found[T0] = t;
        found[T1] = t1[0] as number;
        found[VERDICT] = Number.isNaN(t) ? NONE : TWO;
        found[STAGE] = 0;
        return;
      }
    }
    findSlowly(q, ray);
  };
}

function findSlowly(q: Quadric, ray: Ray): void {
  FOUND[VERDICT] = solveSlowly(q, ray, slot);
  FOUND[T0] = slot.t0;
  FOUND[T1] = slot.t1;
  FOUND[STAGE] = slot.exact ? 2 : 1;
}

export const stageOf = ({ exact }: CertifiedSlot): DecidedBy => (exact ? 'exact' : 'double-double');

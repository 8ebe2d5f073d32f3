import {
  type Answers,
  createAnswers,
  createRays,
  NONE,
  type Rays,
  TWO,
} from '../../batch/batch.ts';
import type { Quadric } from '../../batch/quadric.ts';
import type { DecidedBy } from '../../intersection.ts';
import type { Ray } from '../../ray.ts';
import { solveSlowly } from './doubled-roots.ts';
import { bothRoots } from './quadric-kernel.ts';
import { type CertifiedQuadric, certifiedQuadric } from './quadric-numbers.ts';
import { type CertifiedSlot, certifiedSlot, type OpenRays } from './stage.ts';

/*
 * A batch of one: an object's roots are the batch's, to the bit, as a faithful root can be either
 * of two doubles.
 */

/** A batch of one ray with its answers, and the function that puts a ray into it. */
export interface OneRay {
  readonly rays: Rays;
  readonly out: Answers;
  readonly left: OpenRays;
  readonly setRay: (ray: Ray) => void;
}

export function createOneRay(): OneRay {
  const rays = Object.assign(createRays(1), { count: 1 });
  const left = { count: 0, open: new Int32Array(1) };
  return { rays, out: createAnswers(1), left, setRay: into(rays) };
}

/**
 * What was found of a ray: the two roots, NaN where there is none, the verdict, and by which stage.
 * In doubles: fields of an object would be boxed.
 */
export type Found = Float64Array;
export const createFound = (): Found => new Float64Array(4);
export const T0 = 0;
export const T1 = 1;
export const VERDICT = 2;
export const STAGE = 3;
const STAGES: readonly DecidedBy[] = ['filter', 'double-double', 'exact'];
export const stageFound = (found: Found): DecidedBy => STAGES[found[STAGE] as number] ?? 'exact';

/** A closure over its arrays, as in units-rough.ts. */
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

/**
 * Fills `found` by the stages that a batch goes through. `c` is what certifiedQuadric makes of `q`,
 * for whoever has it at hand.
 */
export const findRoots = finder();

function finder(): (q: Quadric, ray: Ray, found: Found, c?: CertifiedQuadric) => void {
  const { rays, out, left, setRay } = createOneRay();
  const { t0, t1 } = out;
  const slot = certifiedSlot();
  return (q, ray, found, c = certifiedQuadric(q)) => {
    if (c.inBox) {
      setRay(ray);
      bothRoots(q, c, rays, out, left);
      if (left.count === 0) {
        const t = t0[0] as number;
        found[T0] = t;
        found[T1] = t1[0] as number;
        found[VERDICT] = Number.isNaN(t) ? NONE : TWO;
        found[STAGE] = 0;
        return;
      }
    }
    found[VERDICT] = solveSlowly(q, ray, slot);
    found[T0] = slot.t0;
    found[T1] = slot.t1;
    found[STAGE] = slot.exact ? 2 : 1;
  };
}

export const stageOf = ({ exact }: CertifiedSlot): DecidedBy => (exact ? 'exact' : 'double-double');

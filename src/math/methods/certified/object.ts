import { createAnswers, createRays, NONE, ONE, TWO, VERDICTS } from '../../batch/batch.ts';
import { type Planar, planarOf } from '../../batch/planar.ts';
import { type Quadric, quadricOf } from '../../batch/quadric.ts';
import type { DecidedBy, Hit, Intersection, Verdict } from '../../intersection.ts';
import type { Ray } from '../../ray.ts';
import type { Shape } from '../../shapes/index.ts';
import type { Vec3 } from '../../vec3.ts';
import { exact } from '../exact.ts';
import { planarRoots, solvePlanarSlowly } from './kernel-planar.ts';
import { bothRoots, type OpenRays } from './roots-quadric.ts';
import { certifiedQuadric } from './scaled-quadric.ts';
import { certifiedSlot, solveSlowly } from './slow-quadric.ts';

/*
 * The answer for one ray as an object. Class and roots are there at once; points, normals and the details of the algebra are worked out
 * exactly when somebody reads them, from copies of the numbers, so that what is read later does not depend on what became of the
 * caller's arrays.
 */
class CertifiedAnswer implements Intersection {
  readonly class: Verdict;
  readonly hits: readonly Hit[];
  readonly method = 'certified';
  readonly decidedBy: DecidedBy;
  readonly #shape: () => Shape;
  readonly #ray: Ray;
  #exact: Intersection | null = null;

  constructor(
    verdict: number,
    decidedBy: DecidedBy,
    t0: number,
    t1: number,
    shape: () => Shape,
    ray: Ray,
  ) {
    this.class = VERDICTS[verdict] ?? 'undecided';
    this.decidedBy = decidedBy;
    this.#shape = shape;
    this.#ray = ray;
    if (Number.isNaN(t0)) this.hits = [];
    else if (Number.isNaN(t1)) this.hits = [new CertifiedHit(t0, this, 0)];
    else this.hits = [new CertifiedHit(t0, this, 0), new CertifiedHit(t1, this, 1)];
  }

  get exactly(): Intersection {
    this.#exact ??= exact.intersect(this.#shape(), this.#ray);
    return this.#exact;
  }

  get details(): Intersection['details'] {
    return this.exactly.details;
  }
}

class CertifiedHit implements Hit {
  readonly t: number;
  readonly #answer: CertifiedAnswer;
  readonly #index: number;

  constructor(t: number, answer: CertifiedAnswer, index: number) {
    this.t = t;
    this.#answer = answer;
    this.#index = index;
  }

  get #hit(): Hit {
    return this.#answer.exactly.hits[this.#index] as Hit;
  }

  get point(): Vec3 {
    return this.#hit.point;
  }

  get normal(): Vec3 {
    return this.#hit.normal;
  }

  get singular(): boolean {
    return this.#hit.singular;
  }
}

const rays = createRays(1);
rays.count = 1;
const out = createAnswers(1);
const left: OpenRays = { count: 0, open: new Int32Array(1) };
const slot = certifiedSlot();

export function intersectCertified(shape: Shape, ray: Ray): Intersection {
  const { origin: E, direction: d } = ray;
  const copy: Ray = { origin: [E[0], E[1], E[2]], direction: [d[0], d[1], d[2]] };
  const q = quadricOf(shape);
  if (q) return curved(q, copy);
  const s = planarOf(shape);
  // A shape without a kernel is answered by the exact rung under this one's name: its promise is the stronger one.
  return s ? flat(s, shape, copy) : { ...exact.intersect(shape, ray), method: 'certified' };
}

/** The shape that these numbers stand for: what is missing in its formula makes it the special case. */
function shapeOf({ Cx, Cy, Cz, hasY, hasR, flare, r }: Quadric): Shape {
  const center: Vec3 = [Cx, Cy, Cz];
  if (!hasY) return { kind: 'cylinder', center, radius: r };
  if (!hasR) return { kind: 'cone', vertex: center, slope: flare };
  return { kind: 'hyperboloid', center, flare, radius: r };
}

function setRay({ origin: E, direction: d }: Ray): void {
  rays.Ex[0] = E[0];
  rays.Ey[0] = E[1];
  rays.Ez[0] = E[2];
  rays.dx[0] = d[0];
  rays.dy[0] = d[1];
  rays.dz[0] = d[2];
}

function curved(q: Quadric, ray: Ray): Intersection {
  const { origin: E, direction: d } = ray;
  const c = certifiedQuadric(q);
  const shape = (): Shape => shapeOf(q);
  if (c.inBox) {
    setRay(ray);
    bothRoots(q, c, rays, out, left);
    if (left.count === 0) {
      const t0 = out.t0[0] as number;
      const t1 = out.t1[0] as number;
      return new CertifiedAnswer(Number.isNaN(t0) ? NONE : TWO, 'filter', t0, t1, shape, ray);
    }
  }
  const verdict = solveSlowly(q, E[0], E[1], E[2], d[0], d[1], d[2], slot);
  const none = verdict === NONE;
  return new CertifiedAnswer(
    verdict,
    slot.exact ? 'exact' : 'double-double',
    none ? Number.NaN : slot.t0,
    none ? Number.NaN : slot.t1,
    shape,
    ray,
  );
}

function flat(s: Planar, shape: Shape, ray: Ray): Intersection {
  const { origin: E, direction: d } = ray;
  const copy = copyOf(shape);
  const again = (): Shape => copy;
  setRay(ray);
  planarRoots(s, rays, out, left);
  if (left.count === 0) {
    const t0 = out.t0[0] as number;
    return new CertifiedAnswer(Number.isNaN(t0) ? NONE : ONE, 'filter', t0, Number.NaN, again, ray);
  }
  const verdict = solvePlanarSlowly(s, E[0], E[1], E[2], d[0], d[1], d[2], slot);
  return new CertifiedAnswer(
    verdict,
    slot.exact ? 'exact' : 'double-double',
    verdict === ONE ? slot.t0 : Number.NaN,
    Number.NaN,
    again,
    ray,
  );
}

/** A shape's numbers and vectors, one level deep: all that there is. */
function copyOf(shape: Shape): Shape {
  const entries = Object.entries(shape).map(([key, x]) => [key, Array.isArray(x) ? [...x] : x]);
  return Object.fromEntries(entries) as Shape;
}

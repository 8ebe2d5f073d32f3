import { NONE, ONE, TWO, VERDICTS } from '../../batch/batch.ts';
import { type Planar, planarOf } from '../../batch/planar.ts';
import type { Quadric } from '../../batch/quadric.ts';
import type { DecidedBy, Hit, Intersection, Verdict } from '../../intersection.ts';
import { lazily } from '../../lazily.ts';
import type { Ray } from '../../ray.ts';
import type { Shape } from '../../shapes/index.ts';
import type { Vec3 } from '../../vec3.ts';
import { exact } from '../exact.ts';
import { plainQuadric, shortQuadric } from './curved.ts';
import { createFound, type Found, stageFound, T0, T1, VERDICT } from './found.ts';
import { gridQuadric } from './grids.ts';
import { placeInPlane, placeOnQuadric } from './hits.ts';
import { type CertifiedQuadric, certifiedSlot, readQuadric } from './numbers.ts';
import { createOneRay, findRoots, stageOf } from './one-ray.ts';
import { planarRoots, solvePlanarSlowly } from './planar.ts';

/** The answer for one ray: grids, else the kernels' stages on a batch of one, points, normals. */
export function intersectCertified(shape: Shape, ray: Ray): Intersection {
  const read = readQuadric(shape);
  if (read) {
    const { q, c } = read;
    return gridQuadric(q, c, ray) ?? rare(q, c, ray);
  }
  const s = planarOf(shape);
  // A shape without a kernel is answered by the exact method under this one's name: its promise is
  // the stronger one.
  return s ? flat(s, copyOf(ray)) : { ...exact.intersect(shape, ray), method: 'certified' };
}

const rare = (q: Quadric, c: CertifiedQuadric, ray: Ray): Intersection =>
  shortQuadric(q, c, ray) ?? plainQuadric(q, ray, c) ?? curved(q, c, ray);

const copyOf = ({ origin, direction }: Ray): Ray => ({
  origin: copied(origin),
  direction: copied(direction),
});
const copied = (v: Vec3): Vec3 => [v[0], v[1], v[2]];

const ownFound = lazily(createFound);

function curved(q: Quadric, c: CertifiedQuadric, asked: Ray): Intersection {
  const ray = copyOf(asked);
  const found = ownFound();
  findRoots(q, ray, found, c);
  const verdict = found[VERDICT] as number;
  return new CertifiedAnswer(verdict, stageFound(found), hitsOf(q, ray, found), q, ray);
}

function twoHits(q: Quadric, ray: Ray, t0: number, t1: number): Hit[] {
  return [
    placeOnQuadric(q, ray, t0) ?? exactHit(q, ray, 0, t0),
    placeOnQuadric(q, ray, t1) ?? exactHit(q, ray, 1, t1),
  ];
}

/** A single root was found by whole numbers already. */
function hitsOf(q: Quadric, ray: Ray, found: Found): Hit[] {
  const verdict = found[VERDICT];
  const t0 = found[T0] as number;
  const t1 = found[T1] as number;
  if (verdict === TWO) return twoHits(q, ray, t0, t1);
  return verdict === NONE || Number.isNaN(t0) ? [] : [exactHit(q, ray, 0, t0)];
}

/** With the root that was certified: faithful, and not always the one that is correctly rounded. */
const exactHit = (shape: Quadric | Planar, ray: Ray, k: number, t: number): Hit => ({
  ...(exactly(shape, ray).hits[k] as Hit),
  t,
});

const oneRay = lazily(createOneRay);
const ownSlot = lazily(certifiedSlot);

function flat(shape: Planar, ray: Ray): Intersection {
  const s: Planar = { ...shape, N: copied(shape.N), P: copied(shape.P) };
  const { rays, out, left, setRay } = oneRay();
  const slot = ownSlot();
  setRay(ray);
  planarRoots(s, rays, out, left);
  if (left.count === 0) {
    const t = out.t0[0] as number;
    if (Number.isNaN(t)) return new CertifiedAnswer(NONE, 'filter', [], s, ray);
    return new CertifiedAnswer(ONE, 'filter', [flatHit(s, ray, t)], s, ray);
  }
  const verdict = solvePlanarSlowly(s, rays, 0, out, slot);
  const hits = verdict === ONE ? [flatHit(s, ray, slot.t0)] : [];
  return new CertifiedAnswer(verdict, stageOf(slot), hits, s, ray);
}

const flatHit = (s: Planar, ray: Ray, t: number): Hit =>
  placeInPlane(s, ray, t) ?? exactHit(s, ray, 0, t);

/**
 * Class, roots, points and normals are plain data. Only the details of the algebra are worked out,
 * exactly, when somebody reads them, from copies of the numbers, so that what is read later does
 * not depend on what became of the caller's arrays. They are an own and enumerable property all the
 * same: a spread, JSON, structuredClone or a comparison reads them like any other.
 */
export class CertifiedAnswer implements Intersection {
  readonly class: Verdict;
  readonly hits: readonly Hit[];
  readonly method = 'certified';
  readonly decidedBy: DecidedBy;
  declare readonly details: Intersection['details'];
  readonly #shape: Quadric | Planar;
  readonly #ray: Ray;

  /** `shape` and `ray` are this answer's own from now on. */
  constructor(
    verdict: number,
    decidedBy: DecidedBy,
    hits: readonly Hit[],
    shape: Quadric | Planar,
    ray: Ray,
  ) {
    this.class = VERDICTS[verdict] ?? 'undecided';
    this.hits = hits;
    this.decidedBy = decidedBy;
    this.#shape = shape;
    this.#ray = ray;
    Object.defineProperty(this, 'details', CertifiedAnswer.#DETAILS);
  }

  /**
   * One getter for all answers: with a new function for each, V8 gives up on a common layout, at
   * six times the price.
   */
  static readonly #DETAILS: PropertyDescriptor & ThisType<CertifiedAnswer> = {
    get() {
      return exactly(this.#shape, this.#ray).details;
    },
    enumerable: true,
    configurable: true,
  };
}

/**
 * The last questions that needed whole numbers: hits and details of one answer are worked out
 * together. A memo only.
 */
const known = lazily(() => new WeakMap<Ray, Intersection>());

/**
 * What the exact method says. The ray must not change any more: it is what the answer is remembered
 * by.
 */
export function exactly(shape: Quadric | Planar, ray: Ray): Intersection {
  const before = known().get(ray);
  if (before) return before;
  const found = exact.intersect('bound' in shape ? flatShape(shape) : curvedShape(shape), ray);
  known().set(ray, found);
  return found;
}

/**
 * The shape that these numbers stand for: what is missing in its formula makes it the special case.
 */
function curvedShape({ Cx, Cy, Cz, hasY, hasR, flare, r }: Quadric): Shape {
  const center: Vec3 = [Cx, Cy, Cz];
  if (!hasY) return { kind: 'cylinder', center, radius: r };
  if (!hasR) return { kind: 'cone', vertex: center, slope: flare };
  return { kind: 'hyperboloid', center, flare, radius: r };
}

const AXES = ['x', 'y', 'z'] as const;

function flatShape({ N, P, bound, size }: Planar): Shape {
  if (bound === 'none') return { kind: 'plane', normal: N, point: P };
  if (bound === 'circle') return { kind: 'circle', normal: N, center: P, radius: size };
  return { kind: 'square', corner: P, side: size, axis: AXES[N.indexOf(1)] ?? 'x' };
}

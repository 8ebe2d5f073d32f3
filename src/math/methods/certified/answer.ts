import { VERDICTS } from '../../batch/batch.ts';
import type { Planar } from '../../batch/planar.ts';
import type { Quadric } from '../../batch/quadric.ts';
import type { DecidedBy, Hit, Intersection, Verdict } from '../../intersection.ts';
import type { Ray } from '../../ray.ts';
import type { Shape } from '../../shapes/index.ts';
import type { Vec3 } from '../../vec3.ts';
import { exact } from '../exact.ts';

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
const known = new WeakMap<Ray, Intersection>();

/**
 * What the exact rung says. The ray must not change any more: it is what the answer is remembered
 * by.
 */
export function exactly(shape: Quadric | Planar, ray: Ray): Intersection {
  const before = known.get(ray);
  if (before) return before;
  const found = exact.intersect('bound' in shape ? flatShape(shape) : curvedShape(shape), ray);
  known.set(ray, found);
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

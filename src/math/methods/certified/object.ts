import { NONE, ONE, TWO } from '../../batch/batch.ts';
import { type Planar, planarOf } from '../../batch/planar.ts';
import type { Quadric } from '../../batch/quadric.ts';
import type { Hit, Intersection } from '../../intersection.ts';
import type { Ray } from '../../ray.ts';
import type { Shape } from '../../shapes/index.ts';
import type { Vec3 } from '../../vec3.ts';
import { exact } from '../exact.ts';
import { CertifiedAnswer, exactly } from './answer.ts';
import { gridQuadric } from './grid-quadric.ts';
import { placeInPlane, placeOnQuadric } from './hits.ts';
import {
  createFound,
  createOneRay,
  type Found,
  findRoots,
  stageFound,
  stageOf,
  T0,
  T1,
  VERDICT,
} from './one-ray.ts';
import { plainQuadric } from './plain-quadric.ts';
import { planarRoots, solvePlanarSlowly } from './planar.ts';
import { type CertifiedQuadric, readQuadric } from './quadric-numbers.ts';
import { shortQuadric } from './short-quadric.ts';
import { certifiedSlot } from './stage.ts';

/*
 * The answer for one ray as an object: the kernels' stages on a batch of one, then points and
 * normals.
 */

export function intersectCertified(shape: Shape, ray: Ray): Intersection {
  const read = readQuadric(shape);
  if (read) {
    const { q, c } = read;
    return gridQuadric(q, c, ray) ?? rare(q, c, ray);
  }
  const s = planarOf(shape);
  // A shape without a kernel is answered by the exact rung under this one's name: its promise is
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

const found = createFound();

function curved(q: Quadric, c: CertifiedQuadric, asked: Ray): Intersection {
  const ray = copyOf(asked);
  findRoots(q, ray, found, c);
  const verdict = found[VERDICT] as number;
  return new CertifiedAnswer(verdict, stageFound(found), hitsOf(q, ray, found), q, ray);
}

function twoHits(q: Quadric, ray: Ray, t0: number, t1: number): Hit[] {
  return [
    placeOnQuadric(q, ray, 0, t0) ?? exactHit(q, ray, 0, t0),
    placeOnQuadric(q, ray, 3, t1) ?? exactHit(q, ray, 1, t1),
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

const { rays, out, left, setRay } = createOneRay();
const slot = certifiedSlot();

function flat(shape: Planar, ray: Ray): Intersection {
  const s: Planar = { ...shape, N: copied(shape.N), P: copied(shape.P) };
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

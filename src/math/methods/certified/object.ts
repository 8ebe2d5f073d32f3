import { createAnswers, createRays, NONE, ONE, TWO } from '../../batch/batch.ts';
import { type Planar, planarOf } from '../../batch/planar.ts';
import { type Quadric, quadricOf } from '../../batch/quadric.ts';
import type { DecidedBy, Hit, Intersection } from '../../intersection.ts';
import type { Ray } from '../../ray.ts';
import type { Shape } from '../../shapes/index.ts';
import type { Vec3 } from '../../vec3.ts';
import { exact } from '../exact.ts';
import { CertifiedAnswer, exactly } from './answer.ts';
import { planarRoots } from './kernel-planar.ts';
import { placeInPlane, placeOnQuadric } from './places.ts';
import { plainQuadric } from './plain-quadric.ts';
import { bothRoots, type OpenRays } from './roots-quadric.ts';
import { certifiedQuadric } from './scaled-quadric.ts';
import { solvePlanarSlowly } from './slow-planar.ts';
import { type CertifiedSlot, certifiedSlot, solveSlowly } from './slow-quadric.ts';

/* The answer for one ray as an object: the kernels' stages on a batch of one, then points and normals. */

const rays = createRays(1);
rays.count = 1;
const out = createAnswers(1);
const left: OpenRays = { count: 0, open: new Int32Array(1) };
const slot = certifiedSlot();

export function intersectCertified(shape: Shape, ray: Ray): Intersection {
  const q = quadricOf(shape);
  if (q) return plainQuadric(q, ray) ?? curved(q, ray);
  const s = planarOf(shape);
  // A shape without a kernel is answered by the exact rung under this one's name: its promise is the stronger one.
  return s ? flat(s, copyOf(ray)) : { ...exact.intersect(shape, ray), method: 'certified' };
}

const copyOf = ({ origin, direction }: Ray): Ray => ({
  origin: copied(origin),
  direction: copied(direction),
});
const copied = (v: Vec3): Vec3 => [v[0], v[1], v[2]];

function setRay({ origin: E, direction: d }: Ray): void {
  rays.Ex[0] = E[0];
  rays.Ey[0] = E[1];
  rays.Ez[0] = E[2];
  rays.dx[0] = d[0];
  rays.dy[0] = d[1];
  rays.dz[0] = d[2];
}

function curved(q: Quadric, asked: Ray): Intersection {
  const ray = copyOf(asked);
  const { origin: E, direction: d } = ray;
  const c = certifiedQuadric(q);
  if (c.inBox) {
    setRay(ray);
    bothRoots(q, c, rays, out, left);
    if (left.count === 0) {
      const t0 = out.t0[0] as number;
      if (Number.isNaN(t0)) return new CertifiedAnswer(NONE, 'filter', [], q, ray);
      return new CertifiedAnswer(TWO, 'filter', twoHits(q, ray, t0, out.t1[0] as number), q, ray);
    }
  }
  const verdict = solveSlowly(q, E[0], E[1], E[2], d[0], d[1], d[2], slot);
  return new CertifiedAnswer(verdict, stageOf(slot), slowHits(q, ray, verdict), q, ray);
}

const stageOf = ({ exact: whole }: CertifiedSlot): DecidedBy => (whole ? 'exact' : 'double-double');

function twoHits(q: Quadric, ray: Ray, t0: number, t1: number): Hit[] {
  return [
    placeOnQuadric(q, ray, 0, t0) ?? exactHit(q, ray, 0, t0),
    placeOnQuadric(q, ray, 3, t1) ?? exactHit(q, ray, 1, t1),
  ];
}

/** A single root was found by whole numbers already. */
function slowHits(q: Quadric, ray: Ray, verdict: number): Hit[] {
  if (verdict === TWO) return twoHits(q, ray, slot.t0, slot.t1);
  return verdict === NONE || Number.isNaN(slot.t0) ? [] : [exactHit(q, ray, 0, slot.t0)];
}

/** With the root that was certified: faithful, and not always the one that is correctly rounded. */
const exactHit = (shape: Quadric | Planar, ray: Ray, k: number, t: number): Hit => ({
  ...(exactly(shape, ray).hits[k] as Hit),
  t,
});

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

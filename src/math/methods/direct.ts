import { CONTAINED, NONE, ONE, UNDECIDED, VERDICTS } from '../batch/batch.ts';
import { type Planar, planarOf } from '../batch/planar.ts';
import { type Quadric, quadricInTreeOrder } from '../batch/quadric.ts';
import { planarSlot, solvePlanar } from '../batch/textbook-planar-scalar.ts';
import { curvedSlot, solveCurved } from '../batch/textbook-scalar.ts';
import type { Hit, Intersection, Sign } from '../intersection.ts';
import type { Ray } from '../ray.ts';
import type { Shape } from '../shapes/index.ts';
import type { Method } from './define.ts';

/**
 * the method `walked` without walking its trees: the same operations in the same order, hence the
 * same bits (which is tested), at a small part of the price. A shape that has no table entry, and
 * the rare answers, still come from the trees.
 */
export function direct(walked: Method, stable: boolean): Method {
  return {
    ...walked,
    intersect(shape, ray) {
      const q = quadricInTreeOrder(shape);
      if (q) return curved(walked, q, shape, ray, stable);
      const s = planarOf(shape);
      return s && s.bound !== 'square' ? flat(walked, s, shape, ray) : walked.intersect(shape, ray);
    },
  };
}

const slot = curvedSlot();

const signOf = (x: number): Sign | null => (x - x === 0 ? ((Math.sign(x) + 0) as Sign) : null);

function curved(
  walked: Method,
  q: Quadric,
  shape: Shape,
  { origin: E, direction: d }: Ray,
  stable: boolean,
): Intersection {
  const verdict = solveCurved(q, E[0], E[1], E[2], d[0], d[1], d[2], slot, stable);
  if (verdict === UNDECIDED) return walked.intersect(shape, { origin: E, direction: d });
  const { A, B, C, D, t0, t1 } = slot;
  const hits: Hit[] = [];
  if (verdict !== NONE && verdict !== CONTAINED) {
    hits.push(hitAt(q, E[0], E[1], E[2], d[0], d[1], d[2], t0));
    if (!Number.isNaN(t1)) hits.push(hitAt(q, E[0], E[1], E[2], d[0], d[1], d[2], t1));
  }
  return {
    class: VERDICTS[verdict] ?? 'undecided',
    hits,
    method: walked.id,
    decidedBy: 'formula',
    details: {
      family: 'curved',
      A,
      B,
      C,
      D,
      signs: { A: signOf(A), B: signOf(B), C: signOf(C), D: signOf(D) },
    },
  };
}

function hitAt(
  q: Quadric,
  Ex: number,
  Ey: number,
  Ez: number,
  dx: number,
  dy: number,
  dz: number,
  t: number,
): Hit {
  const x = Ex + t * dx;
  const y = Ey + t * dy;
  const z = Ez + t * dz;
  const nx = x - q.Cx;
  const ny = q.hasY ? -(q.squared ? q.flare * q.flare : q.flare) * (y - q.Cy) : 0;
  const nz = z - q.Cz;
  const singular = nx === 0 && ny === 0 && nz === 0;
  return { t, point: [x, y, z], normal: singular ? [0, 0, 0] : [nx, ny, nz], singular };
}

const place = planarSlot();

/** Plane and circle; a square's conditions and distance are left to its trees. */
function flat(walked: Method, s: Planar, shape: Shape, ray: Ray): Intersection {
  const { origin: E, direction: d } = ray;
  const verdict = solvePlanar(s, E[0], E[1], E[2], d[0], d[1], d[2], place);
  if (verdict !== ONE && verdict !== NONE) return walked.intersect(shape, ray);
  const { t, x, y, z, margin, offset, rate } = place;
  if (Number.isNaN(t)) return walked.intersect(shape, ray);
  const inside = verdict === ONE;
  const { N } = s;
  const hit = { t, point: [x, y, z], normal: [N[0], N[1], N[2]], singular: false } as const;
  return {
    class: inside ? 'one' : 'none',
    hits: inside ? [hit] : [],
    method: walked.id,
    decidedBy: 'formula',
    details: {
      family: 'flat',
      offset,
      rate,
      signs: { offset: signOf(offset), rate: signOf(rate) },
      plane: {
        ...hit,
        holds: s.bound === 'none' ? [] : [inside],
        inside,
        distance: inside ? 0 : -margin,
      },
      meetsFigure: null,
    },
  };
}

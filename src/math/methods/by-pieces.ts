import { exact } from '../arithmetic/exact.ts';
import { float64 } from '../arithmetic/float64.ts';
import { type NONE, ONE, TANGENT, TWO, VERDICTS } from '../batch/batch.ts';
import {
  AT_NORMAL,
  AT_POINT,
  AT_ROOTS,
  type Pieces,
  type PutNormal,
  SLOT,
} from '../batch/one-ray.ts';
import type { Values } from '../formula/evaluate.ts';
import type { Hit, Intersection } from '../intersection.ts';
import { lazily } from '../lazily.ts';
import type { Ray } from '../ray.ts';
import type { Shape } from '../shapes/index.ts';
import { definitionOf } from '../shapes/lookup.ts';
import type { FlatFormula } from '../shapes/planar.ts';
import type { Vec3 } from '../vec3.ts';
import type { Method } from './define.ts';
import { flatAnswer } from './tree-flat.ts';
import { valuesOf } from './tree-method.ts';
import { answer, curvedDetails } from './tree-parts.ts';

const ownSlot = lazily(() => new Float64Array(SLOT));
type Slot = Float64Array;
const triple = (slot: Slot, k: number): Vec3 => [
  slot[k] as number,
  slot[k + 1] as number,
  slot[k + 2] as number,
];

/**
 * `intersect` of the method `walked` by code that was generated from its trees (pieces of
 * src/math/batch/one-ray.ts): the same bits at a small part of the price. For a shape without
 * pieces the trees are walked.
 */
export function intersectByPieces(
  walked: Method,
  { forms, roots, point, normals }: Pieces,
): Method['intersect'] {
  const about = { id: walked.id, decidedBy: 'formula', arithmetic: float64 } as const;

  function curved(
    slot: Slot,
    putNormal: PutNormal,
    values: Values<number>,
    { origin, direction }: Ray,
  ): Intersection {
    const verdict = roots(slot);
    const details = curvedDetails(triple(slot, 0), slot[3] as number, float64);
    const hits: Hit[] = [];
    const add = (root: 0 | 1): void => {
      point(origin, direction, slot, root);
      putNormal(values, slot);
      hits.push(hitOf(slot, slot[AT_ROOTS + root] as number));
    };
    if (verdict === TWO || verdict === ONE || verdict === TANGENT) add(0);
    if (verdict === TWO) add(1);
    const { id: method, decidedBy } = about;
    return answer({ class: VERDICTS[verdict as typeof NONE], hits, method, decidedBy, details });
  }

  function flat(
    slot: Slot,
    formula: FlatFormula,
    values: Values<number>,
    shape: Shape,
    ray: Ray,
  ): Intersection {
    const [offset, rate, t] = triple(slot, 0);
    const { scalars, vectors } = values;
    const conditions = formula.bound?.conditions.length ?? 0;
    return flatAnswer(formula, rate, offset, about, {
      N: vectors.N as Vec3,
      meeting: () => ({
        t,
        x: triple(slot, AT_POINT),
        excesses: Array.from({ length: conditions }, (_, k) => slot[AT_NORMAL + k] as number),
      }),
      values: () => ({ scalars, vectors: { ...vectors, E: ray.origin, d: ray.direction } }),
      exactly: () => valuesOf(shape, ray, exact),
    });
  }

  return (shape, ray) => {
    const form = forms[shape.kind];
    if (!form) return walked.intersect(shape, ray);
    const definition = definitionOf(shape);
    const values = definition.values(shape);
    const slot = ownSlot();
    form(values, ray.origin, ray.direction, slot);
    const normal = normals[shape.kind];
    if (normal) return curved(slot, normal, values, ray);
    return flat(slot, definition.formula(shape) as FlatFormula, values, shape, ray);
  };
}

function hitOf(slot: Slot, t: number): Hit {
  const normal = triple(slot, AT_NORMAL);
  const singular = normal[0] === 0 && normal[1] === 0 && normal[2] === 0;
  return { t, point: triple(slot, AT_POINT), normal: singular ? [0, 0, 0] : normal, singular };
}

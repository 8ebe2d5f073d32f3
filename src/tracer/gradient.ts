import { quadricOf } from '../math/batch.ts';
import { evaluateTriple, float64, withScalars } from '../math/formula.ts';
import type { Shape, Vec3 } from '../math/index.ts';
import { definitionOf } from '../math/shapes.ts';

/**
 * How a surface's gradient is computed: the constant N of a flat shape, (x − Cx, −a(y − Cy),
 * z − Cz) of a round quadric, or the shape's trees.
 */
export interface GradientOf {
  readonly by: 'plane' | 'quadric' | 'trees';
  /** Unit normal. */
  readonly N: Vec3;
  readonly center: Vec3;
  readonly a: number;
  at(x: number, y: number, z: number): Vec3;
}

export function gradientOf(shape: Shape): GradientOf {
  const definition = definitionOf(shape);
  const formula = definition.formula(shape);
  const values = definition.values(shape);
  if (formula.family === 'flat') {
    const N = unit(values.vectors.N as Vec3);
    return { by: 'plane', N, center: N, a: 0, at: () => N };
  }
  const q = quadricOf(shape);
  const a = q ? (q.squared ? q.flare * q.flare : q.hasY ? q.flare : 0) : 0;
  const center: Vec3 = q ? [q.Cx, q.hasY ? q.Cy : 0, q.Cz] : [0, 0, 0];
  const [Cx, Cy, Cz] = center;
  return {
    by: q ? 'quadric' : 'trees',
    N: [0, 1, 0],
    center,
    a,
    at: q
      ? (x, y, z) => [x - Cx, -a * (y - Cy), z - Cz]
      : (x, y, z) => evaluateTriple(formula.normal, float64, withScalars(values, { x, y, z })),
  };
}

export function unit(v: Vec3): Vec3 {
  // Scaled first, so that no square over- or underflows.
  const size = Math.max(Math.abs(v[0]), Math.abs(v[1]), Math.abs(v[2]));
  const [x, y, z] = [v[0] / size, v[1] / size, v[2] / size];
  const length = Math.sqrt(x * x + y * y + z * z);
  return [x / length, y / length, z / length];
}

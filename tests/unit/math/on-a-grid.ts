import type { Ray } from '../../../src/math/ray.ts';
import { integer, pick, type Random } from '../../../src/math/rng.ts';
import type { ShapeDefinition } from '../../../src/math/shapes/define.ts';
import type { Shape } from '../../../src/math/shapes/index.ts';
import type { Param } from '../../../src/math/shapes/params.ts';
import { AXES, type Axis, type Vec3 } from '../../../src/math/vec3.ts';

/*
 * Random shapes and rays whose numbers are whole multiples of a power of two, few bits long: sums,
 * shifts and exchanges of them are exact, and exact degeneracies (tangents, generators, rays in a
 * plane) come up by themselves.
 */

type AnyDefinition = ShapeDefinition<Shape>;
type Value = Vec3 | number | Axis;

/** A multiple of `step` within [low, high]. */
const onGrid = (random: Random, step: number, low: number, high: number): number =>
  integer(random, Math.ceil(low / step), Math.floor(high / step)) * step;

function gridVector(random: Random, step: number, size: number, nonZero: boolean): Vec3 {
  const x = (): number => onGrid(random, step, -size, size);
  const v: Vec3 = [x(), x(), x()];
  return nonZero && v.every((c) => c === 0) ? gridVector(random, step, size, nonZero) : v;
}

function gridValue(random: Random, step: number, param: Param): Value {
  if (param.type === 'axis') return pick(random, ['x', 'y', 'z']);
  const [low, high] = param.range;
  if (param.type === 'number') {
    return onGrid(random, step, Math.max(low, param.least ?? low), high);
  }
  return gridVector(random, step, high, param.nonZero === true);
}

export function gridShape(random: Random, { kind, params }: AnyDefinition, step: number): Shape {
  const values = params.map((param) => [param.key, gridValue(random, step, param)] as const);
  return { kind, ...Object.fromEntries(values) } as unknown as Shape;
}

const gridRay = (random: Random, step: number): Ray => ({
  origin: gridVector(random, step, 5, false),
  direction: gridVector(random, step, 2, true),
});

export interface GridCase {
  readonly shape: Shape;
  readonly ray: Ray;
}

/** Half of them on a grid of whole numbers, half on one of eighths. */
export function gridCases(random: Random, definition: AnyDefinition, count: number): GridCase[] {
  return Array.from({ length: count }, (_, i) => {
    const step = i % 2 === 0 ? 1 : 1 / 8;
    return { shape: gridShape(random, definition, step), ray: gridRay(random, step) };
  });
}

/** The shape with a function applied to every parameter. */
export function mapParams(
  shape: Shape,
  { params }: AnyDefinition,
  f: (param: Param, value: Value) => Value,
): Shape {
  const given = shape as unknown as Record<string, Value>;
  const changed = params.map((param) => [param.key, f(param, given[param.key] as Value)] as const);
  return { ...shape, ...Object.fromEntries(changed) } as unknown as Shape;
}

export const swapXZ = ([x, y, z]: Vec3): Vec3 => [z, y, x];
export const swapAxis = (axis: Axis): Axis => AXES[2 - AXES.indexOf(axis)] ?? axis;
export const shift = (v: Vec3, by: Vec3): Vec3 => [v[0] + by[0], v[1] + by[1], v[2] + by[2]];
export const timesPower = ([x, y, z]: Vec3, factor: number): Vec3 => [
  x * factor,
  y * factor,
  z * factor,
];

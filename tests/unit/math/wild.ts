import type { Question } from '../../../src/math/families.ts';
import { integer, seeded, wide } from '../../../src/math/rng.ts';
import { SHAPES, type Shape } from '../../../src/math/shapes/index.ts';
import type { Param } from '../../../src/math/shapes/params.ts';
import { AXES, type Vec3 } from '../../../src/math/vec3.ts';

/**
 * Shapes and rays of every exponent, and the extremes: overflow and underflow at every step of the
 * formulas.
 */
export function wild(seed: number, count: number): Question[] {
  const random = seeded(seed);
  const extremes = [0, -0, Number.MIN_VALUE, Number.MAX_VALUE, -Number.MAX_VALUE, 1e-160, 1e154, 1];
  const any = (): number =>
    random() < 0.3
      ? (extremes[integer(random, 0, extremes.length - 1)] as number)
      : wide(
          random,
          ...((
            [
              [-1074, 1023],
              [-200, 200],
              [-8, 8],
            ] as const
          )[integer(random, 0, 2)] as [number, number]),
        );
  const vector = (): Vec3 => [any(), any(), any()];
  const nonZero = (): Vec3 => {
    const v = vector();
    return v.some((x) => x !== 0) ? v : [1, 0, 0];
  };
  const value = (param: Param): unknown => {
    if (param.type === 'axis') return AXES[integer(random, 0, 2)];
    if (param.type === 'vector') return param.nonZero ? nonZero() : vector();
    return param.least === undefined ? any() : Math.abs(any());
  };
  const shapeAt = (i: number): Shape => {
    const { kind, params } = SHAPES[i % SHAPES.length] as (typeof SHAPES)[number];
    const values = params.map((param) => [param.key, value(param)] as const);
    return { kind, ...Object.fromEntries(values) } as unknown as Shape;
  };
  return Array.from({ length: count }, (_, i) => ({
    shape: shapeAt(i),
    ray: { origin: vector(), direction: nonZero() },
  }));
}

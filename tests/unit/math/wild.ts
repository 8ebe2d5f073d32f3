import type { Question } from '../../../src/math/families.ts';
import { integer, seeded, wide } from '../../../src/math/rng.ts';
import type { Shape } from '../../../src/math/shapes/index.ts';
import type { Vec3 } from '../../../src/math/vec3.ts';

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
  const shapes: (() => Shape)[] = [
    () => ({ kind: 'cylinder', center: vector(), radius: Math.abs(any()) }),
    () => ({ kind: 'cone', vertex: vector(), slope: any() }),
    () => ({ kind: 'hyperboloid', center: vector(), flare: any(), radius: Math.abs(any()) }),
    () => ({ kind: 'plane', normal: nonZero(), point: vector() }),
    () => ({ kind: 'circle', normal: nonZero(), center: vector(), radius: Math.abs(any()) }),
    () => ({
      kind: 'square',
      corner: vector(),
      side: Math.abs(any()),
      axis: (['x', 'y', 'z'] as const)[integer(random, 0, 2)] as 'x',
    }),
    () => ({ kind: 'sphere', center: vector(), radius: Math.abs(any()) }),
    () => ({ kind: 'paraboloid', vertex: vector(), width: any() }),
  ];
  return Array.from({ length: count }, (_, i) => ({
    shape: (shapes[i % shapes.length] as () => Shape)(),
    ray: { origin: vector(), direction: nonZero() },
  }));
}

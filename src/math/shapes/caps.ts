import type { Vec3 } from '../vec3.ts';
import type { Heights } from './body.ts';
import type { Shape } from './index.ts';
import { definitionOf } from './lookup.ts';

/** A disc that closes an end of a round shape, its normal outwards. */
interface Cap {
  readonly end: 'low' | 'high';
  readonly circle: Extract<Shape, { readonly normal: Vec3; readonly radius: number }>;
}

/**
 * The discs that close the ends of a shape between two heights, their radii as doubles: where the
 * shape has a circle. What exactly a line meets is told by `intersect` with `caps`.
 *
 * @param shape a round one; others have none.
 * @param between the heights, in units of length.
 * @example
 * const cone = { kind: 'cone', vertex: [0, 0, 0], slope: 2 } as const;
 * capsOf(cone, [0, 1]).map(({ end, circle }) => [end, circle.radius]); // → [['high', 2]]
 */
export function capsOf(shape: Shape, [low, high]: Heights): readonly Cap[] {
  const cap = (end: Cap['end'], height: number, up: 1 | -1): Cap[] => {
    const disc = definitionOf(shape).body().circleAt?.(shape, height);
    if (!disc) return [];
    const { x, z, radius } = disc;
    const center: Vec3 = [x, height, z];
    return [{ end, circle: { kind: 'circle', normal: [0, up, 0], center, radius } }];
  };
  return [...cap('low', low, -1), ...cap('high', high, 1)];
}

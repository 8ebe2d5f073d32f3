import { quadricOf } from '../math/batch/quadric.ts';
import type { Shape } from '../math/shapes/index.ts';
import type { Placed, Scene } from './types.ts';

export type SurfacePart = 'shape' | 'low cap' | 'high cap';

/** What a ray can hit: a thing's shape, or a circle that closes one of its ends. */
export interface Surface {
  /** Index into the scene's things. */
  readonly thing: number;
  readonly part: SurfacePart;
  readonly shape: Shape;
  /** Only the shape itself is cut off, not its caps. */
  readonly between?: readonly [low: number, high: number];
}

/** All surfaces of a scene in a fixed order: what a hit, a ray tree and a frame mean by an index. */
export function surfacesOf(scene: Scene): readonly Surface[] {
  return scene.things.flatMap((placed, thing): Surface[] => {
    const { shape, between } = placed;
    const own: Surface = { thing, part: 'shape', shape, ...(between ? { between } : {}) };
    return [own, ...capsOf(placed, thing)];
  });
}

/** Two circles about the axis, their normals outwards. */
function capsOf({ shape, between, capped }: Placed, thing: number): Surface[] {
  if (!between || !capped) return [];
  const cap = (part: SurfacePart, height: number, up: 1 | -1): Surface[] => {
    const profile = profileOf(shape, height);
    if (!profile) return [];
    const { x, z, radius } = profile;
    const circle: Shape = { kind: 'circle', normal: [0, up, 0], center: [x, height, z], radius };
    return [{ thing, part, shape: circle }];
  };
  return [...cap('low cap', between[0], -1), ...cap('high cap', between[1], 1)];
}

/** The circle that a round shape has at a height, or null: none there, or not a round shape. */
export function profileOf(
  shape: Shape,
  height: number,
): { readonly x: number; readonly z: number; readonly radius: number } | null {
  const q = quadricOf(shape);
  if (!q) return null;
  const h = q.hasY ? height - q.Cy : 0;
  const squared = q.squared ? (q.flare * h) ** 2 : q.flare * h * h;
  const radius = Math.sqrt(squared + q.r * q.r);
  return radius > 0 ? { x: q.Cx, z: q.Cz, radius } : null;
}

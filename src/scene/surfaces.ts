import type { Heights } from '../math/drawing.ts';
import type { Shape } from '../math/index.ts';
import { definitionOf } from '../math/shapes.ts';
import type { Placed, Scene } from './types.ts';

type SurfacePart = 'shape' | 'low cap' | 'high cap';

/** What a ray can hit: a thing's shape, or a circle that closes one of its ends. */
export interface Surface {
  /** Index into the scene's things. */
  readonly thing: number;
  readonly part: SurfacePart;
  readonly shape: Shape;
  /** Only the shape itself is cut off, not its caps. */
  readonly between?: Heights;
}

/**
 * All surfaces of a scene in a fixed order: what a hit, a ray tree and a frame mean by an index.
 */
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
    const disc = definitionOf(shape).body.circleAt?.(shape, height);
    if (!disc) return [];
    const { x, z, radius } = disc;
    const circle: Shape = { kind: 'circle', normal: [0, up, 0], center: [x, height, z], radius };
    return [{ thing, part, shape: circle }];
  };
  return [...cap('low cap', between[0], -1), ...cap('high cap', between[1], 1)];
}

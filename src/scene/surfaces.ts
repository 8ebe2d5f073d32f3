import type { Heights } from '../math/drawing.ts';
import type { Shape } from '../math/index.ts';
import { definitionOf } from '../math/shapes.ts';
import type { Placed, Scene } from './types.ts';

type SurfacePart = 'shape' | 'low cap' | 'high cap';

/** A surface that rays can hit: a thing's shape, or a cap (a circle that closes an end). */
export interface Surface {
  /** Index into the scene's things. */
  readonly thing: number;
  readonly part: SurfacePart;
  readonly shape: Shape;
  /** Heights that cut the shape off; caps have none. */
  readonly between?: Heights;
}

/** All surfaces of a scene, in the order to which indices in hits, ray trees and frames refer. */
export function surfacesOf(scene: Scene): readonly Surface[] {
  return scene.things.flatMap((placed, thing): Surface[] => {
    const { shape, between } = placed;
    const own: Surface = { thing, part: 'shape', shape, ...(between ? { between } : {}) };
    return [own, ...capsOf(placed, thing)];
  });
}

/** The caps: two circles about the axis with outward normals. */
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

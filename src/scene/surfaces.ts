import { type Box, capsOf, type Heights } from '../math/drawing.ts';
import type { Shape } from '../math/index.ts';
import { definitionOf } from '../math/shapes.ts';
import type { Scene, Thing } from './types.ts';

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

/** A box slightly larger than the surface, or than all of a thing; null for an unbounded one. */
export const boxOf = ({ shape, between }: Pick<Surface, 'shape' | 'between'>): Box | null =>
  definitionOf(shape)
    .body()
    .box(shape, between ?? null);

/** All surfaces of a scene, in the order to which indices in hits, ray trees and frames refer. */
export function surfacesOf(scene: Scene): readonly Surface[] {
  return scene.things.flatMap((placed, thing): Surface[] => {
    const { shape, between } = placed;
    const own: Surface = { thing, part: 'shape', shape, ...(between ? { between } : {}) };
    return [own, ...capsOfThing(placed, thing)];
  });
}

/** The caps: two circles about the axis with outward normals. */
function capsOfThing({ shape, between, capped }: Thing, thing: number): Surface[] {
  if (!between || !capped) return [];
  return capsOf(shape, between).map(({ end, circle }) => ({
    thing,
    part: `${end} cap`,
    shape: circle,
  }));
}

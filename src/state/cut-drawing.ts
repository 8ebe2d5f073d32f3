import { capsOf, type Drawing, type Patch, type PatchEnd, type Stage } from '../math/drawing.ts';
import type { Shape, Vec3 } from '../math/index.ts';
import { definitionOf } from '../math/shapes.ts';
import type { Between } from './heights.ts';
import { isDrawn } from './stage.ts';

/** Beyond it distances of two points are no doubles; a picture shows nothing so far off. */
const LARGEST = 1e300;

/** Points that a picture of a shape with these ends has to have room for. */
export function endPoints(shape: Shape, between: Between): readonly Vec3[] {
  const [x, , z] = definitionOf(shape).anchor(shape).at;
  const rims = capsOf(shape, between).map(({ circle: { center, radius } }): Vec3 => {
    const [a, y, b] = center;
    return [a + radius, y, b];
  });
  const points = [...between.map((y): Vec3 => [x, y, z]), ...rims];
  return points.filter((point) => point.every((p) => Math.abs(p) < LARGEST));
}

/** The drawing between two heights, closed by discs. */
export function cutDrawing(
  drawing: Drawing,
  shape: Shape,
  stage: Stage,
  between: Between,
  caps: boolean,
): Drawing {
  const walls = drawing.patches.flatMap((patch) => cutPatch(patch, between) ?? []);
  const discs = caps
    ? capsOf(shape, between).flatMap(({ circle }) => {
        const [x, y, z] = circle.center;
        const isNear = isDrawn([x + circle.radius, y, z], stage);
        return isNear ? definitionOf(circle).draw(circle, stage).patches : [];
      })
    : [];
  return { ...drawing, patches: [...walls, ...discs] };
}

/**
 * A patch between two heights; null where nothing is left of it. One whose height depends on more
 * than v is left whole.
 */
function cutPatch(patch: Patch, [low, high]: Between): Patch | null {
  const y = (v: number): number => patch.at(0, v)[1];
  const [bottom, top] = [y(0), y(1)];
  const isLevel = [0.25, 0.5, 0.75].every((v) => patch.at(0.5, v)[1] === y(v));
  if (!isLevel || !(bottom < top)) return patch;
  if (top <= low || bottom >= high) return null;
  const from = low > bottom ? where(y, low) : 0;
  const to = high < top ? where(y, high) : 1;
  const at = (v: number): number => from + v * (to - from);
  const ended = (end: PatchEnd, isCut: boolean): PatchEnd => (isCut ? 'edge' : end);
  return {
    ...patch,
    at(u, v) {
      const [x, height, z] = patch.at(u, at(v));
      // The rim is at the height itself, where the disc is.
      return [x, Math.min(Math.max(height, low), high), z];
    },
    normal: (u, v) => patch.normal(u, at(v)),
    rings: patch.rings.map((v) => (v - from) / (to - from)).filter((v) => v > 0 && v < 1),
    start: ended(patch.start, from > 0),
    end: ended(patch.end, to < 1),
  };
}

/** v where a rising height is reached. */
function where(y: (v: number) => number, height: number): number {
  let [low, high] = [0, 1];
  for (let k = 0; k < 52; k++) {
    const middle = (low + high) / 2;
    if (y(middle) < height) low = middle;
    else high = middle;
  }
  return (low + high) / 2;
}

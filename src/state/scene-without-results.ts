import type { Drawing, Stage } from '../math/drawing.ts';
import type { Ray, Shape, Vec3 } from '../math/index.ts';
import { definitionOf } from '../math/shapes.ts';
import { display, displayTriple } from '../text/format.ts';
import type { View } from './camera-view.ts';
import { cutDrawing, endPoints } from './cut-drawing.ts';
import type { Between } from './heights.ts';
import { clipToStage } from './scene.ts';
import type { RaySegment, SceneModel } from './scene-model.ts';
import { isDrawn, stageAround } from './stage.ts';

const EVERYWHERE = { from: Number.NEGATIVE_INFINITY, to: Number.POSITIVE_INFINITY };

/** A ray, a shape with the heights of its ends, and a second shape if there is one. */
interface SceneInput {
  readonly shape: Shape;
  readonly ray: Ray;
  readonly between?: Between;
  readonly other?: Shape;
}

/**
 * A scene of shape and ray without results, on a stage with room for them and for `points`. Neither
 * its size nor the drawn part of the ray depends on where the two meet.
 */
export function sceneWithoutResults(
  { shape, ray, between, other }: SceneInput,
  points: readonly Vec3[],
  view: View,
): SceneModel {
  const { title } = definitionOf(shape);
  const ends = between ? endPoints(shape, between) : [];
  const second = other ? [definitionOf(other).anchor(other).at] : [];
  const stage = stageAround(shape, [ray.origin, ...points, ...ends, ...second]);
  const reach = clipToStage(ray, stage, EVERYWHERE);
  const originDrawn = isDrawn(ray.origin, stage);
  const { origin, direction } = ray;
  const own = definitionOf(shape).draw(shape, stage);
  const cut = between ? cutDrawing(own, shape, stage, between, false) : own;
  const heights = between
    ? `, from y = ${display(between[0])} to y = ${display(between[1])}, open at its ends`
    : '';
  return {
    shapeTitle: title,
    stage,
    drawing: other ? withOther(cut, other, stage) : cut,
    ray: { origin, direction, segments: reach ? cutAtE(reach) : [], ticks: [], originDrawn },
    hits: [],
    ghost: null,
    bead: null,
    handles: [],
    view,
    notes: originDrawn ? [] : [`E ${displayTriple(origin, 3)} lies outside the drawn part`],
    description:
      `A ray from E ${displayTriple(origin)} in direction d ` +
      `${displayTriple(direction)} and a ${title}${heights}` +
      `${other ? `, and a ${definitionOf(other).title}` : ''}.`,
  };
}

/** Both shapes, the second without names of its points: they would be those of the first. */
function withOther(drawing: Drawing, other: Shape, stage: Stage): Drawing {
  const { patches, lines } = definitionOf(other).draw(other, stage);
  return {
    ...drawing,
    patches: [...drawing.patches, ...patches],
    lines: [...drawing.lines, ...lines],
  };
}

function cutAtE({ from, to }: { from: number; to: number }): RaySegment[] {
  const behind: RaySegment = { from, to: Math.min(to, 0), stretch: 'behind' };
  const ahead: RaySegment = { from: Math.max(from, 0), to, stretch: 'before' };
  return [behind, ahead].filter((part) => part.from < part.to);
}

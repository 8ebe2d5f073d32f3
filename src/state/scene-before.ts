import type { Ray, Shape, Vec3 } from '../math/index.ts';
import { definitionOf } from '../math/shapes.ts';
import { displayTriple } from '../text/format.ts';
import { clipToStage } from './scene.ts';
import type { RaySegment, SceneModel } from './scene-model.ts';
import { isDrawn, stageAround } from './stage.ts';
import type { View } from './view.ts';

const EVERYWHERE = { from: Number.NEGATIVE_INFINITY, to: Number.POSITIVE_INFINITY };

/**
 * A scene of shape and ray without results, on a stage with room for them and for `points`. Neither
 * its size nor the drawn part of the ray depends on where the two meet.
 */
export function sceneBefore(
  shape: Shape,
  ray: Ray,
  points: readonly Vec3[],
  view: View,
): SceneModel {
  const definition = definitionOf(shape);
  const stage = stageAround(shape, [ray.origin, ...points]);
  const reach = clipToStage(ray, stage, EVERYWHERE);
  const originDrawn = isDrawn(ray.origin, stage);
  const { origin, direction } = ray;
  return {
    shapeTitle: definition.title,
    stage,
    drawing: definition.draw(shape, stage),
    ray: { origin, direction, segments: reach ? cutAtE(reach) : [], ticks: [], originDrawn },
    hits: [],
    ghost: null,
    bead: null,
    handles: [],
    view,
    notes: originDrawn ? [] : [`E ${displayTriple(origin, 3)} lies outside the drawn part`],
    description:
      `A ray from E ${displayTriple(origin)} in direction d ` +
      `${displayTriple(direction)} and a ${definition.title}.`,
  };
}

function cutAtE({ from, to }: { from: number; to: number }): RaySegment[] {
  const behind: RaySegment = { from, to: Math.min(to, 0), stretch: 'behind' };
  const ahead: RaySegment = { from: Math.max(from, 0), to, stretch: 'before' };
  return [behind, ahead].filter((part) => part.from < part.to);
}

import type { SceneModel, Stretch } from '../state/scene-model.ts';
import { along, type Point, type StageUnits } from './stage-units.ts';
import { type Dash, type Stroke, straight } from './stroke.ts';

const STRETCHES: Record<Stretch, { width: number; alpha: number; dash: Dash | null }> = {
  behind: { width: 1.6, alpha: 0.55, dash: [4, 6] },
  before: { width: 2.6, alpha: 1, dash: null },
  inside: { width: 5.2, alpha: 1, dash: null },
  after: { width: 2.2, alpha: 1, dash: [8, 5] },
};

const HELPER = { ink: 'ink3', width: 1, alpha: 0.75, dash: [4, 4] as Dash } as const;

type Line = Pick<SceneModel['ray'], 'origin' | 'direction'>;

/** R(t) in stage units, computed in world coordinates, since E may be far away and t large. */
export function pointAt(ray: Line, t: number, units: StageUnits): Point | null {
  return units.toStage(along(ray.origin, ray.direction, t));
}

export function rayStrokes(ray: SceneModel['ray'], units: StageUnits, emphasis: number): Stroke[] {
  const strokes: Stroke[] = [];
  for (const { from, to, stretch } of ray.segments) {
    const a = pointAt(ray, from, units);
    const b = pointAt(ray, to, units);
    const style = STRETCHES[stretch];
    if (a && b) strokes.push(straight(a, b, { ink: 'd', ...style, width: style.width * emphasis }));
  }
  return strokes;
}

/** The ray's shadow on the ground, and vertical lines to it from E and the drawn hits. */
export function shadowStrokes(model: SceneModel, units: StageUnits): Stroke[] {
  const { ray, hits } = model;
  const strokes: Stroke[] = [];
  const first = ray.segments[0];
  const last = ray.segments.at(-1);
  const onGround = (p: Point): Point => [p[0], units.ground, p[2]];
  const from = first && pointAt(ray, first.from, units);
  const to = last && pointAt(ray, last.to, units);
  if (from && to) strokes.push(straight(onGround(from), onGround(to), HELPER));
  const plumbed = hits.filter((hit) => hit.drawn).map((hit) => hit.point);
  if (ray.originDrawn) plumbed.push(ray.origin);
  for (const point of plumbed) {
    const p = units.toStage(point);
    if (p) strokes.push(straight(p, onGround(p), HELPER));
  }
  return strokes;
}

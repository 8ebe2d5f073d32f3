import { closestApproach } from '../math/formula.ts';
import type { Vec3 } from '../math/index.ts';
import type { ExploreModel, FullModel } from './derive.ts';
import type { GraphModel } from './graph-model.ts';
import type { FigureLine, SceneModel } from './scene-model.ts';

/** Number of corners of the polygon that a circle is drawn as. */
const CORNERS = 96;

/** The steps that are about D. */
const ABOUT_D: ReadonlySet<string> = new Set(['complete', 'roots']);

/** The steps that say something of f, whose graph then has to be in view. */
const ABOUT_F = {
  curved: new Set(['collect', 'coefficients', 'complete', 'roots']),
  flat: new Set(['expand', 't']),
};

export const isAboutF = (
  { shown, found }: Pick<ExploreModel, 'shown' | 'found'>,
  step: string,
): boolean => shown.hits && ABOUT_F[found.details.family].has(step);

const isAboutD = ({ shown, exactly }: FullModel, step: string): boolean => {
  const { details } = exactly.found;
  return shown.hits && ABOUT_D.has(step) && details.family === 'curved' && details.signs.A !== 0;
};

/** The graph, at a step about D with the completed square drawn in. */
export function graphAt(model: FullModel, step: string): GraphModel {
  const { graph, found } = model;
  if (!isAboutD(model, step) || found.details.family !== 'curved') return graph;
  const { A, B, D } = found.details;
  const square = { t: -B / (2 * A), f: -D / (4 * A), half: Math.sqrt(D) / Math.abs(2 * A) };
  return Number.isFinite(square.t) && Number.isFinite(square.f) ? { ...graph, square } : graph;
}

/** The scene, at a step about D with the closest approach of the line drawn in. */
export function sceneAt(model: FullModel, step: string): SceneModel {
  const { scene } = model;
  const closest = isAboutD(model, step) ? closestApproach(model.shape, model.ray) : null;
  if (!closest) return scene;
  const { point, foot, round, radius } = closest;
  const [u, v] = planeOf(closest, model.ray.direction, round.length === 2 ? round : null);
  const onCircle = (angle: number): Vec3 =>
    moved(foot, [u, radius * Math.cos(angle)], [v, radius * Math.sin(angle)]);
  const figures: FigureLine[] = [
    {
      points: Array.from({ length: CORNERS }, (_, i) => onCircle((2 * Math.PI * i) / CORNERS)),
      closed: true,
      ink: 'shape',
    },
    { points: [foot, point], closed: false, ink: 'ink3' },
  ];
  return { ...scene, figures: [...(scene.figures ?? []), ...figures] };
}

type Closest = NonNullable<ReturnType<typeof closestApproach>>;

/** Two orthogonal unit vectors that span the circle's plane, the first towards the line. */
function planeOf(
  { point, foot }: Closest,
  d: Vec3,
  round: Closest['round'] | null,
): readonly [Vec3, Vec3] {
  if (round) {
    const [u, v] = round.map(
      (axis): Vec3 => [axis === 'x' ? 1 : 0, axis === 'y' ? 1 : 0, axis === 'z' ? 1 : 0],
    );
    return [u ?? [1, 0, 0], v ?? [0, 0, 1]];
  }
  const along = unit(d);
  const away: Vec3 = [point[0] - foot[0], point[1] - foot[1], point[2] - foot[2]];
  const towards = away.some((x) => x !== 0) ? away : across(along);
  return [unit(towards), along];
}

/** A vector orthogonal to this one. */
const across = ([x, y, z]: Vec3): Vec3 => (x === 0 && z === 0 ? [1, 0, 0] : [z, 0 * y, -x]);

function unit(v: Vec3): Vec3 {
  const length = Math.hypot(...v);
  return [v[0] / length, v[1] / length, v[2] / length];
}

const moved = (from: Vec3, ...by: readonly (readonly [Vec3, number])[]): Vec3 => {
  const at = (i: 0 | 1 | 2): number => by.reduce((sum, [v, k]) => sum + k * v[i], from[i]);
  return [at(0), at(1), at(2)];
};

import { closestApproach } from '../math/formula.ts';
import type { Intersection, Vec3 } from '../math/index.ts';
import type { ExploreModel, FullModel } from './derive.ts';
import type { GraphModel } from './graph-model.ts';
import type { FigureLine, NormalArrow, SceneModel } from './scene-model.ts';
import { normalFigure } from './walk-normal.ts';
import { facingSign } from './walk-words.ts';

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

/** Normals that can be shown beside the course's. */
export interface NormalChoice {
  /** That of length 1, with the course's in its own length. */
  readonly unit: boolean;
  /** The one that points against d, where the course's does not. */
  readonly facing: boolean;
}

const NONE_BESIDE: NormalChoice = { unit: false, facing: false };

/** The steps that are about N: the last one of a curved shape, and N·d of a flat one. */
const ABOUT_N: ReadonlySet<string> = new Set(['normal', 't']);

/**
 * The scene with what a step of the derivation draws: the closest approach of the line where it is
 * about D, level surfaces and normals where it is about N, the distance to a circle's centre.
 */
export function sceneAt(
  model: FullModel,
  step: string,
  choice: NormalChoice = NONE_BESIDE,
): SceneModel {
  if (!model.shown.hits) return model.scene;
  if (ABOUT_N.has(step)) return aboutN(model, choice);
  return step === 'figure' ? aboutFigure(model) : aboutD(model, step);
}

const drawn = (scene: SceneModel, figures: readonly FigureLine[]): SceneModel => ({
  ...scene,
  figures: [...(scene.figures ?? []), ...figures],
});

/** The hit that the step about N speaks of: the first visible one, else the first one. */
export function hitOfNormal({ hits, found }: FullModel | ExploreModel) {
  const first = hits.findIndex(({ role }) => role === 'first');
  const index = Math.max(first, 0);
  const hit = found.hits[index];
  return hit ? { hit, index } : null;
}

function aboutN(model: FullModel, { unit: isUnit, facing }: NormalChoice): SceneModel {
  const { scene, shape, found, ray } = model;
  const about = hitOfNormal(model);
  const figure = about && normalFigure(shape, about.hit, scene.stage);
  const near = scene.hits.filter(({ normal, drawn: isDrawn }) => normal && isDrawn);
  const lengths = near.map(({ normal }) => Math.hypot(...(normal ?? [0, 0, 0])));
  // Scaled together if the longest would leave the picture, or the shortest be invisible.
  const shrunk = scaleFor([1, ...lengths], scene.stage.radius);
  const long = (length: number): number | null => (isUnit ? length * shrunk : null);
  const arrows = near.flatMap(({ index, point, normal }): NormalArrow[] => {
    const n = normal ?? ([0, 0, 0] as Vec3);
    const length = Math.hypot(...n);
    const against = facing && facingOf(found, index - 1, n, ray.direction) > 0;
    const back: Vec3 = [-n[0], -n[1], -n[2]];
    const base = { index, at: point } as const;
    return [
      ...(isUnit ? [{ ...base, letter: 'n', direction: n, length: long(1) }] : []),
      ...(against ? [{ ...base, letter: '−N', direction: back, length: long(length) }] : []),
    ];
  });
  const hits = isUnit
    ? scene.hits.map((hit) =>
        hit.normal ? { ...hit, normalLength: shrunk * Math.hypot(...hit.normal) } : hit,
      )
    : scene.hits;
  return { ...drawn(scene, figure?.lines ?? []), hits, arrows, levels: figure?.levels ?? [] };
}

/** Arrows that differ in length are at most so long, and at least, in radii of the stage. */
const [LONGEST, SHORTEST] = [0.5, 0.06];

function scaleFor(lengths: readonly number[], radius: number): number {
  const [most, least] = [Math.max(...lengths), Math.min(...lengths)];
  if (most > LONGEST * radius) return (LONGEST * radius) / most;
  return least < SHORTEST * radius ? Math.min(SHORTEST / least, LONGEST / most) * radius : 1;
}

/** The sign of N·d: exactly where it is known, else of the doubles. */
function facingOf(found: Intersection, i: number, n: Vec3, d: Vec3): number {
  return facingSign(found, i) ?? n[0] * d[0] + n[1] * d[1] + n[2] * d[2];
}

/** From a circle's centre to where the line meets its plane: the distance that counts. */
function aboutFigure(model: FullModel): SceneModel {
  const { scene, found, derivation } = model;
  const { details } = found;
  if (details.family !== 'flat' || !details.plane) return scene;
  const { point } = details.plane;
  const figures = derivation.conditions.flatMap(({ relation: { left } }): FigureLine[] => {
    if (left.op !== 'norm' || left.of.op !== 'difference' || left.of.right.op !== 'vector')
      return [];
    const center = derivation.numbers.vectors[left.of.right.id];
    return center ? [{ points: [center, point], closed: false, ink: 'ink3' }] : [];
  });
  return drawn(scene, figures);
}

function aboutD(model: FullModel, step: string): SceneModel {
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
  return drawn(scene, figures);
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

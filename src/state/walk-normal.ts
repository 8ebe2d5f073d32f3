import { type Patch, roundStep, type Stage } from '../math/drawing.ts';
import { type Level, levelOf } from '../math/formula.ts';
import type { Hit, Shape, Vec3 } from '../math/index.ts';
import { AXES } from '../math/shapes.ts';
import type { FigureLine } from './scene-model.ts';

/*
 * The figure that explains N: near a hit, the level surfaces F = ±k, the tangent plane, and the
 * change of each coordinate alone that makes F equal to k.
 */

export interface NormalFigure {
  readonly k: number;
  /** F = k and F = −k, as far as they are near. */
  readonly levels: readonly Patch[];
  /** The rim of the tangent plane's patch, and the nudges. */
  readonly lines: readonly FigureLine[];
  /** From the hit to F = k along x, y, z; null where F does not get there, or not by N. */
  readonly nudges: readonly (number | null)[];
}

/** Half the side of the tangent plane's patch, in radii of the stage, and of the surface's bend. */
const REACH = { stage: 0.17, bend: 0.7 };
/** How far F = ±k is from the hit along N, in half sides of the patch. */
const APART = 0.4;
/** A level surface is drawn so far from the tangent plane, in half sides of its patch. */
const NEAR = 1.6;
/** Samples of the rim of a level surface. */
const RIM = 48;

/** The figure at a hit; null where the numbers leave no room for one. */
export function normalFigure(shape: Shape, hit: Hit, stage: Stage): NormalFigure | null {
  const level = levelOf(shape);
  const figure = hit.singular ? aroundVertex(level, hit, stage) : onTangent(level, hit, stage);
  return figure && Number.isFinite(figure.k) && figure.k > 0 ? figure : null;
}

/** Over the tangent plane, along N, to where F is ±k: exact, as F is quadratic on every line. */
function onTangent(level: Level, { point, normal }: Hit, stage: Stage): NormalFigure | null {
  const n = unit(normal);
  if (!n) return null;
  const [u, v] = across(n);
  const slope = level.along(point, n).B;
  const bends = [u, v, plus(u, v), plus(u, scaled(v, -1))].map((e) => level.along(point, e).A);
  const bend = Math.max(...bends.map(Math.abs));
  const reach = Math.min(
    REACH.stage * stage.radius,
    bend > 0 ? (REACH.bend * Math.abs(slope)) / (2 * bend) : Number.POSITIVE_INFINITY,
  );
  if (!(reach > 0) || !Number.isFinite(slope) || slope === 0) return null;
  const k = roundStep(APART * reach * Math.abs(slope));
  const onPlane = (a: number, b: number): Vec3 =>
    plus(plus(point, scaled(u, reach * a)), scaled(v, reach * b));
  const above = (value: number, a: number, b: number): Vec3 => {
    const foot = onPlane(a, b);
    const s = stepTo({ ...level.along(foot, n), C: valueFrom(level, point, foot) }, value);
    return s === null || Math.abs(s) > NEAR * reach ? NOWHERE : plus(foot, scaled(n, s));
  };
  const square = (at: (a: number, b: number) => Vec3): Vec3[] =>
    [
      [-1, -1],
      [1, -1],
      [1, 1],
      [-1, 1],
    ].map(([a = 0, b = 0]) => at(a, b));
  const rims = [k, -k].flatMap((value) => rimOf((a, b) => above(value, a, b)));
  return {
    k,
    levels: [k, -k].map((value) =>
      patchOf((a, b) => above(value, 2 * a - 1, 2 * b - 1), level, false),
    ),
    lines: [
      { points: square(onPlane), closed: true, ink: 'normal' },
      ...rims,
      ...nudgesAt(level, point, k, NEAR * reach),
    ],
    nudges: AXES.map((_, i) => nudge(level, point, i, k)),
  };
}

/** The figure where N is zero: F has no linear term and is ±k at distance √(±k/A), if real. */
function aroundVertex(level: Level, { point }: Hit, stage: Stage): NormalFigure | null {
  const reach = REACH.stage * stage.radius;
  const most = Math.max(...AXES.map((_, i) => Math.abs(level.along(point, axisOf(i)).A)));
  if (!(most > 0)) return null;
  const k = roundStep(most * (APART * reach) ** 2);
  const at = (value: number) => (a: number, b: number) => {
    const [angle, polar] = [2 * Math.PI * a, Math.PI * b];
    const w: Vec3 = [
      Math.sin(polar) * Math.sin(angle),
      -Math.cos(polar),
      Math.sin(polar) * Math.cos(angle),
    ];
    const s = Math.sqrt(value / level.along(point, w).A);
    return s <= reach ? plus(point, scaled(w, s)) : NOWHERE;
  };
  return {
    k,
    levels: [k, -k].map((value) => patchOf(at(value), level, true)),
    lines: [],
    nudges: AXES.map(() => null),
  };
}

/** A patch of a level surface; its borders are no edges of that surface. */
function patchOf(at: (u: number, v: number) => Vec3, level: Level, closed: boolean): Patch {
  return {
    at,
    normal: (u, v) => level.normal(at(u, v)),
    ...{ closed, rings: [], start: 'goes-on', end: 'goes-on', sides: closed ? 'joins' : 'goes-on' },
    stepsV: closed ? 48 : 16,
  };
}

/** The outline of a level surface over the patch of the tangent plane, in unbroken pieces. */
function rimOf(at: (a: number, b: number) => Vec3): FigureLine[] {
  const sides = [
    (s: number) => at(s, -1),
    (s: number) => at(1, s),
    (s: number) => at(-s, 1),
    (s: number) => at(-1, -s),
  ];
  const points = sides.flatMap((side) =>
    Array.from({ length: RIM / 4 }, (_, i) => side((8 * i) / RIM - 1)),
  );
  const whole = [...points, ...points.slice(0, 1)];
  const pieces: Vec3[][] = [[]];
  for (const point of whole) {
    if (point.every(Number.isFinite)) pieces.at(-1)?.push(point);
    else pieces.push([]);
  }
  return pieces
    .filter(({ length }) => length > 1)
    .map((piece) => ({ points: piece, closed: false, ink: 'level' }));
}

function nudgesAt(level: Level, point: Vec3, k: number, most: number): FigureLine[] {
  return AXES.flatMap((_, i): FigureLine[] => {
    const s = nudge(level, point, i, k);
    if (s === null || Math.abs(s) > most) return [];
    return [{ points: [point, plus(point, scaled(axisOf(i), s))], closed: false, ink: 'ink3' }];
  });
}

/** Distance along one axis to F = k; null where the slope of F is 0, or F does not reach k. */
function nudge(level: Level, point: Vec3, i: number, k: number): number | null {
  const line = level.along(point, axisOf(i));
  return line.B === 0 ? null : stepTo({ ...line, C: 0 }, k);
}

/** F at `at`, computed from a point where F is 0: this keeps its digits far from the origin. */
function valueFrom(level: Level, zero: Vec3, at: Vec3): number {
  const { A, B } = level.along(zero, plus(at, scaled(zero, -1)));
  return A + B;
}

/** The nearer s with C + B s + A s² = value; null for none. */
function stepTo({ A, B, C }: ReturnType<Level['along']>, value: number): number | null {
  const rest = C - value;
  const D = B * B - 4 * A * rest;
  if (!(D >= 0)) return null;
  const q = B + (B < 0 ? -1 : 1) * Math.sqrt(D);
  return q === 0 ? null : (-2 * rest) / q;
}

const NOWHERE: Vec3 = [Number.NaN, Number.NaN, Number.NaN];

const axisOf = (i: number): Vec3 => [i === 0 ? 1 : 0, i === 1 ? 1 : 0, i === 2 ? 1 : 0];
const plus = (a: Vec3, b: Vec3): Vec3 => [a[0] + b[0], a[1] + b[1], a[2] + b[2]];
const scaled = (v: Vec3, k: number): Vec3 => [k * v[0], k * v[1], k * v[2]];

function unit(v: Vec3): Vec3 | null {
  const length = Math.hypot(...v);
  return length > 0 && Number.isFinite(length) ? scaled(v, 1 / length) : null;
}

/** Two unit vectors at right angles to this one and to each other, the first level. */
function across(n: Vec3): readonly [Vec3, Vec3] {
  const level = unit([n[2], 0, -n[0]]) ?? [1, 0, 0];
  const [x, y, z] = n;
  return [
    level,
    [y * level[2] - z * level[1], z * level[0] - x * level[2], x * level[1] - y * level[0]],
  ];
}

import { type Quadric, quadricOf } from '../../../src/math/batch/quadric.ts';
import * as dy from '../../../src/math/exact/dyadic.ts';
import * as surd from '../../../src/math/exact/surd.ts';
import {
  CLOSED,
  CLOSED_A,
  CROSS_ERROR,
  NARROW_RECENTRED,
  RESIDUAL_SHARE,
  SLOPE_ERROR,
} from '../../../src/math/methods/certified/recentred.ts';
import {
  NARROW_REFINED,
  RESIDUAL_ERROR,
  STEP_ERROR,
} from '../../../src/math/methods/certified/refined.ts';
import type { Ray } from '../../../src/math/ray.ts';
import { pick, type Random, seeded, uniform } from '../../../src/math/rng.ts';
import { climb } from './climb.ts';
import { flareOf, form, solved } from './exact-quadratic.ts';
import { about, grazing, type Kind, log, type Numbers, quarter, questionOf } from './in-a-row.ts';
import type { Off } from './running-error.ts';
import { recentredLike, recentredModel, refinedLike } from './stage-models.ts';

/*
 * The stages after the ordinary rays', at their own values before the last rounding
 * (stage-models.ts). A search looks for rays on which an error is the largest share of its bound:
 * it never is more than the bound, and where one of the bound's constants is weakened, it is. So
 * each constant is needed, and none is far larger than it must be.
 */

const U = 2 ** -53;

export type Stage<Model> = (q: Quadric, ray: Ray) => Model;
export const recentred = recentredLike;
export const rootByRoot = refinedLike;
/** As `recentred`, with A, b and D taken as they are. */
export const closedForm: Stage<Recentred> = (q, ray) => recentredModel(q, ray, true);

type Recentred = ReturnType<typeof recentredModel>;
type Refined = ReturnType<typeof refinedLike>;

export interface Asked<Model> {
  readonly q: Quadric;
  readonly ray: Ray;
  readonly model: Model;
}

export function asked<Model>(stage: Stage<Model>, kind: Kind, x: Numbers): Asked<Model> | null {
  if (!x.every(Number.isFinite)) return null;
  const { shape, ray } = questionOf(kind, x);
  const q = quadricOf(shape) as Quadric;
  return { q, ray, model: stage(q, ray) };
}

/** |sum of `parts` − truth|. */
const offFrom = (truth: surd.Surd, ...parts: number[]): number =>
  Math.abs(surd.toNumber(parts.reduce((rest, x) => surd.sub(rest, surd.fromNumber(x)), truth)));

/** The share of their bounds that the errors have; 0 where nothing is claimed. */
export type Share<Model> = (a: Asked<Model>) => number;

type WithD = { readonly D: Off; readonly error: number; readonly inside: boolean };
export const shareOfD: Share<WithD> = ({ q, ray, model: { D, error, inside } }) =>
  inside && Number.isFinite(D.x) ? offFrom(surd.fromDyadic(quarter(q, ray)), D.x) / error : 0;

export const shareOfRecentredRoots: Share<Recentred> = ({ q, ray, model }) => {
  if (!model.clear) return 0;
  const { t, b, overA, root, overSize, off } = model;
  const middle = -b.x * overA;
  const side = root * overSize;
  const [near, far] = solved(q, ray).roots as [surd.Surd, surd.Surd];
  return Math.max(offFrom(near, t.x, middle - side), offFrom(far, t.x, side + middle)) / off;
};

function exactResidual(q: Quadric, { origin, direction }: Ray, t: number): dy.Dyadic {
  const n = dy.fromNumber;
  const C = [q.Cx, q.Cy, q.Cz];
  const point = origin.map((e, k) =>
    dy.add(dy.sub(n(e), n(C[k] as number)), dy.mul(n(t), n(direction[k] as number))),
  );
  return dy.sub(form(q.hasY ? flareOf(q) : dy.ZERO, point, point), dy.sqr(n(q.r)));
}

/**
 * How far Newton's step is from the root, but for the rounding of f, as a share of what is charged
 * for it.
 */
export const shareOfSteps: Share<Refined> = ({ q, ray, model }) => {
  if (!(model.clear && model.allowed)) return 0;
  const { a, b, half } = model;
  const [low, high] = solved(q, ray).roots as [surd.Surd, surd.Surd];
  const shareAt = ({ t, f }: Refined['a'], sign: number, root: surd.Surd): number => {
    const step = dy.mul(dy.fromNumber(sign * half), exactResidual(q, ray, t));
    const charged = Math.abs(half) * STEP_ERROR * Math.abs(f.x);
    return offFrom(surd.sub(root, surd.fromDyadic(step)), t) / charged;
  };
  return Math.max(shareAt(a, 1, a.t < b.t ? low : high), shareAt(b, -1, a.t < b.t ? high : low));
};

/*
 * What the roundings may come to at worst on a ray, as a share of what is charged for them. `by` is
 * what the constant is multiplied by.
 */
type Charge<Model> = (a: Asked<Model>, by: number) => number;

export const ofB: Charge<Recentred> = ({ model: { b, width, speed } }, by) =>
  b.off / (by * SLOPE_ERROR * width * speed + U * Math.abs(b.x));
/** What f's own last roundings lose, 2u|f|, is charged beside. */
export const ofF: Charge<Recentred> = ({ model: { f, size, width } }, by) =>
  (f.off - 2 * U * Math.abs(f.x)) / (by * CROSS_ERROR * width * (size + NARROW_RECENTRED * width));
export const ofA: Charge<Recentred> = ({ model: { A, square } }, by) =>
  A.off / (by * CLOSED_A * square);
export const ofD: Charge<Recentred> = ({ model: { D, f, square, error, inside } }, by) =>
  inside ? D.off / (error + (by - 1) * square * RESIDUAL_SHARE * Math.abs(f.x)) : 0;
/** The closed form from A, b and D as they are. */
export const ofClosed: Charge<Recentred> = ({ model }, by) => {
  const { clear, around, sizeB, root, overSize } = model;
  return clear ? around.off / (by * CLOSED * (sizeB + root) * overSize) : 0;
};
export const ofResidual: Charge<Refined> = ({ model: { clear, allowed, a } }, by) => {
  if (!(clear && allowed)) return 0;
  const { f, size, width } = a;
  const charged = by * RESIDUAL_ERROR * width * (size + NARROW_REFINED * width);
  return f.off / (charged + 2 * U * Math.abs(f.x));
};

export type Start = (kind: Kind, random: Random) => number[];
const START: readonly [Start, ...Start[]] = [
  (_, r) => about(r),
  (kind, r) => grazing(kind, r, log(r, -30, -1), log(r, -3, 4)),
  (kind, r) => grazing(kind, r, log(r, -12, -1), log(r, 4, 24)),
  (kind, r) => grazing(kind, r, log(r, -40, -1), log(r, 4, 40)),
];
export const any: Start = (kind, r) => pick(r, START)(kind, r);
export const far: Start = (kind, r) => grazing(kind, r, log(r, -30, -1), log(r, 30, 44));
/** So far that a coarse root is hardly known well enough for a step. */
export const farther: Start = (kind, r) => grazing(kind, r, log(r, -14, -1), log(r, 10, 28));
/** A is a small part of its terms. */
export const steep = (kind: Kind, r: Random, bits = uniform(r, 3, 24)): number[] => {
  const x = about(r);
  const phi = uniform(r, 0, 6.3);
  const k = kind === 'cone' ? Math.abs(x[3] as number) : Math.sqrt(Math.abs(x[3] as number));
  const slope = k * (1 + 2 ** -bits);
  return [...x.slice(0, 8), slope * Math.cos(phi), 1, slope * Math.sin(phi)];
};

/** A all but cancels, and t is where nothing is. */
export const asymptotic: Start = (kind, r) => steep(kind, r, uniform(r, 16, 58));

/** Nearly through the middle, from `least` to `most` sizes away, as exponents. */
export const through =
  (least: number, most: number): Start =>
  (kind, r) =>
    grazing(kind, r, 1 - log(r, -50, -2), log(r, least, most));
/** Through the centre or vertex but for a rounding. */
export const central: Start = (_, r) => {
  const x = about(r);
  const t = log(r, -3, 20);
  return x.map((v, i) => (i > 4 && i < 8 ? (x[i - 5] as number) - t * (x[i + 3] as number) : v));
};
/** E so near to the shape that a root is small. */
export const beside: Start = (kind, r) => {
  const x = grazing(kind, r, log(r, -3, -0.1), log(r, -1, 3));
  const rough = asked(rootByRoot, kind, x)?.model.a.t ?? 0;
  const t = Number.isFinite(rough) ? rough * (1 - log(r, -14, -3)) : 0;
  return x.map((v, i) => (i > 4 && i < 8 ? v + t * (x[i + 3] as number) : v));
};

/** √D. */
export const shareOfRoot: Share<Refined> = ({ q, ray, model: { clear, root } }) => {
  if (!clear) return 0;
  const exact = surd.surd(dy.ZERO, dy.ONE, dy.ONE, quarter(q, ray));
  return offFrom(exact, root) / (root * 2 ** -18);
};

export function worst<Model>(
  stage: Stage<Model>,
  kind: Kind,
  start: Start,
  share: Share<Model>,
  seed: number,
): number {
  const random = seeded(seed);
  return climb(random, {
    start: () => start(kind, random),
    score: (x) => {
      const a = asked(stage, kind, x);
      const found = a ? share(a) : 0;
      return Number.isNaN(found) ? 0 : found;
    },
    starts: 10,
    steps: 120,
  });
}

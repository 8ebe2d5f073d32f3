import { type Quadric, quadricOf } from '../../../src/math/batch/quadric.ts';
import * as dy from '../../../src/math/exact/dyadic.ts';
import * as surd from '../../../src/math/exact/surd.ts';
import { AT_SCALED, certifiedQuadric } from '../../../src/math/methods/certified/numbers.ts';
import { RECENTRED_BOUNDS as RECENTRED } from '../../../src/math/methods/certified/recentred.ts';
import { REFINED_BOUNDS as REFINED } from '../../../src/math/methods/certified/refined.ts';
import type { Ray } from '../../../src/math/ray.ts';
import { pick, type Random, seeded, uniform } from '../../../src/math/rng.ts';
import { climb } from './climb.ts';
import { flareOf, form, solved } from './exact-quadratic.ts';
import { about, grazing, type Kind, log, type Numbers, quarter, questionOf } from './in-a-row.ts';
import { namedValues, stageSource } from './named-values.ts';
import { runningError } from './operation-errors.ts';
import type { Off } from './running-error.ts';

/*
 * The stages after the ordinary rays', at their own values before the last rounding. A search looks
 * for rays on which an error is the largest share of its bound: it never is more than the bound,
 * and where one of the bound's constants is weakened, it is. So each constant is needed, and none
 * is far larger than it must be.
 */

export const U = 2 ** -53;
export type Named = Readonly<Record<string, number>>;
export type Values = (constant: (array: string, key: string) => number, elements: Named) => Named;

export type Analysis = (...given: Parameters<Values>) => Map<string, Off>;

export interface Stage {
  readonly bounds: Float64Array;
  readonly axis: Values;
  readonly space: Values;
  /** The loop's rounding errors, operation by operation. */
  readonly axisErrors: Analysis;
  readonly spaceErrors: Analysis;
}

/** A root's distance from the point that both are seen from: what is added to t last. */
export const AROUND = { around: 'root * overSize - b * overA' };

export const recentred: Stage = {
  bounds: RECENTRED,
  axis: namedValues(stageSource('recentred'), 'recentredAroundAxis', false),
  space: namedValues(stageSource('recentred'), 'recentredInSpace', true),
  axisErrors: runningError(stageSource('recentred'), 'recentredAroundAxis', false, AROUND),
  spaceErrors: runningError(stageSource('recentred'), 'recentredInSpace', true, AROUND),
};
/** As `recentred`, with A, b and D taken as they are. */
export const closedForm: Stage = {
  ...recentred,
  axisErrors: runningError(stageSource('recentred'), 'recentredAroundAxis', false, AROUND, [
    'A',
    'b',
    'D',
  ]),
  spaceErrors: runningError(stageSource('recentred'), 'recentredInSpace', true, AROUND, [
    'A',
    'b',
    'D',
  ]),
};
export const rootByRoot: Stage = {
  bounds: REFINED,
  axis: namedValues(stageSource('refined'), 'refine', false),
  space: namedValues(stageSource('refined'), 'refine', true),
  axisErrors: runningError(stageSource('refined'), 'refine', false),
  spaceErrors: runningError(stageSource('refined'), 'refine', true),
};

export interface Asked {
  readonly q: Quadric;
  readonly ray: Ray;
  /** The loop's values, with the bounds as they are or one of them weakened. */
  readonly named: Named;
  readonly errors: () => Map<string, Off>;
}

export function asked(stage: Stage, kind: Kind, x: Numbers): Asked | null {
  if (!x.every(Number.isFinite)) return null;
  const { shape, ray } = questionOf(kind, x);
  const q = quadricOf(shape) as Quadric;
  const { numbers } = certifiedQuadric(q);
  const constant = (array: string, key: string): number =>
    array.endsWith('_BOUNDS')
      ? (stage.bounds[Number(key)] as number)
      : (numbers[AT_SCALED[key as keyof typeof AT_SCALED]] as number);
  const [Ex, Ey, Ez] = ray.origin;
  const [dx, dyi, dz] = ray.direction;
  const elements = { Ex, Ey, Ez, dx, dy: dyi, dz };
  const named = (q.hasY ? stage.space : stage.axis)(constant, elements);
  const analyse = q.hasY ? stage.spaceErrors : stage.axisErrors;
  return { q, ray, named, errors: () => analyse(constant, elements) };
}

/** |sum of `parts` − truth|. */
export const offFrom = (truth: surd.Surd, ...parts: number[]): number =>
  Math.abs(surd.toNumber(parts.reduce((rest, x) => surd.sub(rest, surd.fromNumber(x)), truth)));

/** The share of their bounds that the errors have; 0 where nothing is claimed. */
export type Share = (a: Asked) => number;

/** Where a bound is in its list. */
export const [CROSS_ERROR, RESIDUAL, SLOPE_ERROR, CLOSED_A, CLOSED, NARROW] = [4, 6, 7, 8, 9, 14];
export const [RESIDUAL_ERROR, STEP_ERROR, SPREAD, STEP] = [4, 5, 7, 8];

export const shareOfD: Share = ({ q, ray, named }) =>
  named.inside && Number.isFinite(named.D)
    ? offFrom(surd.fromDyadic(quarter(q, ray)), named.D as number) / (named.error as number)
    : 0;

export const shareOfRecentredRoots: Share = ({ q, ray, named }) => {
  if (!named.clear) return 0;
  const { t, b, overA, root, overSize, off } = named as Record<string, number> & Named;
  const middle = -(b as number) * (overA as number);
  const side = (root as number) * (overSize as number);
  const [near, far] = solved(q, ray).roots as [surd.Surd, surd.Surd];
  const most = Math.max(
    offFrom(near, t as number, middle - side),
    offFrom(far, t as number, side + middle),
  );
  return most / (off as number);
};

export function exactResidual(q: Quadric, { origin, direction }: Ray, t: number): dy.Dyadic {
  const n = dy.fromNumber;
  const C = [q.Cx, q.Cy, q.Cz];
  const point = origin.map((e, k) =>
    dy.add(dy.sub(n(e), n(C[k] as number)), dy.mul(n(t), n(direction[k] as number))),
  );
  return dy.sub(form(q.hasY ? flareOf(q) : dy.ZERO, point, point), dy.sqr(n(q.r)));
}

/** Whether root by root is settled, but for the size of its error. */
export const withinLimits = ({ named }: Asked): boolean => {
  const { clear, reachA, reachB, Sp, f, g, A, D } = named as Record<string, number>;
  return (
    Boolean(clear) &&
    (reachA as number) + (reachB as number) <= bound(rootByRoot, SPREAD) * (Sp as number) &&
    ((f as number) + (g as number)) * Math.abs(A as number) <=
      bound(rootByRoot, STEP) * (D as number)
  );
};

/**
 * How far Newton's step is from the root, but for the rounding of f, as a share of what is charged
 * for it.
 */
export const shareOfSteps: Share = (a) => {
  if (!withinLimits(a)) return 0;
  const { ta, tb, fa, fb, half } = a.named as Record<string, number>;
  const [low, high] = solved(a.q, a.ray).roots as [surd.Surd, surd.Surd];
  const ascending = (ta as number) < (tb as number);
  const shareAt = (t: number, f: number, sign: number, root: surd.Surd): number => {
    const step = dy.mul(dy.fromNumber(sign * (half as number)), exactResidual(a.q, a.ray, t));
    const charged = Math.abs(half as number) * (REFINED[STEP_ERROR] as number) * Math.abs(f);
    return offFrom(surd.sub(root, surd.fromDyadic(step)), t) / charged;
  };
  return Math.max(
    shareAt(ta as number, fa as number, 1, ascending ? low : high),
    shareAt(tb as number, fb as number, -1, ascending ? high : low),
  );
};

export const possible = (a: Asked, name: string): number => (a.errors().get(name) as Off).off;
export const value = ({ named }: Asked, name: string): number => named[name] as number;

/*
 * What the roundings may come to at worst on a ray, as a share of what is charged for them. `by` is
 * what the constant is multiplied by.
 */
export type Charge = (a: Asked, by: number) => number;

export const bound = (stage: Stage, at: number): number => stage.bounds[at] as number;
export const ofB: Charge = (a, by) =>
  possible(a, 'b') /
  (by * bound(recentred, SLOPE_ERROR) * value(a, 'width') * value(a, 'speed') +
    U * Math.abs(value(a, 'b')));
/** What f's own last roundings lose, 2u|f|, is charged beside. */
export const ofF: Charge = (a, by) => {
  const width = value(a, 'width');
  const size = value(a, 'size') + bound(recentred, NARROW) * width;
  const rest = possible(a, 'f') - 2 * U * Math.abs(value(a, 'f'));
  return rest / (by * bound(recentred, CROSS_ERROR) * width * size);
};
export const ofA: Charge = (a, by) =>
  possible(a, 'A') / (by * bound(recentred, CLOSED_A) * value(a, 'square'));
export const ofD: Charge = (a, by) => {
  const weak = (by - 1) * value(a, 'square') * bound(recentred, RESIDUAL) * Math.abs(value(a, 'f'));
  return a.named.inside ? possible(a, 'D') / (value(a, 'error') + weak) : 0;
};
/** The closed form from A, b and D as they are. */
export const ofClosed: Charge = (a, by) =>
  a.named.clear
    ? possible(a, 'around') /
      (by *
        bound(recentred, CLOSED) *
        (value(a, 'sizeB') + value(a, 'root')) *
        value(a, 'overSize'))
    : 0;
export const ofResidual: Charge = (a, by) => {
  if (!withinLimits(a)) return 0;
  const size = value(a, 'sizeOfA');
  const width = size + value(a, 'reachA');
  const charged =
    by * bound(rootByRoot, RESIDUAL_ERROR) * width * (size + bound(rootByRoot, 17) * width);
  return possible(a, 'fa') / (charged + 2 * U * Math.abs(value(a, 'fa')));
};

export type Start = (kind: Kind, random: Random) => number[];
export const START: readonly [Start, ...Start[]] = [
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
  const { ta = 0 } = (asked(rootByRoot, kind, x) as Asked).named;
  const t = Number.isFinite(ta) ? ta * (1 - log(r, -14, -3)) : 0;
  return x.map((v, i) => (i > 4 && i < 8 ? v + t * (x[i + 3] as number) : v));
};

/** √D. */
export const shareOfRoot: Share = ({ q, ray, named }) => {
  if (!named.clear) return 0;
  const root = surd.surd(dy.ZERO, dy.ONE, dy.ONE, quarter(q, ray));
  return offFrom(root, named.s as number) / ((named.s as number) * 2 ** -18);
};

export function worst(stage: Stage, kind: Kind, start: Start, share: Share, seed: number): number {
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

import { describe, expect, test } from 'vitest';
import { type Quadric, quadricOf } from '../../../src/math/batch/quadric.ts';
import * as dy from '../../../src/math/exact/dyadic.ts';
import * as surd from '../../../src/math/exact/surd.ts';
import { BOUNDS as RECENTRED } from '../../../src/math/methods/certified/recentred.ts';
import recentredAxis from '../../../src/math/methods/certified/recentred-axis.ts?raw';
import recentredSpace from '../../../src/math/methods/certified/recentred-space.ts?raw';
import { BOUNDS as REFINED } from '../../../src/math/methods/certified/refined.ts';
import refined from '../../../src/math/methods/certified/refined.ts?raw';
import { AT_SCALED, certifiedQuadric } from '../../../src/math/methods/certified/scaled-quadric.ts';
import type { Ray } from '../../../src/math/ray.ts';
import { pick, type Random, seeded, uniform } from '../../../src/math/rng.ts';
import { climb } from './climb.ts';
import { flareOf, form, solved } from './exact-quadratic.ts';
import {
  about,
  grazing,
  KINDS,
  type Kind,
  log,
  type Numbers,
  quarter,
  questionOf,
} from './in-a-row.ts';
import { namedValues } from './named-values.ts';
import { type Known, runningError } from './running-error.ts';

/*
 * The stages after the ordinary rays', at their own values before the last rounding. A search looks for rays on which an error is the largest share of its bound: it
 * never is more than the bound, and where one of the bound's constants is weakened, it is. So each constant is needed, and none is far larger than it must be.
 */

const U = 2 ** -53;
type Named = Readonly<Record<string, number>>;
type Values = (constant: (array: string, key: string) => number, elements: Named) => Named;

type Analysis = (...given: Parameters<Values>) => Map<string, Known>;

interface Stage {
  readonly bounds: Float64Array;
  readonly axis: Values;
  readonly space: Values;
  /** The loop's rounding errors, operation by operation. */
  readonly axisErrors: Analysis;
  readonly spaceErrors: Analysis;
}

/** A root's distance from the point that both are seen from: what is added to t last. */
const AROUND = { around: 'root * overSize - b * overA' };

const recentred: Stage = {
  bounds: RECENTRED,
  axis: namedValues(recentredAxis, 'recentredAroundAxis', false),
  space: namedValues(recentredSpace, 'recentredInSpace', true),
  axisErrors: runningError(recentredAxis, 'recentredAroundAxis', false, AROUND),
  spaceErrors: runningError(recentredSpace, 'recentredInSpace', true, AROUND),
};
/** As `recentred`, with A, b and D taken as they are. */
const closedForm: Stage = {
  ...recentred,
  axisErrors: runningError(recentredAxis, 'recentredAroundAxis', false, AROUND, ['A', 'b', 'D']),
  spaceErrors: runningError(recentredSpace, 'recentredInSpace', true, AROUND, ['A', 'b', 'D']),
};
const rootByRoot: Stage = {
  bounds: REFINED,
  axis: namedValues(refined, 'refine', false),
  space: namedValues(refined, 'refine', true),
  axisErrors: runningError(refined, 'refine', false),
  spaceErrors: runningError(refined, 'refine', true),
};

interface Asked {
  readonly q: Quadric;
  readonly ray: Ray;
  /** The loop's values, with the bounds as they are or one of them weakened. */
  readonly named: Named;
  readonly errors: () => Map<string, Known>;
}

function asked(stage: Stage, kind: Kind, x: Numbers): Asked | null {
  if (!x.every(Number.isFinite)) return null;
  const { shape, ray } = questionOf(kind, x);
  const q = quadricOf(shape) as Quadric;
  const { numbers } = certifiedQuadric(q);
  const constant = (array: string, key: string): number =>
    array === 'BOUNDS'
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
const offFrom = (truth: surd.Surd, ...parts: number[]): number =>
  Math.abs(surd.toNumber(parts.reduce((rest, x) => surd.sub(rest, surd.fromNumber(x)), truth)));

/** The share of their bounds that the errors have; 0 where nothing is claimed. */
type Share = (a: Asked) => number;

/** Where a bound is in its list. */
const [CROSS_ERROR, RESIDUAL, SLOPE_ERROR, CLOSED_A, CLOSED] = [4, 6, 7, 8, 9];
const [RESIDUAL_ERROR, STEP_ERROR, SPREAD, STEP] = [4, 5, 7, 8];

const shareOfD: Share = ({ q, ray, named }) =>
  named.inside && Number.isFinite(named.D)
    ? offFrom(surd.fromDyadic(quarter(q, ray)), named.D as number) / (named.error as number)
    : 0;

const shareOfRecentredRoots: Share = ({ q, ray, named }) => {
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

function exactResidual(q: Quadric, { origin, direction }: Ray, t: number): dy.Dyadic {
  const n = dy.fromNumber;
  const C = [q.Cx, q.Cy, q.Cz];
  const point = origin.map((e, k) =>
    dy.add(dy.sub(n(e), n(C[k] as number)), dy.mul(n(t), n(direction[k] as number))),
  );
  return dy.sub(form(q.hasY ? flareOf(q) : dy.ZERO, point, point), dy.sqr(n(q.r)));
}

/** Whether root by root is settled, but for the size of its error. */
const withinLimits = ({ named }: Asked): boolean => {
  const { clear, reachA, reachB, Sp, f, g, A, D } = named as Record<string, number>;
  return (
    Boolean(clear) &&
    (reachA as number) + (reachB as number) <= bound(rootByRoot, SPREAD) * (Sp as number) &&
    ((f as number) + (g as number)) * Math.abs(A as number) <=
      bound(rootByRoot, STEP) * (D as number)
  );
};

/** How far Newton's step is from the root, but for the rounding of f, as a share of what is charged for it. */
const shareOfSteps: Share = (a) => {
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

const possible = (a: Asked, name: string): number => (a.errors().get(name) as Known).off;
const value = ({ named }: Asked, name: string): number => named[name] as number;

/*
 * What the roundings may come to at worst on a ray, as a share of what is charged for them. `by` is what the constant is multiplied by.
 */
type Charge = (a: Asked, by: number) => number;

const bound = (stage: Stage, at: number): number => stage.bounds[at] as number;
const ofB: Charge = (a, by) =>
  possible(a, 'b') /
  (by * bound(recentred, SLOPE_ERROR) * value(a, 'width') * value(a, 'speed') +
    U * Math.abs(value(a, 'b')));
const ofF: Charge = (a, by) =>
  possible(a, 'f') /
  (by * bound(recentred, CROSS_ERROR) * value(a, 'width') * value(a, 'size') +
    2 * U * Math.abs(value(a, 'f')));
const ofA: Charge = (a, by) =>
  possible(a, 'A') / (by * bound(recentred, CLOSED_A) * value(a, 'square'));
const ofD: Charge = (a, by) => {
  const weak = (by - 1) * value(a, 'square') * bound(recentred, RESIDUAL) * Math.abs(value(a, 'f'));
  return a.named.inside ? possible(a, 'D') / (value(a, 'error') + weak) : 0;
};
/** The closed form from A, b and D as they are. */
const ofClosed: Charge = (a, by) =>
  a.named.clear
    ? possible(a, 'around') /
      (by *
        bound(recentred, CLOSED) *
        (value(a, 'sizeB') + value(a, 'root')) *
        value(a, 'overSize'))
    : 0;
const ofResidual: Charge = (a, by) => {
  if (!withinLimits(a)) return 0;
  const size = value(a, 'sizeOfA');
  const charged = by * bound(rootByRoot, RESIDUAL_ERROR) * size * (size + value(a, 'reachA'));
  return possible(a, 'fa') / (charged + 2 * U * Math.abs(value(a, 'fa')));
};

type Start = (kind: Kind, random: Random) => number[];
const START: readonly [Start, ...Start[]] = [
  (_, r) => about(r),
  (kind, r) => grazing(kind, r, log(r, -30, -1), log(r, -3, 4)),
  (kind, r) => grazing(kind, r, log(r, -12, -1), log(r, 4, 24)),
  (kind, r) => grazing(kind, r, log(r, -40, -1), log(r, 4, 40)),
];
const any: Start = (kind, r) => pick(r, START)(kind, r);
const far: Start = (kind, r) => grazing(kind, r, log(r, -30, -1), log(r, 30, 44));
const farther: Start = (kind, r) => grazing(kind, r, log(r, -14, -1), log(r, 10, 28));
/** A is a small part of its terms. */
const steep = (kind: Kind, r: Random, bits = uniform(r, 3, 24)): number[] => {
  const x = about(r);
  const phi = uniform(r, 0, 6.3);
  const k = kind === 'cone' ? Math.abs(x[3] as number) : Math.sqrt(Math.abs(x[3] as number));
  const slope = k * (1 + 2 ** -bits);
  return [...x.slice(0, 8), slope * Math.cos(phi), 1, slope * Math.sin(phi)];
};

/** A all but cancels, and t is where nothing is. */
const asymptotic: Start = (kind, r) => steep(kind, r, uniform(r, 16, 58));

function worst(stage: Stage, kind: Kind, start: Start, share: Share, seed: number): number {
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

const CHARGES: readonly [string, Stage, Start, Charge][] = [
  ['b', recentred, far, ofB],
  ['f', recentred, far, ofF],
  ['A', recentred, any, ofA],
  ['A f in D', recentred, any, ofD],
  ['the closed form', closedForm, any, ofClosed],
  ['f of root by root', rootByRoot, any, ofResidual],
];

describe.each(KINDS)('%s (seed 211)', (kind) => {
  test.each(CHARGES)(
    '%s: what is charged covers all roundings, and a 64th of it would not',
    (_, stage, start, charge) => {
      const whole = worst(stage, kind, start, (a) => charge(a, 1), 211);
      expect(whole).toBeLessThan(1);
      expect(worst(stage, kind, start, (a) => charge(a, 1 / 64), 211)).toBeGreaterThan(1);
    },
  );

  test('D near an asymptote, where t is of no use', () => {
    expect(worst(recentred, kind, asymptotic, shareOfD, 219)).toBeLessThan(1);
  });

  test('D and the roots are known as well as their bounds say', () => {
    const found = [
      worst(recentred, kind, any, shareOfD, 212),
      worst(rootByRoot, kind, any, shareOfD, 213),
      worst(recentred, kind, any, shareOfRecentredRoots, 214),
    ];
    for (const share of found) {
      expect(share).toBeLessThan(1);
      expect(share).toBeGreaterThan(1 / 12);
    }
  });

  test('A of a clear hit is known to 2^-30', () => {
    for (const stage of [recentred, rootByRoot]) {
      const share = worst(
        stage,
        kind,
        steep,
        (a) => (a.named.clear ? possible(a, 'A') / Math.abs(value(a, 'A')) / 2 ** -30 : 0),
        216,
      );
      expect(share).toBeLessThan(1);
      expect(share).toBeGreaterThan(kind === 'cylinder' ? 2 ** -24 : 1 / 16);
    }
  });

  test('what is settled was off by less than half of the distance to the next double', () => {
    const settled = (a: Asked): number =>
      a.named.settled && a.named.clear
        ? possible(a, 'around') /
          (2 ** -54 * Math.min(Math.abs(value(a, 'near')), Math.abs(value(a, 'far'))))
        : 0;
    const share = worst(recentred, kind, any, settled, 217);
    expect(share).toBeLessThan(1);
    expect(share).toBeGreaterThan(1 / 4);
  });
});

test('a cone asked from hardly beside its vertex: what underflows decides nothing (seed 218)', () => {
  const random = seeded(218);
  const wrong: unknown[] = [];
  for (let k = 0; k < 3000; k++) {
    const tiny = 2 ** uniform(random, -545, -480);
    const x = about(random).map((v, i) => (i < 3 ? 0 : i > 4 && i < 8 ? v * tiny : v));
    for (const stage of [recentred, rootByRoot]) {
      const a = asked(stage, 'cone', x) as Asked;
      const sign = dy.sign(quarter(a.q, a.ray));
      if ((a.named.clear && sign < 0) || (a.named.missed && sign >= 0)) wrong.push(x);
    }
  }
  expect(wrong).toEqual([]);
});

test("Newton's step is the root's but for what is charged (seed 215)", () => {
  const shares = KINDS.map((kind) => worst(rootByRoot, kind, farther, shareOfSteps, 215));
  expect(Math.max(...shares)).toBeLessThan(1);
  expect(Math.max(...shares)).toBeGreaterThan(1 / 64);
});

import { closestApproach, levelOf } from '../math/formula.ts';
import {
  type Hit,
  type Intersection,
  intersect,
  type Ray,
  type Shape,
  type Vec3,
} from '../math/index.ts';
import { definitionOf, type Naming, type Sign } from '../math/shapes.ts';
import { display } from '../text/format.ts';
import { type Side, sideKey } from './verdict-table.ts';
import type { NormalFigure } from './walk-normal.ts';

type Words = Readonly<Record<Side, string>>;

/** Words for the sign of B or N·d, which is f′(0). */
const SLOPE: Words = { '-': 'f falls at E', '0': 'f is level at E', '+': 'f rises at E' };

/** f < 0 is inside, and far from E the sign of f is that of A. */
const opening = ({ straight }: Naming): Words => ({
  '-': 'far from E, both ways, the line is inside',
  '0': `the ray is parallel to ${straight ?? 'the surface'}, and f has no t²`,
  '+': 'far from E, both ways, the line is outside',
});

/** Words for the sign of C, which is f(0). An axis or a point has no inside. */
const place = ({ name }: Naming): Words => ({
  '-': `E is inside the ${name}`,
  '0': `E is on the ${name}`,
  '+': name === 'axis' || name === 'point' ? `E is not on the ${name}` : `E is outside the ${name}`,
});

const OF_PLANE: Words = {
  '-': 'E is on the side that N points away from',
  '0': 'E is in the plane',
  '+': 'E is on the side that N points to',
};

/** Words for the signs of A and D: the vertex of f is at the value −D/4A. */
const TURN: Readonly<Record<'-' | '+', Words>> = {
  '+': {
    '-': 'the lowest value of f is above 0, so there is no root',
    '0': 'the lowest value of f is 0: one double root',
    '+': 'the lowest value of f is below 0, so there are two roots',
  },
  '-': {
    '-': 'the highest value of f is below 0, so there is no root',
    '0': 'the highest value of f is 0: one double root',
    '+': 'the highest value of f is above 0, so there are two roots',
  },
};

/** Words for A = 0 by the sign of B, the slope of the straight line f. */
const LINE: Words = {
  '-': 'the straight line f falls, and is 0 once',
  '0': '',
  '+': 'the straight line f rises, and is 0 once',
};
const LEVEL: Words = {
  '-': 'f is below 0 everywhere, so there is no root',
  '0': 'f is 0 everywhere: the whole line lies in the surface',
  '+': 'f is above 0 everywhere, so there is no root',
};

/** The line of the walk that a sentence belongs to. */
export type SignedLine = 'A' | 'B' | 'C' | 'D' | 'N·d' | 'N·(E − P)';

/**
 * A sentence for the exact sign of each coefficient: "B < 0: f falls at E". Signs are those of the
 * stored numbers, not of the chosen method's rounded ones. If A = 0, D's sentence is on B or C.
 */
export function signWords(shape: Shape, ray: Ray): Readonly<Partial<Record<SignedLine, string>>> {
  const { details } = intersect(shape, ray, 'exact');
  if (details.family === 'flat') {
    const { rate, offset } = details.signs;
    return {
      'N·(E − P)': said('N·(E − P)', offset, OF_PLANE),
      N·d: said('N·d', rate, SLOPE),
    };
  }
  const naming = definitionOf(shape).named(shape);
  const { A, B, C, D } = details.signs;
  return {
    A: said('A', A, opening(naming)),
    B: said('B', B, SLOPE),
    C: said('C', C, place(naming)),
    D: A
      ? said('D', D, TURN[A > 0 ? '+' : '-'])
      : B
        ? said('B', B, LINE)
        : said('A = B = 0, C', C, LEVEL),
  };
}

const RELATION: Words = { '-': '<', '0': '=', '+': '>' };

function said(symbol: string, sign: Sign | null, words: Words): string {
  const key = sideKey(sign ?? 0);
  return `${symbol} ${RELATION[key]} 0: ${words[key]}`;
}

const AGAINST: Words = { '-': 'more than', '0': 'exactly', '+': 'less than' };

/**
 * The line's distance from the axis or centre of a round surface, compared with the radius; null
 * for other surfaces. The comparison is by the exact sign of D, not by the printed digits.
 */
export function closestWords(shape: Shape, ray: Ray): string | null {
  const closest = closestApproach(shape, ray);
  if (!closest) return null;
  const { distance, radius, sign, round } = closest;
  const key = sideKey(sign);
  const what = round.length === 2 ? 'axis' : 'centre';
  return (
    `Where the line is nearest to the ${what} it is ${display(distance)} away from it, ` +
    `${AGAINST[key]} the radius ${display(radius)}: D ${RELATION[key]} 0`
  );
}

const FACING: Words = {
  '-': 'the line meets the front here, N points against d',
  '0': 'the line touches here, N is at a right angle to d',
  '+': 'the line meets the back here, −N points against d',
};

/**
 * The exact sign of N·d at hit `i` (from 0) of a curved shape: that of f′ there, by A, B and the
 * order of the roots; of a flat shape that of f′ everywhere. Null if N is zero, or it is not known.
 */
export function facingSign({ class: verdict, details, hits }: Intersection, i: number) {
  if (!hits[i] || hits[i].singular) return null;
  if (details.family === 'flat') return details.signs.rate;
  const { A, B } = details.signs;
  const signs = { two: i === 0 ? -(A ?? 0) : A, tangent: 0, one: B } as const;
  const sign = verdict in signs ? signs[verdict as keyof typeof signs] : null;
  return sign === null ? null : (Math.sign(sign) as Sign);
}

/**
 * Which side of a curved surface the line meets at hit `i` (from 0), with the value of N·d in
 * doubles where that has the exact sign.
 */
export function facingWords(found: Intersection, i: number, d: Vec3): string | null {
  const sign = found.details.family === 'flat' ? null : facingSign(found, i);
  const normal = found.hits[i]?.normal;
  if (sign === null || !normal) return null;
  const product = normal[0] * d[0] + normal[1] * d[1] + normal[2] * d[2];
  const isIts = sign !== 0 && Math.sign(product) === sign && Number.isFinite(product);
  return said(isIts ? `N·d = ${display(product)}` : 'N·d', sign, FACING);
}

const AXIS_NAMES = ['x', 'y', 'z'] as const;

/**
 * What the figure of the step about N shows: from the hit to the level F = k along each axis; where
 * N is zero, how F grows there.
 */
export function nudgeWords(shape: Shape, { point, singular }: Hit, figure: NormalFigure): string {
  const k = display(figure.k);
  if (singular) {
    const { along } = levelOf(shape);
    const parts = AXIS_NAMES.map((axis, i) => {
      const { A } = along(point, [i === 0 ? 1 : 0, i === 1 ? 1 : 0, i === 2 ? 1 : 0]);
      return `${squareTimes(A)} along ${axis}`;
    });
    return `Nudged by h from there F is ${parts.join(', ')}: no term in h, so N is zero`;
  }
  const steps = figure.nudges.flatMap((s, i) =>
    s === null ? [] : [`${display(s, 3)} along ${AXIS_NAMES[i]}`],
  );
  const none = AXIS_NAMES.filter((_, i) => figure.nudges[i] === null);
  const never = none.length > 0 ? `; along ${none.join(' and ')} not at all` : '';
  return `Drawn: F = ±${k}. Nudged from there F is ${k} after ${steps.join(', ')}${never}`;
}

/** "h²", "−0.25h²", "0". */
function squareTimes(A: number): string {
  if (A === 0) return '0';
  return Math.abs(A) === 1 ? `${A < 0 ? '−' : ''}h²` : `${display(A)}h²`;
}

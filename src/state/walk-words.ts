import { closestApproach } from '../math/formula.ts';
import { type Intersection, intersect, type Ray, type Shape } from '../math/index.ts';
import { definitionOf, type Naming, type Sign } from '../math/shapes.ts';
import { display } from '../text/format.ts';
import { type Side, sideKey } from './verdict-table.ts';

type Words = Readonly<Record<Side, string>>;

/** What the sign of B, or of N·d, says: f′(0) is that number. */
const SLOPE: Words = { '-': 'f falls at E', '0': 'f is level at E', '+': 'f rises at E' };

/** f < 0 is inside, and far from E the sign of f is that of A. */
const opening = ({ straight }: Naming): Words => ({
  '-': 'far from E, both ways, the line is inside',
  '0': `the ray is parallel to ${straight ?? 'the surface'}, and f has no t²`,
  '+': 'far from E, both ways, the line is outside',
});

/** An axis or a point has nothing inside. */
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

/** f turns once, at −D/4A: that of D against A says on which side of 0. */
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

/** A = 0: the slope of a straight line, and of a level one its height. */
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

/** Of which line of the walk a sentence is. */
export type Said = 'A' | 'B' | 'C' | 'D' | 'N·d' | 'N·(E − P)';

/**
 * What the exact signs of the coefficients say of this ray, a sentence for each: "B < 0: f falls at
 * E". They are those of the stored numbers, whatever the chosen method rounds them to. D's is on B
 * or C where A = 0.
 */
export function signWords(shape: Shape, ray: Ray): Readonly<Partial<Record<Said, string>>> {
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
 * How near the line comes to the axis or the centre of a round surface, against its radius; null
 * for other surfaces. By the exact sign of D, whatever the six digits of both are.
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
 * Which side of a curved surface the line meets at a hit, from 0: N·d has the sign of f′ there, and
 * that is known exactly from A, B and the order of the roots. Null where N is zero, or of a flat
 * shape.
 */
export function facingWords({ class: verdict, details, hits }: Intersection, i: number) {
  if (details.family === 'flat' || !hits[i] || hits[i].singular) return null;
  const { A, B } = details.signs;
  const signs = { two: i === 0 ? -(A ?? 0) : A, tangent: 0, one: B } as const;
  const sign = verdict in signs ? signs[verdict as keyof typeof signs] : null;
  return sign === null ? null : said('N·d', Math.sign(sign) as Sign, FACING);
}

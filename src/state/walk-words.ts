import { intersect, type Ray, type Shape } from '../math/index.ts';
import { definitionOf, type Naming, type Sign } from '../math/shapes.ts';
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

/**
 * What the exact signs of the coefficients say of this ray, a sentence for each: "B < 0: f falls at
 * E". They are those of the stored numbers, whatever the chosen method rounds them to.
 */
export function signWords(shape: Shape, ray: Ray): readonly string[] {
  const { details } = intersect(shape, ray, 'exact');
  if (details.family === 'flat') {
    const { rate, offset } = details.signs;
    return [...said('N·d', rate, SLOPE), ...said('N·(E − P)', offset, OF_PLANE)];
  }
  const naming = definitionOf(shape).named(shape);
  const { A, B, C } = details.signs;
  return [...said('A', A, opening(naming)), ...said('B', B, SLOPE), ...said('C', C, place(naming))];
}

const RELATION: Words = { '-': '<', '0': '=', '+': '>' };

function said(symbol: string, sign: Sign | null, words: Words): string[] {
  if (sign === null) return [];
  const key = sideKey(sign);
  return [`${symbol} ${RELATION[key]} 0: ${words[key]}`];
}

import { describe, expect, test } from 'vitest';
import type { Ray } from '../../../src/math/ray.ts';
import { integer, type Random, seeded } from '../../../src/math/rng.ts';
import type { Shape } from '../../../src/math/shapes/index.ts';
import { sideOf } from '../../../src/math/shapes.ts';
import { signWords } from '../../../src/state/walk-words.ts';
import { paraboloid, sphere } from '../math/shorthand.ts';
import { at, DRAWS, dot, drawRay, f, flatOf, less, quadricOf } from './ray-oracle.ts';

/* Every sentence on a sign, on rays of small numbers, against facts found without src/math. */

const FAR = 2 ** 20;
const ROUNDS = 1500;

/** f along the line, from the surface's equation or the distance from the plane. */
function alongOf(shape: Shape, ray: Ray): (t: number) => number {
  const quadric = quadricOf(shape);
  if (quadric) return (t) => f(quadric, at(ray, t));
  const flat = flatOf(shape);
  if (!flat) throw new Error(`no facts of a ${shape.kind}`);
  return (t) => dot(flat.N, less(at(ray, t), flat.P));
}

/** The ray's direction runs along the surface of revolution's axis, or its cone of asymptotes. */
function isParallel(shape: Shape, { direction: [x, y, z] }: Ray, to: string): boolean {
  if (to === 'the axis') return x === 0 && z === 0;
  const a = quadricOf(shape)?.a ?? -1;
  return to === 'a generator' && a > 0 && x * x + z * z === a * y * y;
}

type Fact = (
  value: (t: number) => number,
  shape: Shape,
  ray: Ray,
  match: RegExpMatchArray,
) => boolean;

/** Twice f′(0): the symmetric difference is exact for a polynomial of degree 2. */
const slope = (value: (t: number) => number): number => value(1) - value(-1);
const isOnly = (shape: Shape): boolean => {
  const { a = 0, k = 0, rho = 0 } = quadricOf(shape) ?? {};
  return rho === 0 && k === 0 && a <= 0;
};

const FACTS: readonly (readonly [RegExp, Fact])[] = [
  [/^A < 0: far from E, both ways, the line is inside$/, (v) => v(FAR) < 0 && v(-FAR) < 0],
  [/^A > 0: far from E, both ways, the line is outside$/, (v) => v(FAR) > 0 && v(-FAR) > 0],
  [
    /^A = 0: the ray is parallel to (.+), and f has no t²$/,
    (v, shape, ray, [, to = '']) => isParallel(shape, ray, to) && v(1) + v(-1) === 2 * v(0),
  ],
  [/^(B|N·d) < 0: f falls at E$/, (v) => slope(v) < 0],
  [/^(B|N·d) = 0: f is level at E$/, (v) => slope(v) === 0],
  [/^(B|N·d) > 0: f rises at E$/, (v) => slope(v) > 0],
  [/^C < 0: E is inside the /, (v, s, { origin }) => v(0) < 0 && sideOf(s, origin) === -1],
  [/^C = 0: E is on the /, (v, s, { origin }) => v(0) === 0 && sideOf(s, origin) === 0],
  [
    /^C > 0: E is outside the /,
    (v, s, { origin }) => v(0) > 0 && !isOnly(s) && sideOf(s, origin) === 1,
  ],
  [/^C > 0: E is not on the (axis|point)$/, (v, s) => v(0) > 0 && isOnly(s)],
  [/^N·\(E − P\) < 0: E is on the side that N points away from$/, (v) => v(0) < 0],
  [/^N·\(E − P\) = 0: E is in the plane$/, (v) => v(0) === 0],
  [/^N·\(E − P\) > 0: E is on the side that N points to$/, (v) => v(0) > 0],
];

const triple = (random: Random) =>
  [integer(random, -2, 2), integer(random, -2, 2), integer(random, -2, 2)] as const;
const ALL: Readonly<Record<string, (random: Random) => Shape>> = {
  sphere: (random) => sphere([...triple(random)], integer(random, 0, 3)),
  paraboloid: (random) => paraboloid([...triple(random)], integer(random, -2, 2)),
  ...DRAWS,
};
const seen = new Set<number>();

describe.each(Object.entries(ALL))('%s', (_, draw) => {
  test('each sentence has one fact, and it holds', () => {
    const random = seeded(15);
    for (let round = 0; round < ROUNDS; round++) {
      const shape = draw(random);
      const ray = drawRay(random, shape);
      const value = alongOf(shape, ray);
      const words = signWords(shape, ray);
      expect(words).toHaveLength(quadricOf(shape) ? 3 : 2);
      for (const text of words) {
        const which = FACTS.findIndex(([pattern]) => pattern.test(text));
        const [pattern, holds] = FACTS[which] ?? [];
        const match = pattern && text.match(pattern);
        const about = `${text} ${JSON.stringify({ shape, ray })}`;
        expect(match && holds?.(value, shape, ray, match), about).toBe(true);
        seen.add(which);
      }
    }
  });
});

test('every sentence was said', () => {
  expect(seen.size).toBe(FACTS.length);
});

import { describe, expect, test } from 'vitest';
import { intersect } from '../../../src/math/index.ts';
import type { Ray } from '../../../src/math/ray.ts';
import { seeded } from '../../../src/math/rng.ts';
import type { Shape } from '../../../src/math/shapes/index.ts';
import { sideOf } from '../../../src/math/shapes.ts';
import type { Vec3 } from '../../../src/math/vec3.ts';
import * as table from '../../../src/state/verdict-table.ts';
import { verdictWords } from '../../../src/state/verdict-words.ts';
import { closestWords, facingWords, signWords } from '../../../src/state/walk-words.ts';
import { display } from '../../../src/text/format.ts';
import { many } from '../many.ts';
import { at, courseOf, DRAWS, dot, drawRay, f, flatOf, less, quadricOf } from './ray-oracle.ts';

/* Every sentence on a sign, on rays of small numbers, against facts found without src/math. */

const FAR = 2 ** 20;
const ROUNDS = many(2400);

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
const isLevel = (v: (t: number) => number): boolean => v(-1) === v(0) && v(1) === v(0);

/** A, and f where it turns, times a power of A, so that nothing is divided: 4A f(−B/2A) = −D. */
function turnOf(v: (t: number) => number): { A: number; height: number } {
  const A = (v(1) + v(-1)) / 2 - v(0);
  const B = (v(1) - v(-1)) / 2;
  return { A, height: (4 * A * v(0) - B * B) * Math.sign(A) };
}

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
  [
    /^D (.) 0: the (lowest|highest) value of f is (below|above) 0, so there (are two|is no) r/,
    (v, _, __, [, sign, which, side, count]) => {
      const { A, height } = turnOf(v);
      const far = Math.sign(v(FAR));
      return (
        (which === 'lowest' ? A > 0 : A < 0) &&
        (side === 'below' ? height < 0 : height > 0) &&
        (sign === '>' ? count === 'are two' : sign === '<' && count === 'is no') &&
        (count === 'are two') === (Math.sign(height) !== far)
      );
    },
  ],
  [
    /^D = 0: the (lowest|highest) value of f is 0: one double root$/,
    (v, _, __, [, which]) => {
      const { A, height } = turnOf(v);
      return (which === 'lowest' ? A > 0 : A < 0) && height === 0;
    },
  ],
  [
    /^B (<|>) 0: the straight line f (falls|rises), and is 0 once$/,
    (v, _, __, [, sign, how]) =>
      turnOf(v).A === 0 &&
      Math.sign(v(FAR)) === -Math.sign(v(-FAR)) &&
      (sign === '<' ? how === 'falls' && slope(v) < 0 : how === 'rises' && slope(v) > 0),
  ],
  [
    /^A = B = 0, C (<|>) 0: f is (below|above) 0 everywhere, so there is no root$/,
    (v, _, __, [, sign, side]) =>
      isLevel(v) && (sign === '<' ? side === 'below' && v(0) < 0 : side === 'above' && v(0) > 0),
  ],
  [
    /^A = B = 0, C = 0: f is 0 everywhere: the whole line lies in the surface$/,
    (v) => isLevel(v) && v(0) === 0,
  ],
  [/^N·\(E − P\) < 0: E is on the side that N points away from$/, (v) => v(0) < 0],
  [/^N·\(E − P\) = 0: E is in the plane$/, (v) => v(0) === 0],
  [/^N·\(E − P\) > 0: E is on the side that N points to$/, (v) => v(0) > 0],
];

const seen = new Set<number>();

describe.each(Object.entries(DRAWS))('%s', (_, draw) => {
  test('each sentence has one fact, and it holds', () => {
    const random = seeded(15);
    for (let round = 0; round < ROUNDS; round++) {
      const shape = draw(random);
      const ray = drawRay(random, shape);
      const value = alongOf(shape, ray);
      const words = Object.values(signWords(shape, ray));
      expect(words).toHaveLength(quadricOf(shape) ? 4 : 2);
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

const AGAINST = /the (axis|centre) it is .* (less than|exactly|more than) .*: D (.) 0$/;

test('how near the line comes against the radius, by D, for what is round alone', () => {
  const random = seeded(16);
  const said = new Set<string>();
  const rounds = new Set<string>();
  for (const draw of Object.values(DRAWS)) {
    for (let round = 0; round < ROUNDS; round++) {
      const shape = draw(random);
      const ray = drawRay(random, shape);
      const words = closestWords(shape, ray);
      const flare = shape.kind === 'hyperboloid' ? shape.flare : null;
      const isCylinder = shape.kind === 'cylinder' || flare === 0;
      const isRound = isCylinder || shape.kind === 'sphere' || flare === -1;
      if (isRound) rounds.add(`${shape.kind} ${flare}`);
      const value = isRound ? alongOf(shape, ray) : null;
      const { A, height } = value ? turnOf(value) : { A: 0, height: 0 };
      expect(words !== null, JSON.stringify({ shape, ray })).toBe(isRound && A !== 0);
      if (words === null) continue;
      const [, to, which, relation] = AGAINST.exec(words) ?? [];
      expect(to).toBe(isCylinder ? 'axis' : 'centre');
      expect(which).toBe(height < 0 ? 'less than' : height > 0 ? 'more than' : 'exactly');
      expect(relation).toBe(height < 0 ? '>' : height > 0 ? '<' : '=');
      said.add(which ?? '');
    }
  }
  expect(said.size).toBe(3);
  expect([...rounds]).toEqual(expect.arrayContaining(['hyperboloid 0', 'hyperboloid -1']));
});

/** N·d, and the size of its terms. */
function dotOf(n: Vec3 = [0, 0, 0], d: Vec3): [number, number] {
  const terms = [n[0] * d[0], n[1] * d[1], n[2] * d[2]] as const;
  const size = terms.reduce((sum, x) => sum + Math.abs(x), 0);
  return [terms[0] + terms[1] + terms[2], size + Number.MIN_VALUE];
}

test('front and back are where f falls and rises through 0; a touch is neither', () => {
  const random = seeded(17);
  const said = new Set<string>();
  for (const draw of Object.values(DRAWS)) {
    for (let round = 0; round < ROUNDS; round++) {
      const shape = draw(random);
      const ray = drawRay(random, shape);
      const quadric = quadricOf(shape);
      const found = intersect(shape, ray, 'exact');
      const words = found.hits.map((_, i) => facingWords(found, i, ray.direction));
      if (!quadric || quadric.k) {
        if (!quadric) expect(words.filter(Boolean)).toEqual([]);
        continue;
      }
      const { behind, ahead, atE } = courseOf(quadric, ray);
      const crossings = [...behind, ...(atE && atE !== 'touches' ? [atE] : []), ...ahead];
      for (const [i, text] of words.entries()) {
        if (text === null) continue;
        const [side] = /front|back|touches/.exec(text) ?? [];
        const [, product, relation] = /^N·d(?: = (\S+(?: · \S+)?))? ([<=>]) 0: /.exec(text) ?? [];
        expect(relation, text).toBe({ front: '<', back: '>', touches: '=' }[side ?? '']);
        const [dot, scale] = dotOf(found.hits[i]?.normal, ray.direction);
        // Left out only where rounding hides its sign.
        if (product === undefined) expect(Math.abs(dot)).toBeLessThanOrEqual(1e-12 * scale);
        else expect(product).toBe(display(dot));
        const how = found.class === 'tangent' ? 'touches' : crossings[i];
        const about = `${text} ${JSON.stringify({ shape, ray })}`;
        expect(
          { enters: 'front', leaves: 'back', touches: 'touches' }[how ?? 'touches'],
          about,
        ).toBe(side);
        said.add(side ?? '');
      }
    }
  }
  expect(said.size).toBe(3);
});

/* Each cell of the verdict table, and the signs of A, B, C, D without which it could not be. */

type Signs = Readonly<Partial<Record<'A' | 'B' | 'C' | 'D', number>>>;
const signOf = (key: string): number => ({ '-': -1, '0': 0, '+': 1 })[key] ?? Number.NaN;

/** With A's sign s, C has s times that of the roots' product, and B −s times that of their sum. */
function ofRoots(opens: string, sides: string): Signs {
  const s = signOf(opens);
  const [first = 0, second = first] = [...sides].map(signOf);
  const sum = first * second < 0 ? {} : { B: -s * Math.sign(first + second) + 0 };
  return { A: s, C: s * first * second + 0, D: sides.length - 1, ...sum };
}

const opening = (rows: object) => Object.entries(rows) as [string, Record<string, string>][];
const CELLS = new Map<string, Signs>([
  ...opening(table.TWO).flatMap(([opens, row]) =>
    Object.entries(row).map(([sides, text]) => [text, ofRoots(opens, sides)] as const),
  ),
  ...[
    ...opening(table.TOUCHES),
    ...Object.entries(table.SINGULAR).flatMap(([opens, row]) =>
      ['the vertex', 'the axis', 'the centre'].map((place) => [opens, row(place)] as const),
    ),
  ].flatMap(([opens, row]) =>
    Object.entries(row).map(([side, text]) => [text, ofRoots(opens, side)] as const),
  ),
  ...opening(table.ONE).flatMap(([rises, row]) =>
    Object.entries(row).map(([side, text]): [string, Signs] => {
      const B = signOf(rises);
      return [text, { A: 0, B, C: -B * signOf(side) + 0 }];
    }),
  ),
  ...Object.entries(table.NONE).map(([opens, text]): [string, Signs] => {
    const A = signOf(opens);
    return [text, { A, C: A, D: -1 }];
  }),
  ...Object.entries(table.CONSTANT).map(([side, text]): [string, Signs] => [
    text,
    { A: 0, B: 0, C: signOf(side) },
  ]),
  ['every t is a root', { A: 0, B: 0, C: 0 }],
]);

/** The sign that a sentence begins with: "B < 0: …" is −1 of B. */
const told = (text: string | undefined, letter: string): number | undefined => {
  const [, relation] = text?.match(`^${letter} (.) 0: `) ?? [];
  return { '<': -1, '=': 0, '>': 1 }[relation ?? ''];
};

test('the sentences on the signs and the cell of the verdict say the same, in every cell', () => {
  const random = seeded(18);
  const texts = [...CELLS.keys()].sort((a, b) => b.length - a.length);
  const reached = new Set<string>();
  for (const [kind, draw] of Object.entries(DRAWS)) {
    for (let round = 0; round < 4 * ROUNDS; round++) {
      const shape = draw(random);
      const ray = drawRay(random, shape);
      if (!quadricOf(shape)) continue;
      const { text } = verdictWords(intersect(shape, ray, 'exact'), shape, ray);
      const cell = texts.find((one) => text.endsWith(one)) ?? '';
      const about = `${text} ${JSON.stringify({ kind, shape, ray })}`;
      const words = signWords(shape, ray);
      for (const [letter, sign] of Object.entries(CELLS.get(cell) ?? { none: 0 })) {
        expect(told(words[letter as 'A'], letter), `${letter}: ${about}`).toBe(sign);
      }
      reached.add(cell);
    }
  }
  const singular = table.SINGULAR['-'];
  const never = ['the axis', 'the centre'].flatMap((place) => Object.values(singular(place)));
  expect(texts.filter((text) => !reached.has(text) && !never.includes(text))).toEqual([]);
});

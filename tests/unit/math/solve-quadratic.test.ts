import { describe, expect, test } from 'vitest';
import type { Dyadic } from '../../../src/math/exact/dyadic.ts';
import * as dy from '../../../src/math/exact/dyadic.ts';
import { scale } from '../../../src/math/float/bits.ts';
import { nextDown, nextUp } from '../../../src/math/float/ulp.ts';
import { InvalidInput, METHODS, solveQuadratic } from '../../../src/math/index.ts';
import type { Method } from '../../../src/math/methods/define.ts';
import { exact } from '../../../src/math/methods/exact.ts';
import { QUADRATIC_SOLVERS } from '../../../src/math/methods/quadratic-solvers.ts';
import { solveDoubles } from '../../../src/math/methods/tree-answer.ts';
import { integer, seeded, uniform, wide } from '../../../src/math/rng.ts';
import { isFloat32, METHOD_IDS } from './shorthand.ts';

type Triple = readonly [A: number, B: number, C: number];

describe('meaning, by every solver', () => {
  const CASES: [string, Triple, string, number[]][] = [
    ['t² − 3t + 2', [1, -3, 2], 'two', [1, 2]],
    ['−t² + 3t − 2: A < 0 turns the roots around', [-1, 3, -2], 'two', [1, 2]],
    ['2t² + 6t + 4', [2, 6, 4], 'two', [-2, -1]],
    ['t² − 4: no B', [1, 0, -4], 'two', [-2, 2]],
    ['t² − 4t: no C', [1, -4, 0], 'two', [0, 4]],
    ['t² + 4t', [1, 4, 0], 'two', [-4, 0]],
    ['t² + 2t + 1', [1, 2, 1], 'tangent', [-1]],
    ['−4t² + 4t − 1', [-4, 4, -1], 'tangent', [0.5]],
    ['t²', [1, 0, 0], 'tangent', [0]],
    ['t² + 1', [1, 0, 1], 'none', []],
    ['−t² + t − 1', [-1, 1, -1], 'none', []],
    ['2t − 3: a line', [0, 2, -3], 'one', [1.5]],
    ['−2t − 3', [0, -2, -3], 'one', [-1.5]],
    ['5t', [0, 5, 0], 'one', [0]],
    ['7', [0, 0, 7], 'none', []],
    ['−7', [0, 0, -7], 'none', []],
    ['0: every t is a root', [0, 0, 0], 'contained', []],
  ];
  describe.each(METHOD_IDS)('%s', (solver) => {
    test.each(CASES)('%s', (_, [A, B, C], verdict, roots) => {
      const answer = solveQuadratic(A, B, C, solver);
      // Only an interval may leave it open whether a D of 0 is one.
      if (solver === 'interval' && answer.class === 'undecided' && verdict !== 'two') return;
      expect({ ...answer, roots: answer.roots.map((t) => t + 0) }).toEqual({
        class: verdict,
        roots,
      });
    });

    test('minus zeros are zeros', () => {
      expect(solveQuadratic(-0, -0, -0, solver).class).toBe('contained');
      expect(solveQuadratic(-0, 2, -3, solver)).toEqual({ class: 'one', roots: [1.5] });
    });

    test('all whole-number roots from −9 to 9, times −3, 1 and 2', () => {
      for (let p = -9; p <= 9; p++) {
        for (let q = p + 1; q <= 9; q++) {
          for (const A of [-3, 1, 2]) {
            const { class: verdict, roots } = solveQuadratic(A, -A * (p + q), A * p * q, solver);
            expect([A, verdict, ...roots.map((t) => t + 0)]).toEqual([A, 'two', p, q]);
          }
        }
      }
    });
  });

  test('the default is the correctly rounded one', () => {
    // Kahan's note of 2004: (At − C)(t − 1) with A and C so close that B² − 4AC vanishes among the
    // doubles.
    const [A, B, C]: Triple = [94906265.625, -189812534, 94906268.375];
    expect(solveQuadratic(A, B, C)).toEqual({ class: 'two', roots: [1, 1.0000000289759583] });
    expect(solveQuadratic(A, B, C, 'exact')).toEqual(solveQuadratic(A, B, C));
    // What the same formula makes of it in doubles: the reason why the default is another.
    expect(solveQuadratic(A, B, C, 'textbook')).toEqual({
      class: 'tangent',
      roots: [1.0000000144879793],
    });
  });
});

describe('one ulp about a double root', () => {
  test.each([
    [[1, -2, nextUp(1)], 'none', 0],
    [[1, -2, 1], 'tangent', 1],
    [[1, -2, nextDown(1)], 'two', 2],
    [[nextUp(1), -2, 1], 'none', 0],
    [[nextDown(1), -2, 1], 'two', 2],
    [[1, nextUp(-2), 1], 'none', 0],
    [[1, nextDown(-2), 1], 'two', 2],
  ] as [Triple, string, number][])('%j', ([A, B, C], verdict, count) => {
    const { class: found, roots } = solveQuadratic(A, B, C);
    expect(found).toBe(verdict);
    expect(roots).toHaveLength(count);
  });

  test('roots of very different size keep all their digits', () => {
    expect(solveQuadratic(1, -(2 ** 53), 1)).toEqual({ class: 'two', roots: [2 ** -53, 2 ** 53] });
  });
});

const SEED = 1618;

describe(`symmetry and exact scaling, 300 triples of seed ${SEED}`, () => {
  const random = seeded(SEED);
  const triples: Triple[] = Array.from({ length: 300 }, (_, i) =>
    i % 2 === 0
      ? [wide(random, -30, 30), wide(random, -30, 30), wide(random, -30, 30)]
      : [integer(random, -4, 4), integer(random, -8, 8), integer(random, -4, 4)],
  );
  const negated = (roots: readonly number[]) => roots.map((t) => 0 - t).toReversed();

  test('−A, −B, −C: the same roots', () => {
    for (const [A, B, C] of triples) {
      expect(solveQuadratic(-A, -B, -C)).toEqual(solveQuadratic(A, B, C));
    }
  });

  test('A, −B, C: the roots negated', () => {
    for (const [A, B, C] of triples) {
      const { class: verdict, roots } = solveQuadratic(A, B, C);
      const mirrored = solveQuadratic(A, -B, C);
      expect({ ...mirrored, roots: mirrored.roots.map((t) => t + 0) }).toEqual({
        class: verdict,
        roots: negated(roots),
      });
    }
  });

  test.each(METHOD_IDS)('%s: t → 2^k t, and the whole equation times 2^j', (solver) => {
    const powers = isFloat32(solver) ? [-5, 5] : [-90, 90];
    for (const [A, B, C] of triples) {
      const { class: verdict, roots } = solveQuadratic(A, B, C, solver);
      for (const k of powers) {
        const scaled = solveQuadratic(scale(A, 2 * k + 6), scale(B, k + 6), scale(C, 6), solver);
        expect({ A, B, C, ...scaled }).toEqual({
          ...{ A, B, C, class: verdict },
          roots: roots.map((t) => scale(t, -k)),
        });
      }
    }
  });
});

describe('overflow and underflow', () => {
  test.each([
    ['A, B, C near the largest double', [1e200, -3e200, 2e200], 'two', [1, 2]],
    ['A, B, C near the smallest', [1e-320, -3e-320, 2e-320], 'two', [1, 2]],
    ['the largest three', [Number.MAX_VALUE, Number.MAX_VALUE, Number.MAX_VALUE], 'none', []],
    ['the smallest three', [5e-324, -1.5e-323, 1e-323], 'two', [1, 2]],
    ['one root beyond the doubles', [1e-300, 1e300, 0], 'two', [-Infinity, 0]],
    ['both beyond, one each way', [1e-300, 0, -1e308], 'two', [-1e304, 1e304]],
    ['a line’s root beyond', [0, 1e-300, -1e300], 'one', [Infinity]],
    ['a line’s root below, from above', [0, 1e300, -1e-300], 'one', [0]],
    ['a line’s root below, from below', [0, 1e300, 1e-300], 'one', [-0]],
    ['half of the smallest double: a tie, to even', [0, 2 ** 100, -(2 ** -975)], 'one', [0]],
    ['just above half of it', [0, 2 ** 100, -(2 ** -975) * (1 + 2 ** -50)], 'one', [5e-324]],
    ['one and a half of it: a tie, to even', [0, 2 ** 100, -1.5 * 2 ** -974], 'one', [1e-323]],
  ] as [string, Triple, string, number[]][])('%s', (_, [A, B, C], verdict, roots) => {
    expect(solveQuadratic(A, B, C)).toEqual({ class: verdict, roots });
  });

  test('the textbook says so, rather than answer with what is left', () => {
    for (const solver of ['textbook', 'stable']) {
      expect(solveQuadratic(1e200, -3e200, 2e200, solver)).toEqual({
        class: 'undecided',
        roots: [],
      });
    }
  });

  test('where everything underflows the textbook cannot know, and takes D for 0', () => {
    expect(solveQuadratic(1e-200, -3e-200, 2e-200, 'textbook')).toEqual({
      class: 'tangent',
      roots: [1.5],
    });
  });
});

describe('not finite', () => {
  test.each([
    [[Number.NaN, 1, 1], 'A must be a finite number, got NaN'],
    [[1, Infinity, 1], 'B must be a finite number, got Infinity'],
    [[1, 1, -Infinity], 'C must be a finite number, got -Infinity'],
    [['1', 1, 1], "A must be a finite number, got '1'"],
    [[1, undefined, 1], 'B is missing'],
    [[1, 1, null], 'C is missing'],
    [[], 'A is missing'],
  ] as [number[], string][])('%j', ([A, B, C], message) => {
    const solve = () => solveQuadratic(A as number, B as number, C as number);
    expect(solve).toThrow(new InvalidInput(message));
  });

  test('an unknown solver', () => {
    const error = new InvalidInput("unknown method 'kahan'");
    expect(() => solveQuadratic(1, 2, 1, 'kahan')).toThrow(error);
  });
});

describe(`correctly rounded: the exact sign of f on both sides of every root, seed ${SEED}`, () => {
  const random = seeded(SEED);
  const f = ([A, B, C]: Triple, t: Dyadic): number => {
    const linear = dy.add(dy.mul(dy.fromNumber(A), t), dy.fromNumber(B));
    return dy.sign(dy.add(dy.mul(linear, t), dy.fromNumber(C)));
  };
  const middle = (a: number, b: number): Dyadic =>
    dy.shift(dy.add(dy.fromNumber(a), dy.fromNumber(b)), -1);

  test.each([
    ['ordinary', () => uniform(random, -10, 10)],
    ['of any size', () => wide(random, -300, 300)],
  ])('%s coefficients, 300 triples', (_, x) => {
    let hits = 0;
    for (let i = 0; i < 300; i++) {
      const triple: Triple = [x(), x(), x()];
      const { class: verdict, roots } = solveQuadratic(...triple);
      for (const t of roots) {
        const below = f(triple, middle(nextDown(t), t));
        const above = f(triple, middle(t, nextUp(t)));
        if (below * above !== -1) expect({ triple, t, below, above }).toBe('a change of sign');
        hits++;
      }
      // f has the sign of A far out on both sides, so two roots or none is a matter of what lies
      // between.
      const least = dy.fromNumber(-triple[1] / (2 * triple[0]));
      const dips = f(triple, least) === -Math.sign(triple[0]);
      if (dips) expect({ triple, verdict }).toEqual({ triple, verdict: 'two' });
    }
    expect(hits).toBeGreaterThan(200);
  });
});

test('the list beside METHODS solves as each of them does, and has no other', () => {
  expect(Object.keys(QUADRATIC_SOLVERS).sort()).toEqual(
    METHODS.map(({ id }) => id as string).sort(),
  );
  const random = seeded(17);
  for (const { id, proven, parts = exact.parts } of METHODS as readonly Method[]) {
    const decidedBy = proven ? 'exact' : 'formula';
    for (let i = 0; i < 100; i++) {
      const [A, B, C] = [wide(random), wide(random), wide(random)] as const;
      const own = parts?.((made) => solveDoubles(A, B, C, { ...made, decidedBy }));
      expect(solveQuadratic(A, B, C, id)).toEqual(own);
    }
  }
});

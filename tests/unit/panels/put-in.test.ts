import * as fc from 'fast-check';
import { describe, expect, test } from 'vitest';
import { pose } from '../../../src/check/compose.ts';
import { courseOf } from '../../../src/check/course.ts';
import { EXERCISES } from '../../../src/check/exercises/index.ts';
import {
  type DerivationLine as CheckLine,
  linesOf as linesOfCheck,
} from '../../../src/check/lines.ts';
import { hintsOf, solutionOf } from '../../../src/check/solution.ts';
import type { Expr } from '../../../src/math/formula/expr.ts';
import { inNumbers } from '../../../src/math/formula/print/leaves.ts';
import type { Marks } from '../../../src/math/formula/print/math-notation.ts';
import { METHODS, SHAPES } from '../../../src/math/index.ts';
import { putIntoLine } from '../../../src/panels/check-lines.ts';
import { createDerive, type ExploreModel } from '../../../src/state/derive.ts';
import { shownResult } from '../../../src/state/exact-digits.ts';
import { exploreDetails } from '../../../src/state/explore-details.ts';
import { fitsInto, spacesOf } from '../../../src/state/number-space.ts';
import { surfaceSteps } from '../../../src/state/picture/surface-steps.ts';
import { conditionDigits, putIn, resultsOf } from '../../../src/state/put-in.ts';
import { type AppState, INITIAL } from '../../../src/state/state.ts';
import { decode } from '../../../src/state/url.ts';
import { rootTexts } from '../../../src/text/distinguish.ts';
import { display } from '../../../src/text/format.ts';
import { anyPicture } from '../state/random-state.ts';
import { isAtMost, readLine, rounds } from './rational.ts';

/*
 * A line that is worked out again with the numbers printed in it gives the printed result, or says
 * ≈.
 */

const PLAIN: Marks<string> = {
  join: (parts) => parts.join(''),
  symbol: (id) => id,
  component: (id, axis) => id + axis,
  componentSquared: (id, axis) => `${id}${axis}^2`,
  indexed: (id, i) => id + i,
  numeral: (figures) => figures,
  operator: (sign) => sign,
  minus: '−',
  parens: (m) => `(${m})`,
  bars: (m) => `|${m}|`,
  fraction: (over, under) => `[${over}]/[${under}]`,
  root: (m) => `√[${m}]`,
  power: (base, exponent) => `${base}^${exponent}`,
  put: (m) => m,
};

interface Line {
  readonly id: string;
  readonly text: string;
  readonly isFaithful: boolean;
  readonly results: readonly { readonly printed: string; readonly branch: 1 | -1 }[];
}

/** The lines with the numbers that the algebra chooses; what cannot be put in is left out. */
function linesOf(model: ExploreModel): Line[] {
  const { derivation, found, exactly } = model;
  return derivation.steps.flatMap((step) => {
    const { id, expr, worked, value } = step;
    const results = resultsOf(step, found, exactly);
    const put = putIn(step, derivation, results, spacesOf(step), (digits, space) =>
      fitsInto(step, derivation.numbers, digits, space),
    );
    if (put === null) return [];
    const text = inNumbers(expr, PLAIN, derivation.numbers, { worked, digits: put.digits });
    const printed = (x: number): string =>
      (value === null ? null : shownResult(id, x, found, exactly).text) ?? display(x);
    return [
      {
        id,
        text,
        isFaithful: put.isFaithful,
        results: results.map(({ value: x, branch }) => ({ printed: printed(x), branch })),
      },
    ];
  });
}

function falseLines(model: ExploreModel): string[] {
  return linesOf(model)
    .filter(({ isFaithful }) => isFaithful)
    .flatMap(({ id, text, results }) =>
      results
        .filter(({ printed, branch }) => !rounds(readLine(text, branch), printed))
        .map(({ printed }) => `${id} = ${text} = ${printed}`),
    );
}

const derived = (state: AppState): ExploreModel => createDerive(() => exploreDetails)(state);
const linked = (query: string): ExploreModel => derived(decode(`#/explore?${query}`));

/** Numbers as people type and drag them, thirds among them, and all methods. */
const ordinary = fc
  .record({
    kind: fc.constantFrom(...SHAPES.map(({ kind }) => kind)),
    method: fc.constantFrom(...METHODS.map(({ id }) => id as string)),
    numbers: fc.array(
      fc.oneof(
        fc.integer({ min: -60, max: 60 }).map((n) => n / 10),
        fc.integer({ min: -20, max: 20 }).map((n) => n / 3),
        fc.double({ min: -5, max: 5, noNaN: true }),
      ),
      { minLength: 14, maxLength: 14 },
    ),
    unit: fc.boolean(),
  })
  .map(({ kind, method, numbers, unit }): AppState => {
    const at = (i: number) => [numbers[i], numbers[i + 1], numbers[i + 2]] as never;
    const shape = Object.fromEntries(
      Object.entries(INITIAL.shapes[kind]).map(([key, value], i) => [
        key,
        typeof value === 'number'
          ? Math.abs(numbers[12 + (i % 2)] ?? 1)
          : Array.isArray(value)
            ? at(6 + (key === 'normal' ? 0 : 3))
            : value,
      ]),
    );
    return {
      ...INITIAL,
      kind,
      method,
      unit,
      E: at(0),
      d: at(3),
      shapes: { ...INITIAL.shapes, [kind]: shape as never },
    };
  })
  .filter(({ d, kind, shapes }) =>
    [d, (shapes[kind] as { normal?: readonly number[] }).normal ?? [1]].every((v) =>
      v.some((x) => x !== 0),
    ),
  );

describe('a line with = gives its result from its own printed numbers', () => {
  test('for numbers as people have them', () => {
    fc.assert(
      fc.property(ordinary, (state) => {
        expect(falseLines(derived(state))).toEqual([]);
      }),
      { numRuns: 200 },
    );
  });

  test('for every state that a link can carry', () => {
    fc.assert(
      fc.property(anyPicture, (state) => {
        expect(falseLines(derived(state))).toEqual([]);
      }),
      { numRuns: 150 },
    );
  });

  test('and lines of ordinary numbers need no ≈', () => {
    const model = linked('shape=cone&E=3,1,1&d=-0.8,-0.2,-0.3&V=0,3,0&c=1/3');
    expect(linesOf(model).map(({ id, isFaithful }) => [id, isFaithful])).toEqual(
      ['A', 'B', 'C', 'D', 't'].map((id) => [id, true]),
    );
  });
});

/** Where a line of Check, read as it is printed with =, does not give what it ends with. */
function falseLinesOfCheck(lines: readonly CheckLine[]): string[] {
  return lines.flatMap((line) => {
    const { exprs, relation, values, numbers, worked } = line;
    const put = putIntoLine(line);
    if (!put?.isFaithful) return [];
    const trees = relation ? [relation.left, relation.right] : exprs;
    return trees.flatMap((tree, i) => {
      const text = inNumbers(tree, PLAIN, numbers, { worked, digits: put.digits });
      const ends = trees.length === 1 ? values : values.slice(i, i + 1);
      const downwards = ends.length === 2 && (numbers.scalars.A ?? 0) > 0;
      return ends
        .map((x, j) => [x, (j === 0) === downwards ? -1 : 1] as const)
        .filter(([x, branch]) => Number.isFinite(x) && !gives(tree, text, x, branch))
        .map(([x]) => `${line.id}: ${text} = ${display(x)}`);
    });
  });
}

/** Of a length the square is read. */
function gives(tree: Expr, text: string, x: number, branch: 1 | -1): boolean {
  if (tree.op !== 'norm') return rounds(readLine(text, branch), display(x));
  const inner = text.slice(1, -1);
  const square = readLine(`${inner}·${inner}`);
  if (x === 0) return square.n === 0n;
  const half = `5·10^${Number(x.toExponential(5).split('e')[1]) - 6}`.replace('^-', '^−');
  const [low, high] = ['−', '+'].map((sign) => readLine(`(${plain(display(x))}${sign}${half})^2`));
  return low !== undefined && high !== undefined && isAtMost(low, square) && isAtMost(square, high);
}

test('the lines of Check: solutions, hints, and the lines of a mistake', () => {
  for (const exercise of EXERCISES) {
    for (const [i, kind] of exercise.kinds.entries()) {
      const posed = pose(exercise, kind, 4001 * (i + 1), ([1, 2, 3] as const)[i % 3] ?? 1);
      const lines = [...solutionOf(posed).lines, ...hintsOf(posed).flatMap((hint) => hint.lines)];
      expect(falseLinesOfCheck(lines), `${exercise.id} ${kind}`).toEqual([]);
    }
  }
});

test('and those of own numbers', () => {
  fc.assert(
    fc.property(ordinary, (state) => {
      const { ray, state: drawn } = derived(state);
      const input = { shape: drawn.shapes[drawn.kind], ray };
      expect(falseLinesOfCheck(linesOfCheck(courseOf(input.shape), input))).toEqual([]);
    }),
    { numRuns: 100 },
  );
});

const WHOLE = {
  ...{ between: null, leaves: false, passes: false },
  ...{ least: 0, most: Number.POSITIVE_INFINITY },
};

test('the lines of a pixel', () => {
  fc.assert(
    fc.property(ordinary, (state) => {
      const { ray, state: drawn } = derived(state);
      const shape = drawn.shapes[drawn.kind];
      const steps = surfaceSteps(shape, { ...WHOLE, ray }, drawn.method);
      for (const { step, numbers, put } of steps?.lines ?? []) {
        if (!put?.isFaithful || step.value === null || !Number.isFinite(step.value)) continue;
        const { expr, worked } = step;
        const text = inNumbers(expr, PLAIN, numbers, { worked, digits: put.digits });
        expect(rounds(readLine(text), display(step.value)), text).toBe(true);
      }
    }),
    { numRuns: 100 },
  );
});

test('a condition read as it is printed says what was decided', () => {
  fc.assert(
    fc.property(fc.oneof(ordinary, anyPicture), (state) => {
      const { conditions, numbers } = derived(state).derivation;
      for (const condition of conditions) {
        const { digits, isFaithful } = conditionDigits(condition, numbers);
        const { relation, left, right, holds } = condition;
        const sides =
          relation.left.op === 'norm'
            ? [left, right].map((x) => plain(display(x, digits)))
            : [relation.left, relation.right].map((e) =>
                inNumbers(e, PLAIN, numbers, { worked: false, digits }),
              );
        if (!isFaithful || holds === null) continue;
        const [a, b] = sides.map((text) => readLine(text));
        expect(a && b && isAtMost(a, b), `${sides.join(' ≤ ')} ${holds}`).toBe(holds);
      }
    }),
    { numRuns: 150 },
  );
});

const plain = (text: string): string =>
  text
    .replaceAll(' ', '')
    .replace(
      /[⁻⁰¹²³⁴⁵⁶⁷⁸⁹]+/,
      (raised) =>
        `^${[...raised].map((c) => (c === '⁻' ? '−' : '⁰¹²³⁴⁵⁶⁷⁸⁹'.indexOf(c))).join('')}`,
    );

test('two different roots never read alike', () => {
  fc.assert(
    fc.property(fc.double({ noNaN: true, noDefaultInfinity: true }), (t) => {
      const above = t + Math.abs(t) * 1e-9 + Number.MIN_VALUE;
      if (!Number.isFinite(above) || above === t) return;
      const [first, second] = rootTexts([t, above]);
      expect(first).not.toBe(second);
    }),
  );
});

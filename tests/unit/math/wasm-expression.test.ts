import { describe, expect, test } from 'vitest';
import { type Code, codeOf } from '../../../scripts/kernels/certified/expression.ts';
import { expressionOf } from '../../../scripts/kernels/certified/source.ts';
import { integer, pick, type Random, seeded, wide } from '../../../src/math/rng.ts';
import { compiled, compiledCondition } from './compiled.ts';

/*
 * Formulas of TypeScript, compiled for two rays at a time, against the same formulas in this
 * engine: the same bits.
 */

const NAMES = ['a', 'b', 'c', 'd_2'] as const;
const ODD = [
  ...[0, -0, 1, -1, Number.NaN, Number.POSITIVE_INFINITY, Number.NEGATIVE_INFINITY, 0.1],
  ...[Number.MIN_VALUE, -Number.MIN_VALUE, 2 ** -1022, 2 ** -1022 - Number.MIN_VALUE],
  ...[Number.MAX_VALUE, -Number.MAX_VALUE, 2 ** 53 + 2, 1 + 2 ** -52, 1 - 2 ** -53],
];
const anyNumber = (random: Random): number =>
  pick(random, [
    () => ODD[integer(random, 0, ODD.length - 1)] as number,
    () => wide(random),
    () => wide(random, -3, 3),
  ])();
const anyNumbers = (random: Random): Record<string, number> =>
  Object.fromEntries(NAMES.map((name) => [name, anyNumber(random)]));

/** The formula by this engine. */
const native = (formula: string): ((at: Readonly<Record<string, number>>) => number) => {
  const run = new Function(...NAMES, `return ${formula};`);
  return (at) => run(...NAMES.map((name) => at[name])) as number;
};

function expectSame(formula: string, seed: number, count: number): void {
  const random = seeded(seed);
  const fast = compiled(formula, NAMES);
  const plain = native(formula);
  for (let k = 0; k < count; k++) {
    const [low, high] = [anyNumbers(random), anyNumbers(random)];
    const got = fast(low, high);
    const want = [plain(low), plain(high)];
    if (!got.every((x, i) => Object.is(x, want[i])))
      expect([formula, low, high, ...got]).toEqual([formula, low, high, ...want]);
  }
}

describe('the same bits as this engine (seed 161)', () => {
  const formulas = [
    ...['a', '-a', '- -a', '-a * b', '-(a * b)', 'a - -b', 'a * -b', '-a - b', '-(-a + b)'],
    ...['a + b', 'a - b', 'a * b', 'a / b', 'a - b - c', 'a - (b - c)', 'a / b / c', 'a / (b / c)'],
    ...['a * b / c', 'a / b * c', 'a * (b / c)', 'a + b - c + d_2', 'a - b + c', 'a + b + c'],
    ...['a + (b + c)', 'a + b * c', '(a + b) * c', 'a * b + c * d_2', 'a - b * c - d_2'],
    ...['a * b * c', 'a * (b * c)', 'a * b - c / d_2', '((a))', '(a - b) * (a + b)'],
    ...['Math.abs(a)', 'Math.sqrt(a)', 'Math.sqrt(Math.abs(a * b - c))', '-Math.abs(a)'],
    ...['Math.min(a, b)', 'Math.max(a, b)', 'Math.max(a - b, Math.min(c, -d_2)) * a'],
    ...['Math.min(Math.max(a, b), c)', 'Math.abs(a) * Math.abs(b)', 'Math.sqrt(a) / Math.sqrt(b)'],
    ...['0', '-0', '1', '0.5 * a', '1.5', '2.25e3', '1e300 * a', '1e22', '0.1 + a', '123456789'],
    ...['134217729 * a', '0.6 * a / b', '1 / (a * b)', '9007199254740993', '1e400', '0 * a'],
  ];
  test.each(formulas)('%s', (formula) => expectSame(formula, 161, 1500));

  test('split over lines, and without spaces', () => {
    expectSame('a *\n      b -\n c', 162, 50);
    expectSame('a*b-c/(d_2+a)', 162, 50);
  });
});

/** A formula at random, with no more brackets than it needs. */
function anyFormula(random: Random, depth: number): string {
  const inner = (): string => anyFormula(random, depth - 1);
  if (depth === 0) return pick(random, ['a', 'b', 'c', 'd_2', '1', '0.75', '-a', '3']);
  return pick(random, [
    () => `${inner()} + ${inner()}`,
    () => `${inner()} - ${inner()}`,
    () => `${inner()} * ${inner()}`,
    () => `${inner()} / ${inner()}`,
    () => `(${inner()})`,
    () => `-(${inner()})`,
    () => `Math.abs(${inner()})`,
    () => `Math.sqrt(${inner()})`,
    () => `Math.max(${inner()}, ${inner()})`,
    () => `Math.min(${inner()}, ${inner()})`,
  ])();
}

test('300 formulas at random, up to five operations deep (seed 163)', () => {
  const random = seeded(163);
  for (let k = 0; k < 300; k++) expectSame(anyFormula(random, integer(random, 1, 5)), 164 + k, 25);
});

describe('conditions (seed 165)', () => {
  const formulas = [
    ...['a < b', 'a > b', 'a <= b', 'a >= b', 'a < b && b < c', 'a < b && b <= c && c > d_2'],
    ...['a + b < c * d_2', 'a > b * c + d_2', '-a <= b - c', '(a < b) && (c >= d_2)'],
    ...['Math.abs(a) > b && a * a < c', 'a >= a', 'a < 1 && a > -1', 'Math.max(a, b) <= c - d_2'],
  ];
  test.each(formulas)('%s', (formula) => {
    const random = seeded(165);
    const fast = compiledCondition(formula, NAMES);
    const plain = native(formula);
    const seen = new Set<boolean>();
    for (let k = 0; k < 1500; k++) {
      const at = anyNumbers(random);
      seen.add(fast(at));
      expect([at, fast(at)]).toEqual([at, plain(at)]);
    }
    expect(seen.size).toBe(2);
  });
});

describe('what is no formula', () => {
  const value = (name: string): Code => {
    if (name !== 'a' && name !== 'b') throw new ReferenceError(`${name} is not known`);
    return [];
  };
  const compile = (formula: string): Code => codeOf(expressionOf(formula), value);
  const wrong: [string, string, RegExp][] = [
    ['an unknown name', 'a + secret', /^secret is not known$/],
    ['an unknown operation', 'a % b', /^formula:1: a % b is not understood$/],
    ['a bracket that is not closed', '(a + b', /^formula:\d: /],
    ['a bracket that was not opened', 'a + b)', /^formula:\d: /],
    ['an unknown function', 'Math.cbrt(a)', /^formula:1: Math\.cbrt\(a\) is not understood$/],
    ['another function', 'sqrt(a)', /^formula:1: sqrt\(a\) is not understood$/],
    ['a function without brackets', 'Math.abs', /^formula:1: Math\.abs is not understood$/],
    ['too few operands', 'Math.max(a)', /^formula:1: Math\.max\(a\) is not understood$/],
    ['too many', 'Math.abs(a, b)', /^formula:1: Math\.abs\(a, b\) is not understood$/],
    ['three of two', 'Math.min(a, b, a)', /^formula:1: Math\.min\(a, b, a\) is not/],
    ['nothing', '', /^formula:\d: /],
    ['a missing operand', 'a +', /^formula:\d: /],
    ['a power', 'a ** b', /^formula:1: a \*\* b is not understood$/],
    ['a choice', 'a < b ? a : b', /^formula:1: a < b \? a : b is not understood$/],
    ['or', 'a < b || b < a', /^formula:1: a < b \|\| b < a is not understood$/],
    ['two values side by side', 'a b', /^formula:\d: /],
    ['an element of no known type', 'a[i]', /^formula:1: a\[i\] is not understood$/],
    ['equality', 'a === b', /^formula:1: a === b is not understood$/],
    ['a comma', 'a, b', /^formula:1: a, b is not understood$/],
    ['a text', "'a'", /^formula:1: 'a' is no number$/],
  ];
  test.each(wrong)('%s: %s', (_, formula, message) => {
    expect(() => compile(formula)).toThrow(message);
  });

  test('a small number keeps its exponent', () => {
    expect(compile('2.5e-7')).toEqual(compile('0.00000025'));
    expect(compile('2e+3')).toEqual(compile('2000'));
  });
});

import { describe, expect, test } from 'vitest';
import { integer, pick, type Random, seeded, wide } from '../../../src/math/rng.ts';
import { type Code, codeOf } from '../../../src/math/wasm/expression.ts';
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
  const wrong: [string, string, RegExp][] = [
    ['an unknown name', 'a + secret', /^secret is not known$/],
    ['an unknown token', 'a % b', /^unexpected % b in a % b$/],
    ['a bracket that is not closed', '(a + b', /^unexpected end in \(a \+ b$/],
    ['a bracket that was not opened', 'a + b)', /^unexpected \) in a \+ b\)$/],
    ['an unknown function', 'Math.cbrt(a)', /^unexpected Math\.cbrt in Math\.cbrt\(a\)$/],
    ['a function without brackets', 'Math.abs a', /^unexpected a in Math\.abs a$/],
    ['a function that is not closed', 'Math.sqrt(a', /^unexpected end in Math\.sqrt\(a$/],
    ['too few operands', 'Math.max(a)', /^unexpected \) in Math\.max\(a\)$/],
    ['too many', 'Math.abs(a, b)', /^unexpected , in Math\.abs\(a, b\)$/],
    ['three of two', 'Math.min(a, b, a)', /^unexpected , in Math\.min\(a, b, a\)$/],
    ['nothing', '', /^unexpected end in $/],
    ['a missing operand', 'a +', /^unexpected end in a \+$/],
    ['an operator before', '* a', /^unexpected \* in \* a$/],
    ['a power', 'a ** b', /^unexpected \* in a \*\* b$/],
    ['a choice', 'a < b ? a : b', /^unexpected \? a : b in a < b \? a : b$/],
    ['or', 'a < b || b < a', /^unexpected \|\| b < a in a < b \|\| b < a$/],
    ['two values side by side', 'a b', /^unexpected b in a b$/],
    ['an array', 'a[i]', /^unexpected \[i\] in a\[i\]$/],
    ['equality', 'a === b', /^unexpected === b in a === b$/],
    ['a comma', 'a, b', /^unexpected , in a, b$/],
    ['a number with two points', '1.2.3 * a', /^unexpected \.3 \* a in 1\.2\.3 \* a$/],
    ['a number without its exponent', '1e * a', /^unexpected e in 1e \* a$/],
    ['a number in hexadecimal', '0x10', /^unexpected x10 in 0x10$/],
  ];
  test.each(wrong)('%s: %s', (_, formula, message) => {
    expect(() => codeOf(formula, value)).toThrow(message);
  });

  test('a small number keeps its exponent', () => {
    expect(codeOf('2.5e-7', value)).toEqual(codeOf('0.00000025', value));
    expect(codeOf('2e+3', value)).toEqual(codeOf('2000', value));
  });
});

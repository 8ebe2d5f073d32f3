import { describe, expect, test } from 'vitest';
import { exactOf } from '../../../../src/math/exact/of-typed.ts';
import * as surd from '../../../../src/math/exact/surd.ts';
import { parseTyped } from '../../../../src/text/parse.ts';

function exactValue(text: string): surd.Surd | null {
  const tree = parseTyped(text);
  if (!tree) throw new Error(`${text} is not read`);
  return exactOf(tree);
}

const whole = (n: number): surd.Surd => surd.fromNumber(n);
const ratio = (n: number, d: number): surd.Surd => surd.div(whole(n), whole(d));

describe('the exact value of what is typed', () => {
  test.each<[string, number, number]>([
    ['0.3', 3, 10],
    ['-,5', -1, 2],
    ['1.50e-3', 15, 10_000],
    ['12e3', 12_000, 1],
    ['0e999', 0, 1],
    ['1/3', 1, 3],
    ['1/3 - 0.1', 7, 30],
    ['2^-3', 1, 8],
    ['(2/3)^3', 8, 27],
    ['0.1^0', 1, 1],
    ['2·10⁻³', 1, 500],
    ['sqrt(1/2)^2', 1, 2],
    ['sqrt(0.09)', 3, 10],
    ['√2·√8', 4, 1],
    ['sqrt(8) - 2·√2', 0, 1],
    ['abs(1 - √2) - √2', -1, 1],
    ['1/(√2 - 1) - √2', 1, 1],
    ['sin(30 deg)', 1, 2],
    ['tan(30°)^2', 1, 3],
    ['cos(-120°)', -1, 2],
    ['sin(45°)·√2', 1, 1],
    ['cos(0) + exp(0) + ln(1) + sin(0 deg)', 2, 1],
    ['0.5 rad', 1, 2],
  ])('%s = %s/%s', (text, n, d) => {
    const value = exactValue(text);
    expect(value && surd.compare(value, ratio(n, d))).toBe(0);
  });

  test.each(['pi', '0·pi', 'sin(1)', '30 deg', 'sin(10°)', '√2 + √3', '√(1+√2)', '2^0.5', 'ln(2)'])(
    '%s has none',
    (text) => {
      expect(exactValue(text)).toBeNull();
    },
  );

  test('and a power that nobody works out by hand is left to the doubles', () => {
    expect(exactValue('1.0000001^1000000')).toBeNull();
    expect(exactValue('((1.001^99)^99)^0.1')).toBeNull();
    expect(exactValue('2^1000')).not.toBeNull();
  });
});

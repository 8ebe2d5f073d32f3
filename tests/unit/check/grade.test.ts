import { describe, expect, test } from 'vitest';
import { FOUR_DIGITS, grade, matches } from '../../../src/check/grade.ts';
import { judge } from '../../../src/check/judge.ts';
import {
  type Answer,
  choiceField,
  directionField,
  numberField,
  tripleField,
} from '../../../src/check/types.ts';
import { nextUp } from '../../../src/math/float/ulp.ts';

const x = numberField('x');
const P = tripleField('P');
const N = directionField('N');
const which = choiceField('which', 'which', [
  { id: 'a', title: 'A' },
  { id: 'b', title: 'B' },
]);
const verdict = (field: typeof x, text: string, truth: Answer | undefined) =>
  grade(field, text, truth).verdict;

describe('a number', () => {
  test.each([
    ['0.3333', 1 / 3],
    ['1/3', 1 / 3],
    ['-2/3', -2 / 3],
    ['sqrt(5)/2', Math.sqrt(5) / 2],
    ['0,5', 0.5],
    ['−1,25', -1.25],
    ['1e3', 1000],
    ['2·10⁻³', 0.002],
    ['-0', 0],
    ['0', -0],
    ['0', 0],
  ])('%s is right for %f', (text, truth) => expect(verdict(x, text, truth)).toBe('correct'));

  test.each([
    ['0.33', 1 / 3],
    ['1/3', -1 / 3],
    ['0', 1e-3],
    ['1', 0],
    ['1/0', 5],
    ['infinity', 5],
    ['-1/0', Number.POSITIVE_INFINITY],
    ['2', 1],
    ['5', undefined],
  ])('%s is wrong for %s', (text, truth) => expect(verdict(x, text, truth)).toBe('wrong'));

  test.each(['', '   ', 'abc', '1,2,3', 'x+1', '1/', 'sqrt(-1)', '<b>1</b>', '0/0', 'constructor'])(
    '%j is invalid: no blame',
    (text) => expect(verdict(x, text, 1)).toBe('invalid'),
  );

  test('the tolerance ends where it says', () => {
    for (const truth of [1, -1, 1024, 2 ** -20]) {
      const edge = truth * (1 + FOUR_DIGITS);
      expect(matches(x, truth * (1 + FOUR_DIGITS * 0.999), truth)).toBe(true);
      expect(matches(x, truth * (1 - FOUR_DIGITS * 0.999), truth)).toBe(true);
      expect(matches(x, edge * 1.000001, truth)).toBe(false);
    }
    expect(matches(x, FOUR_DIGITS, 0)).toBe(true);
    expect(matches(x, -FOUR_DIGITS, 0)).toBe(true);
    expect(matches(x, nextUp(FOUR_DIGITS), 0)).toBe(false);
  });

  test('whoever rounds to four digits is right', () => {
    for (let k = 1; k < 4000; k++) {
      const truth = Math.sqrt(k) * 10 ** ((k % 7) - 3);
      expect(verdict(x, truth.toPrecision(4), truth)).toBe('correct');
    }
  });

  test('three digits are mostly too few', () => {
    let wrong = 0;
    for (let k = 1; k < 1000; k++) {
      if (verdict(x, Math.sqrt(k).toPrecision(2), Math.sqrt(k)) === 'wrong') wrong++;
    }
    expect(wrong).toBeGreaterThan(800);
  });

  test('no value is met by an infinite one only', () => {
    expect(verdict(x, '1/0', Number.NaN)).toBe('correct');
    expect(verdict(x, '0', Number.NaN)).toBe('wrong');
  });
});

describe('points and normals', () => {
  test.each([
    ['1; 2; 3', 'correct'],
    ['(1, 2, 3)', 'correct'],
    ['1 2 3', 'correct'],
    ['1,0; 2,0; 3,0', 'correct'],
    ['1, 2, -3', 'wrong'],
    ['2, 4, 6', 'wrong'],
    ['3, 2, 1', 'wrong'],
    ['1, 2', 'invalid'],
    ['1, 2, x', 'invalid'],
  ])('the point %s is %s', (text, expected) => expect(verdict(P, text, [1, 2, 3])).toBe(expected));

  test.each([
    ['1, 2, 2', 'correct'],
    ['2, 4, 4', 'correct'],
    ['1/3, 2/3, 2/3', 'correct'],
    ['-1, -2, -2', 'wrong'],
    ['1, 2, 2.1', 'wrong'],
    ['0, 0, 0', 'wrong'],
    ['1/0, 2, 2', 'wrong'],
  ])('the direction %s is %s', (text, expected) =>
    expect(verdict(N, text, [1, 2, 2])).toBe(expected),
  );
});

describe('a choice', () => {
  test.each([
    ['a', 'correct'],
    ['b', 'wrong'],
    ['c', 'invalid'],
    ['', 'invalid'],
  ])('%s is %s', (text, expected) => expect(verdict(which, text, 'a')).toBe(expected));
});

describe('several fields', () => {
  const misconception = (id: string) => ({
    id,
    code: 'X1',
    says: id,
    line: 'x',
    remedy: '',
    edit: () => null,
  });
  const y = numberField('y');
  const suspects = [
    { misconception: misconception('both'), answers: { x: 2, y: 3 } },
    { misconception: misconception('one'), answers: { x: 2, y: 20 } },
  ];
  const of = (a: string, b: string) => judge([x, y], { x: a, y: b }, { x: 1, y: 20 }, suspects);

  test('with one cause name it once', () => {
    expect(of('2', '3')).toMatchObject({ verdict: 'wrong', cause: { id: 'both' } });
    expect(of('2', '20')).toMatchObject({ verdict: 'wrong', cause: { id: 'one' } });
  });

  test('with two possible causes name none', () => {
    expect(of('2', '')).toMatchObject({ verdict: 'wrong', cause: { id: 'both' } });
    expect(of('2', '7').cause).toBeNull();
    expect(of('9', '20').cause).toBeNull();
  });

  test('one unanswered field is no mistake', () => {
    expect(of('1', '').verdict).toBe('invalid');
    expect(of('1', '20').verdict).toBe('correct');
  });
});

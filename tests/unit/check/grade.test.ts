import { describe, expect, test } from 'vitest';
import { courseOf } from '../../../src/check/course.ts';
import { derivationOf } from '../../../src/check/derivation.ts';
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

  test.each([2, 3])(
    'whoever rounds to %i digits, or cuts them off, is told how many are right',
    (digits) => {
      for (let k = 1; k < 2000; k++) {
        const truth = (k % 2 === 0 ? 1 : -1) * Math.sqrt(k + 0.123) * 10 ** ((k % 7) - 3);
        const power = Math.floor(Math.log10(Math.abs(truth))) - digits + 1;
        const cut = Math.trunc(truth / 10 ** power) * 10 ** power;
        for (const text of [truth.toPrecision(digits), cut.toPrecision(digits)]) {
          const mark = grade(x, text, truth);
          if (mark.verdict !== 'correct')
            expect(mark, `${text} for ${truth}`).toMatchObject({ verdict: 'rounded', digits });
        }
      }
    },
  );

  test.each([
    ['-3.83', -23 / 6, 'rounded'],
    ['2.67', 8 / 3, 'rounded'],
    ['2.66', 8 / 3, 'rounded'],
    ['64.4', 64.44, 'rounded'],
    ['-0.90', -0.90237, 'rounded'],
    ['38', 38.33, 'rounded'],
    ['3.83', -23 / 6, 'wrong'],
    ['2.68', 8 / 3, 'wrong'],
    ['2.65', 8 / 3, 'wrong'],
    ['3', 10 / 3, 'wrong'],
    ['0.00', 0.004, 'wrong'],
    ['267/100', 8 / 3, 'wrong'],
    ['1.000', 1.0009, 'correct'],
  ])('%s for %f is %s', (text, truth, expected) => expect(verdict(x, text, truth)).toBe(expected));

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
    ['1.01, 2.00, 3.00', 'wrong'],
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

test.each([
  ['0.333, 0.667, 1.00', 'correct'],
  ['0.33, 0.667, 1.00', 'rounded'],
  ['(0.33; 0.66; 1)', 'rounded'],
  ['0.34, 0.67, 1.00', 'wrong'],
])('the point %s is %s for thirds', (text, expected) =>
  expect(verdict(P, text, [1 / 3, 2 / 3, 1])).toBe(expected),
);

test('a direction may be rounded, too', () => {
  expect(verdict(N, '0.27, 0.53, 0.80', [1, 2, 3])).toBe('rounded');
  expect(verdict(N, '0.27, 0.53, 0.70', [1, 2, 3])).toBe('wrong');
});

test.each([
  ['a=2', 'without a name'],
  ['2sqrt(3)x', '2*sqrt(3)'],
  ['−3 5/6 7', 'as a sum'],
])('%s is answered with advice', (text, advice) => {
  expect(grade(x, text, 1)).toMatchObject({
    verdict: 'invalid',
    reason: expect.stringContaining(advice),
  });
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
  const y = numberField('y');
  /**
   * The course gives (1, 20); whatever is edited gives (7, 20) or, without the start at E, (2, 3).
   */
  const shape = { kind: 'cylinder', center: [0, 0, 0], radius: 1 } as const;
  const course = courseOf(shape);
  const derivation = derivationOf([x, y], course, [], (edited) => {
    if (edited === course) return { x: 1, y: 20 };
    return edited.P === course.P ? { x: 7, y: 20 } : { x: 2, y: 3 };
  });
  const of = (a: string, b: string) => judge(derivation, { x: a, y: b });

  test('with several possible causes name none', () => {
    expect(of('2', '3')).toMatchObject({ verdict: 'wrong', causes: [] });
    expect(of('7', '20')).toMatchObject({ verdict: 'wrong', causes: [] });
    expect(of('2', '20').causes).toEqual([]);
  });

  test('with several the one that the question is about', () => {
    const watched = derivationOf([x, y], course, ['backwards'], derivation.next);
    const judged = judge(watched, { x: '2', y: '3' });
    expect(judged.causes.map(({ id }) => id)).toEqual(['backwards']);
    expect(judge(watched, { x: '2', y: '20' }).causes).toEqual([]);
  });

  test('one unanswered field is no mistake', () => {
    expect(of('1', '').verdict).toBe('invalid');
    expect(of('1', '20').verdict).toBe('correct');
  });
});

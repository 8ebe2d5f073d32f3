import { describe, expect, test } from 'vitest';
import { type Posed, pose } from '../../../src/check/compose.ts';
import { courseOf } from '../../../src/check/course.ts';
import { byParam, quadraticWords } from '../../../src/check/exercises/by-param.ts';
import { CASES } from '../../../src/check/exercises/define.ts';
import { EXERCISES, findExercise } from '../../../src/check/exercises/index.ts';
import { withParam } from '../../../src/check/exercises/params.ts';
import { hintsOf, solutionOf } from '../../../src/check/solution.ts';
import { work } from '../../../src/check/work.ts';
import { display } from '../../../src/text/format.ts';

const LEVELS = [1, 2, 3] as const;
const posedBy = (id: string): Posed[] => {
  const exercise = findExercise(id);
  if (!exercise) throw new RangeError(id);
  return Array.from({ length: 24 }, (_, i) => {
    const kind = exercise.kinds[i % exercise.kinds.length] as (typeof exercise.kinds)[number];
    return pose(exercise, kind, 977 * (i + 1), LEVELS[i % 3] ?? 1);
  });
};

const isGiven = ({ given }: Posed, line: string): boolean =>
  given[line] !== undefined || given[`${line}1`] !== undefined;

describe.each(EXERCISES.map(({ id }) => id))('%s', (id) => {
  const all = posedBy(id);

  test('each hint says something, and no line of it is given', () => {
    for (const posed of all) {
      for (const { words, lines } of hintsOf(posed)) {
        expect(words !== '' || lines.length > 0, JSON.stringify(posed.draft)).toBe(true);
        for (const line of lines) expect(isGiven(posed, line.id), line.id).toBe(false);
      }
      // What is to be found stands in no hint.
      const [, , last] = hintsOf(posed);
      if (last.lines.length > 0) for (const { values } of last.lines) expect(values).toEqual([]);
    }
  });

  test('it begins after what is given; what is asked is on its lines or in its words', () => {
    for (const posed of all) {
      const { lines, decision } = solutionOf(posed);
      for (const line of lines) expect(isGiven(posed, line.id), line.id).toBe(false);
      for (const { kind, id: field } of posed.fields) {
        const line = lines.some((one) => one.id === field.replace(/[12]$/, ''));
        expect(kind === 'choice' ? decision.length > 0 : line || decision.length > 0, field).toBe(
          true,
        );
      }
    }
  });
});

/** What the sentence about a case says, in the words of the choice. */
const SAYS: Readonly<Record<string, RegExp>> = {
  none: /so no point\.$/,
  tangent: /one point: the line touches\.$/,
  one: /so one point\.$/,
  two: /so two points\.$/,
  contained: /whole line lies in the surface\.$/,
};

describe('the decision says what is right', () => {
  test('every case has its sentence', () => {
    expect(Object.keys(SAYS).sort()).toEqual(CASES.map(({ id }) => id).sort());
  });

  test.each(['discriminant', 'nappes', 'linear'])('%s: the sign, and how many points', (id) => {
    for (const posed of posedBy(id)) {
      expect(solutionOf(posed).decision[0]).toMatch(SAYS[String(posed.truth.case)] ?? /^$/);
    }
  });

  test('crossing: below, at and above', () => {
    for (const posed of posedBy('crossing')) {
      const [, ...each] = solutionOf(posed).decision;
      expect(each).toHaveLength(3);
      for (const [i, id] of ['before', 'at', 'after'].entries()) {
        expect(each[i]).toMatch(SAYS[String(posed.truth[id])] ?? /^$/);
      }
    }
  });

  test('tangent: the value that was solved for', () => {
    for (const posed of posedBy('tangent')) {
      const { decision } = solutionOf(posed);
      const [, said = ''] = /= (\S+)\.$/.exec(decision.join()) ?? [];
      expect(Number(said)).toBeCloseTo(Number(posed.truth.value), 4);
      // And no hint has it.
      const value = posed.draft.param?.value ?? 0;
      const words = hintsOf(posed)
        .map((hint) => hint.words)
        .join();
      expect(words).not.toContain(`${posed.draft.param?.symbol} = ${display(value)}`);
    }
  });

  test('A and D are quadratic in the parameter, as the words say', () => {
    const tangents = posedBy('tangent').map(({ draft }) => draft);
    const posedAsTangent = new Set(tangents);
    for (const draft of [...tangents, ...posedBy('crossing').map((one) => one.draft)]) {
      const [by, { param, shape, ray }] = [byParam(draft), draft];
      if (!by || !param) throw new RangeError('no parameter');
      for (const value of [0.25, 1.5, 3, 7]) {
        const input = { shape: withParam(shape, param, value), ray };
        const found = work(courseOf(shape), input);
        for (const id of ['A', 'D'] as const) {
          const { start, linear, square } = by[id];
          const sum = start + linear * value + square * value * value;
          expect(sum, `${id} ${JSON.stringify(input)}`).toBeCloseTo(Number(found[id]), 6);
        }
      }
      const { start, linear, square } = by.D;
      const { value } = param;
      if (posedAsTangent.has(draft)) {
        expect(start + linear * value + square * value * value).toBeCloseTo(0, 6);
      }
    }
    expect(quadraticWords({ start: 36, linear: 0, square: -4 }, 'r')).toBe('36 − 4 r²');
    expect(quadraticWords({ start: -5, linear: 1, square: 0 }, 'a')).toBe('−5 + a');
    expect(quadraticWords({ start: 0, linear: -3, square: 1 }, 'w')).toBe('−3 w + w²');
    expect(quadraticWords({ start: 2.5, linear: 0, square: 0 }, 'r')).toBe('2.5');
    expect(quadraticWords({ start: 0, linear: 0, square: 0 }, 'r')).toBe('0');
  });

  test('first and shadow: by the intervals', () => {
    for (const posed of posedBy('first')) {
      const says = solutionOf(posed).decision.join();
      const expected = {
        t1: /t₁ is nearer/,
        t2: /only t₂ is in front/,
        none: /neither is visible/,
      };
      expect(says).toMatch(expected[posed.truth.first as keyof typeof expected]);
    }
    for (const posed of posedBy('shadow')) {
      const dark = posed.truth.shadow === 'dark';
      const says = dark ? 'the surface stands before the light' : 'nothing stands before the light';
      expect(solutionOf(posed).decision.join()).toContain(says);
    }
  });

  test('flat: each bound is true or false, and together they decide', () => {
    for (const posed of posedBy('flat')) {
      const bounds = solutionOf(posed).lines.filter(({ relation }) => relation !== null);
      for (const { values, holds } of bounds) {
        const [left = 0, right = 0] = values;
        if (Math.abs(left - right) > 1e-9) expect(holds).toBe(left < right);
        else expect(holds).toBe(true);
      }
      const inside = bounds.every(({ holds }) => holds);
      expect(posed.truth.inside).toBe(inside ? 'inside' : 'outside');
    }
  });

  test('parallel: in the plane or beside it', () => {
    for (const posed of posedBy('parallel')) {
      const expected = posed.truth.place === 'in' ? 'the line lies in it' : 'passes beside it';
      expect(solutionOf(posed).decision.join()).toContain(expected);
    }
  });

  test('point and nappes: which root comes first', () => {
    for (const posed of posedBy('point')) {
      const first = Number(posed.given.t1) >= 0 ? 'meets t₁ first' : 'meets t₂ first';
      expect(solutionOf(posed).decision.join()).toContain(first);
    }
    for (const posed of posedBy('nappes')) {
      expect(solutionOf(posed).decision.at(-1)).toMatch(`0 ≤ ${display(Number(posed.truth.t))} <`);
    }
  });

  test('roots: which sign gives the smaller one', () => {
    for (const posed of posedBy('roots')) {
      const { A = 0, B = 0 } = posed.given as Readonly<Record<string, number>>;
      const { t1 = 0 } = posed.truth as Readonly<Record<string, number>>;
      const isMinus = 2 * A * t1 + B < 0;
      expect(solutionOf(posed).decision.join()).toContain(
        isMinus ? 'the minus sign' : 'the plus sign',
      );
    }
  });
});

import { describe, expect, test } from 'vitest';
import { type Course, courseOf } from '../../../src/check/course.ts';
import { mistakesIn } from '../../../src/check/derivation.ts';
import { drawInput } from '../../../src/check/exercises/draw.ts';
import { alike, type Texts } from '../../../src/check/grade.ts';
import type { Misconception } from '../../../src/check/misconceptions/define.ts';
import { checkOwn, ownFields } from '../../../src/check/own-numbers.ts';
import type { Answer, Answers, Field, Input } from '../../../src/check/types.ts';
import { work } from '../../../src/check/work.ts';
import { type Random, seeded } from '../../../src/math/rng.ts';
import { SHAPES, type ShapeKind } from '../../../src/math/shapes/index.ts';
import { shortest } from '../../../src/text/format.ts';
import { share } from '../many.ts';

const asText = (answer: Answer | undefined): string => {
  if (typeof answer === 'number') return Number.isNaN(answer) ? '1/0' : shortest(answer);
  return typeof answer === 'object' ? answer.map(shortest).join('; ') : (answer ?? '-');
};
const textsOf = (fields: readonly Field[], answers: Answers): Texts =>
  Object.fromEntries(
    fields.map(({ id, kind }) => [
      id,
      kind === 'choice' ? (answers[id] ?? '') : asText(answers[id]),
    ]),
  ) as Texts;

const isNumber = (answer: Answer | undefined): boolean =>
  [answer].flat().every((x) => typeof x !== 'number' || Number.isFinite(x));

/** Inputs of every case that this shape has. */
function inputsOf(kind: ShapeKind, random: Random): Input[] {
  const found = new Map<string, Input[]>();
  for (let i = 0; i < 6000; i++) {
    const input = drawInput(random, kind, ((i % 3) + 1) as 1 | 2 | 3);
    const { case: verdict, place, A, inside } = work(courseOf(input.shape), input);
    const key = [verdict, place, inside, typeof A === 'number' ? Math.sign(A) : ''].join();
    const some = found.get(key) ?? [];
    if (some.length < 1) found.set(key, [...some, input]);
  }
  return [...found.values()].flat();
}

/** Whether this mistake is one of the lines that this field stands for. */
function isEdited(right: Course, edited: Course, { id }: Field): boolean {
  const line = id.replace(/[12]$/, '');
  const differs = (...keys: string[]): boolean =>
    keys.some((key) => {
      const [a, b] = [right, edited].map((one) => (one as unknown as Record<string, unknown>)[key]);
      return JSON.stringify(a) !== JSON.stringify(b);
    });
  if (line === 't') return differs('roots', 'double', 'linear', 't', 'rules');
  if (line === 'inside') return differs('conditions');
  return differs({ 'N.d': 'rate', 'N.(E-P)': 'offset' }[line] ?? line);
}

interface Slip {
  readonly input: Input;
  readonly mistake: Misconception;
  readonly edited: Course;
  readonly answers: Answers;
}

/** Every mistake that shows on one of these inputs. */
function slipsOf(kind: ShapeKind): Slip[] {
  return inputsOf(kind, seeded(kind.length)).flatMap((input) => {
    const course = courseOf(input.shape);
    const fields = ownFields(input);
    const truth = work(course, input);
    return [...mistakesIn(course)].flatMap(([mistake, edited]): Slip[] => {
      const answers = work(edited, input);
      return alike(fields, answers, truth) ? [] : [{ input, mistake, edited, answers }];
    });
  });
}

describe.each(SHAPES.map(({ kind }) => kind))('%s', (kind) => {
  const slips = slipsOf(kind);

  test('whoever makes one mistake is told it, and that all after it follows from it', () => {
    for (const { input, mistake, edited, answers } of share(slips)) {
      const fields = ownFields(input);
      const course = courseOf(input.shape);
      const truth = work(course, input);
      const others = slips.filter((one) => one.input === input && one.mistake !== mistake);
      const first = fields.findIndex((field) => !alike([field], answers, truth));
      for (let last = first; last < fields.length; last++) {
        const typed = fields.slice(0, last + 1);
        // Nobody goes on from a division by zero.
        if (last > first && !typed.every(({ id }) => isNumber(answers[id]))) break;
        const report = checkOwn(input, textsOf(typed, answers));
        const where = JSON.stringify([mistake.id, input, textsOf(typed, answers), report.says]);
        // Two ways that happen to meet in their numbers: right is right.
        if (report.way) continue;
        for (const { field, verdict } of report.lines) {
          const differs = !alike([field], answers, truth);
          const expected = !differs
            ? ['correct', 'absent']
            : isEdited(course, edited, field)
              ? ['wrong', 'follows', 'rounded']
              : ['follows', 'rounded'];
          expect(expected, `${field.id} ${where}`).toContain(verdict);
        }
        const same = others.some((other) => alike(typed, other.answers, answers));
        if (same) continue;
        expect(report.firstWrong?.id, where).toBe(fields[first]?.id);
        expect(
          report.causes.map(({ id }) => id),
          where,
        ).toEqual([mistake.id]);
      }
    }
  });
});

import { describe, expect, test } from 'vitest';
import { derivationFor, type Posed } from '../../../src/check/compose.ts';
import { courseOf } from '../../../src/check/course.ts';
import { mistakesIn } from '../../../src/check/derivation.ts';
import { agrees, alike, type Texts } from '../../../src/check/grade.ts';
import { judge } from '../../../src/check/judge.ts';
import { checkOwn, ownFields } from '../../../src/check/own-numbers.ts';
import { plan, question } from '../../../src/check/session.ts';
import type { Answer, Field, Input } from '../../../src/check/types.ts';
import { work } from '../../../src/check/work.ts';
import { pick, type Random, seeded } from '../../../src/math/rng.ts';
import { shortest } from '../../../src/text/format.ts';
import { many } from '../many.ts';

const asText = (answer: Answer | undefined): string => {
  if (typeof answer === 'number') return Number.isNaN(answer) ? '1/0' : shortest(answer);
  return typeof answer === 'object' ? answer.map(shortest).join('; ') : (answer ?? '-');
};

const SEEDS = [1, 7, 41, 55, 123];
const QUESTIONS: readonly Posed[] = SEEDS.flatMap((seed) =>
  plan(seed).map((_, i) => question(seed, i)),
);
const COUNT = many(10_000);

/** Something else of about the same size. */
function wrongFor(field: Field, random: Random): Answer {
  const number = (): number => Math.round((random() - 0.5) * 2e7) / 1e5;
  if (field.kind === 'number') return number();
  if (field.kind === 'choice')
    return pick(random, field.options as [{ id: string; title: string }]).id;
  return [number(), number(), number()];
}

test('whoever makes one known mistake in a question is told it, be it watched or not', () => {
  let named = 0;
  for (const posed of QUESTIONS) {
    const derivation = derivationFor(posed);
    const { fields, truth } = posed;
    const all = [...mistakesIn(derivation.course)].map(([mistake, edited]) => ({
      mistake,
      answers: derivation.truth(edited),
    }));
    for (const { mistake, answers } of all) {
      // Most questions have no answer for what does not exist.
      const sayable = fields.every(
        ({ id, mayBeAbsent }) => mayBeAbsent || answers[id] !== undefined,
      );
      if (!sayable || alike(fields, answers, truth)) continue;
      const same = all.filter((other) => alike(fields, other.answers, answers));
      if (same.length > 1) continue;
      const texts = Object.fromEntries(fields.map(({ id }) => [id, asText(answers[id])]));
      const judged = judge(derivation, texts);
      if (judged.way || judged.verdict === 'rounded') continue;
      expect(
        judged.causes.map(({ id }) => id),
        JSON.stringify([posed.exercise.id, posed.draft, texts]),
      ).toEqual([mistake.id]);
      named++;
    }
  }
  expect(named).toBeGreaterThan(QUESTIONS.length);
});

describe('what no mistake explains gets no name', () => {
  test(`${COUNT} answers to questions of the seeds ${SEEDS.join(', ')}`, () => {
    const random = seeded(20261130);
    const derivations = QUESTIONS.map((posed) => derivationFor(posed));
    let judgedWrong = 0;
    for (let n = 0; n < COUNT; n++) {
      const at = n % QUESTIONS.length;
      const [posed, derivation] = [QUESTIONS[at], derivations[at]];
      if (!posed || !derivation) continue;
      const { fields, truth } = posed;
      // From one of the lines on, some are something else, and the first of them is not what a
      // known mistake gives.
      const from = Math.floor(random() * fields.length);
      const texts: Record<string, string> = {};
      let explained = false;
      fields.forEach((field, i) => {
        const isWrong = i === from || (i > from && random() < 0.5);
        const value = isWrong ? wrongFor(field, random) : (truth[field.id] ?? '-');
        texts[field.id] = asText(value);
        if (i !== from) return;
        const given = { value, units: [0, 0, 0] };
        explained =
          agrees(field, given, truth[field.id]) ||
          [...mistakesIn(derivation.course).values()].some((edited) =>
            agrees(field, given, derivation.truth(edited)[field.id]),
          );
      });
      if (explained) continue;
      const judged = judge(derivation, texts);
      if (judged.verdict !== 'wrong') continue;
      judgedWrong++;
      expect(judged.causes, JSON.stringify([posed.exercise.id, posed.draft, texts])).toEqual([]);
    }
    expect(judgedWrong).toBeGreaterThan(COUNT / 2);
  });

  test('own numbers with one line that is something else', () => {
    const random = seeded(7);
    for (let n = 0; n < many(400); n++) {
      const posed = QUESTIONS[n % QUESTIONS.length];
      if (!posed) continue;
      const input: Input = { shape: posed.draft.shape, ray: posed.draft.ray };
      const truth = work(courseOf(input.shape), input);
      const fields = ownFields(input).filter(
        ({ kind, id }) => kind !== 'choice' && truth[id] !== undefined,
      );
      const changed = pick(random, fields as [Field]);
      const value = wrongFor(changed, random);
      const mistaken = [...mistakesIn(courseOf(input.shape)).values()].some((edited) =>
        agrees(changed, { value, units: [0] }, work(edited, input)[changed.id]),
      );
      if (mistaken) continue;
      const texts: Texts = Object.fromEntries(
        fields.map((field) => [field.id, asText(field === changed ? value : truth[field.id])]),
      );
      const report = checkOwn(input, texts);
      expect(report.causes, JSON.stringify([input, texts])).toEqual([]);
      expect(report.firstWrong?.id, JSON.stringify([input, texts])).toBe(changed.id);
    }
  });
});

import { describe, expect, test } from 'vitest';
import {
  type Guess,
  judgementOf,
  QUESTIONS,
  questionOf,
} from '../../../../src/pages/explore/predictions.ts';
import { ASKS } from '../../../../src/state/ask.ts';
import { closerLook } from '../../../../src/state/closer-look.ts';
import { createDerive, type ExploreModel } from '../../../../src/state/derive.ts';
import { GALLERY } from '../../../../src/state/gallery/index.ts';
import { decode } from '../../../../src/state/url.ts';

const modelOf = (link: string): ExploreModel => createDerive(() => closerLook)(decode(link));
const isCurved = (model: ExploreModel): boolean => model.found.details.family === 'curved';

/** The right answer, by the exact method and without the formulas that the judgement uses. */
function truthOf(ask: string, { exactly: { found } }: ExploreModel): Guess | null {
  const ahead = found.hits.findIndex(({ t }) => t >= 0);
  if (ask === 'points') return found.class === 'contained' ? 'all' : String(found.hits.length);
  if (ask === 'where') return found.hits[ahead]?.t ?? 'none';
  if (ask === 'first') return ahead < 0 ? 'none' : `t${ahead + 1}`;
  if (found.details.family !== 'curved' || found.details.signs.D === null) return null;
  return ['-', '0', '+'][found.details.signs.D + 1] ?? null;
}

test('every question of a link is one that is asked, and the other way round', () => {
  expect(QUESTIONS.map(({ id }) => id)).toEqual([...ASKS]);
  expect(questionOf('sign', false).id).toBe('points');
  expect(questionOf(null, true).id).toBe('points');
});

describe.each(GALLERY.map((entry) => [entry.id, entry] as const))('%s', (_, entry) => {
  const model = modelOf(entry.link);

  test('the right answer is right, every other option is not', () => {
    for (const question of QUESTIONS.filter(({ fits }) => fits(isCurved(model)))) {
      const truth = truthOf(question.id, model);
      if (truth === null) continue;
      expect(judgementOf(question, truth, model), question.id).toMatchObject({
        right: true,
        mistake: null,
      });
      for (const { id } of question.options.filter((option) => option.id !== truth)) {
        const { right, gap } = judgementOf(question, id, model);
        expect(right, `${question.id} ${id}`).toBe(false);
        expect(gap).not.toMatch(/NaN|undefined|null/);
      }
    }
  });
});

describe('the gap is in numbers, and a known mistake is named', () => {
  // Both roots are behind E: t₁ = −4.5, t₂ = −1.5.
  const behind = modelOf('#/explore?shape=cylinder&C=0,1,0&r=1.5&E=3,1,0&d=1,0,0');

  test('the root behind E', () => {
    const first = questionOf('first', true);
    expect(judgementOf(first, 't2', behind)).toEqual({
      right: false,
      gap: 't₁ = −4.5, t₂ = −1.5: no hit is visible.',
      mistake: null,
    });
    expect(judgementOf(first, 't1', behind).mistake).toMatch(/t < 0 accepted\. A ray begins at E/);
  });

  test('a mark beyond the hit, in t and in lengths', () => {
    const model = modelOf('#/explore?shape=cylinder&C=0,1,0&r=1.5&E=3,1,0&d=-2,0,0');
    expect(judgementOf(questionOf('where', true), 1, model)).toMatchObject({
      right: false,
      gap: 'The hit is at t = 0.75; your mark, at t = 1, is 0.25 beyond it: 0.5 units of length.',
    });
    expect(judgementOf(questionOf('where', true), 2.25, model).mistake).toMatch(/the far root/);
  });

  test('too many and too few points, and D', () => {
    const points = questionOf('points', true);
    expect(judgementOf(points, '0', behind).gap).toBe('There are 2 points: you said 2 too few.');
    expect(judgementOf(questionOf('sign', true), '-', behind).gap).toBe('D = 9.');
  });
});

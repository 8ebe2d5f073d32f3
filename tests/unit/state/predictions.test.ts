import { describe, expect, test } from 'vitest';
import { createDerive, type ExploreModel } from '../../../src/state/derive.ts';
import { exploreDetails } from '../../../src/state/explore-details.ts';
import { GALLERY } from '../../../src/state/gallery/index.ts';
import { ASKS } from '../../../src/state/prediction-ask.ts';
import { type Guess, judgementOf, QUESTIONS, questionOf } from '../../../src/state/predictions.ts';
import { decode } from '../../../src/state/url.ts';

const modelOf = (link: string): ExploreModel => createDerive(() => exploreDetails)(decode(link));
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
      truth: 'none',
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
  });

  test('a mark at what comes out with a mistake', () => {
    // t₁ = 1.4, t₂ = 2.6 in lengths of 2.5: A = 6.25.
    const model = modelOf('#/explore?shape=cylinder&C=0,1,0&r=1.5&E=5,1,0&d=-2.5,0,0');
    const mistakeAt = (t: number) => judgementOf(questionOf('where', true), t, model).mistake;
    expect(mistakeAt(2.6)).toMatch(/^At t = 2\.6 .* the far root/);
    expect(mistakeAt(2)).toMatch(/^At t = 2 .* −B\/2A in place of/);
    expect(mistakeAt(-1.4)).toMatch(/^At t = −1\.4 .* B in place of −B/);
    expect(mistakeAt(3.5)).toMatch(/^At t = 3\.5 .* taken for a distance/);
    expect(mistakeAt(2.3)).toBeNull();
  });

  test('a mark at the root behind E, and at one that is all there is', () => {
    const inside = modelOf('#/explore?shape=cylinder&C=0,1,0&r=1.5&E=0.5,1,0&d=-1,0,0');
    const where = questionOf('where', true);
    expect(judgementOf(where, -1, inside).mistake).toMatch(/^At t = −1 .* t < 0 accepted/);
    expect(judgementOf(where, -4.5, behind).mistake).toMatch(/^At t = −4\.5 .* t < 0 accepted/);
  });

  test('a hand need not be finer than the ray that is drawn', () => {
    const model = modelOf('#/explore?shape=cylinder&C=0,1,0&r=1.5&E=1.5,1,0&d=-1,0,0');
    const at = (t: number) => judgementOf(questionOf('where', true), t, model).right;
    expect([0, 0.05, -0.05, 0.5].map(at)).toEqual([true, true, true, false]);
  });

  test('too many and too few points, and D', () => {
    const points = questionOf('points', true);
    expect(judgementOf(points, '0', behind).gap).toBe('There are 2 points: you said 2 too few.');
    expect(judgementOf(questionOf('sign', true), '-', behind).gap).toBe('D = 9.');
  });
});

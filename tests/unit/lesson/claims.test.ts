import { describe, expect, test } from 'vitest';
import { allHold } from '../../../src/lesson/condition.ts';
import { freedomOf } from '../../../src/lesson/freedom.ts';
import type { Step } from '../../../src/lesson/lesson.ts';
import { LESSON_IDS, lessonOf } from '../../../src/lesson/lessons/index.ts';
import { type Block, type Inline, inlinesOf, quantitiesIn } from '../../../src/lesson/prose.ts';
import { quantityOf } from '../../../src/lesson/quantities.ts';
import { innerState } from '../../../src/lesson/step-state.ts';
import { createDerive, type FullModel } from '../../../src/state/derive.ts';
import { exploreDetails } from '../../../src/state/explore-details.ts';
import { update } from '../../../src/state/update.ts';
import { many } from '../many.ts';
import { holds, holdsBetween, isBetween } from './lesson-claims.ts';
import { holdsOnPage } from './page-claims.ts';

/**
 * At night also between two values that a slider has, so that roots of a range are not only met by
 * luck.
 */
const FINER = many(2);

/** What a step shows as it opens, then with each value that its free numbers can be given. */
function modelsOf(step: Step): FullModel[] {
  const start = { ...innerState(step, {}), revealed: null };
  const derive = createDerive(() => exploreDetails);
  const moved = (step.free === null ? [] : (freedomOf(step.free, start) ?? [])).flatMap((one) => {
    const [least, most] = one.range;
    const count = Math.round(((most - least) / one.step) * FINER);
    const truth = step.guess?.type === 'free' ? [step.guess.truth] : [];
    const grid = Array.from({ length: count + 1 }, (_, i) => least + (i * one.step) / FINER);
    const values = [...grid.map((x) => Number(x.toFixed(6))), ...truth];
    return values
      .filter((value) => one.allows(value, start))
      .map((value) => derive(update(start, one.action(value))));
  });
  return [derive(start), ...moved];
}

const isWords = (part: Inline): boolean =>
  part.type !== 'claims' && (part.type !== 'text' || part.text.trim() !== '');

/** Each sentence or few with the claims after it; null where nothing is claimed. */
function claimedIn(
  parts: readonly Inline[],
): { words: string; claims: readonly string[] | null }[] {
  const all: { words: string; claims: readonly string[] | null }[] = [];
  let words = '';
  let open = false;
  for (const part of parts) {
    if (part.type === 'claims') {
      all.push({ words: words.trim(), claims: part.claims });
      words = '';
      open = false;
    } else if (isWords(part)) {
      words += part.type === 'text' ? part.text : '…';
      open = true;
    }
  }
  return open ? [...all, { words: words.trim(), claims: null }] : all;
}

const textsOf = (block: Block): (readonly Inline[])[] =>
  block.type === 'paragraph' ? [block.inside] : block.type === 'list' ? [...block.items] : [];

/** A sentence that asks or tells to do something can say "asks" in the place of a claim. */
const ASKS = /\?$|^(Move|Let|Turn|Read|Put|Look|Compare|Lift|Work out|Find)\b/;

for (const id of LESSON_IDS) {
  const read = lessonOf(id);
  if (!read) throw new Error(`no lesson ${id}`);
  describe(`lesson ${id}`, () => {
    test('is read without a fault', () => expect(read.problems).toEqual([]));

    test.each(read.lesson.steps.map((step) => [step.title, step] as const))(
      '%s',
      async (_, step) => {
        const models = modelsOf(step);
        const [first] = models;
        if (!first) throw new Error('nothing is shown');
        const state = innerState(step, {});
        const onPage = { state, lesson: read.lesson };
        for (const block of [...step.text, ...step.question, ...step.answer]) {
          const shown = models.filter((model) => allHold(block.when, model));
          expect(shown.length, `never shown: ${JSON.stringify(block)}`).toBeGreaterThan(0);
          // What another page shows is looked up there, by a test in the browser.
          const names = state.page === 'explore' ? quantitiesIn([block]) : [];
          for (const quantity of names.filter((name) => name !== 'slider')) {
            const missing = shown.filter((model) => quantityOf(model, quantity) === null);
            expect(missing.length, `{${quantity}} does not exist`).toBe(0);
          }
          for (const { words, claims } of textsOf(block).flatMap(claimedIn)) {
            expect(claims, `nothing is claimed of "${words}"`).not.toBeNull();
            expect(claims?.length, `an empty claim of "${words}"`).toBeGreaterThan(0);
            for (const claim of claims ?? []) {
              const ofPage = await holdsOnPage(claim, onPage);
              if (ofPage !== null) expect(ofPage, `${claim}: "${words}"`).toBe(true);
              else if (claim === 'asks') expect(words).toMatch(ASKS);
              else if (isBetween(claim)) {
                const others = shown.filter((model) => model !== first);
                const right = others.filter(
                  (model) =>
                    JSON.stringify([model.shape, model.ray]) ===
                      JSON.stringify([first.shape, first.ray]) || holdsBetween(claim, first, model),
                );
                expect(others.length).toBeGreaterThan(1);
                expect(right.length, `${claim}: "${words}"`).toBe(others.length);
              } else {
                const wrong = shown.find((model) => !holds(claim, model));
                const where = wrong && JSON.stringify([wrong.shape, wrong.ray, wrong.found.class]);
                expect(where, `${claim}: "${words}"`).toBeUndefined();
              }
            }
          }
        }
      },
    );

    test('every step says something', () => {
      for (const { text, question } of read.lesson.steps) {
        expect(inlinesOf([...text, ...question]).length).toBeGreaterThan(0);
      }
    });
  });
}

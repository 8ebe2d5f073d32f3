import { describe, expect, test } from 'vitest';
import { EXERCISES } from '../../src/check/exercises/index.ts';
import { ALL_MISCONCEPTIONS, MISCONCEPTIONS } from '../../src/check/misconceptions/index.ts';
import { family } from '../../src/math/families/define.ts';
import { FAMILIES, WRITTEN_FAMILIES } from '../../src/math/families.ts';
import { intersect } from '../../src/math/index.ts';
import { PRESETS } from '../../src/scene/presets/index.ts';
import { GALLERY } from '../../src/state/gallery/index.ts';
import { shortest } from '../../src/text/format.ts';
import { OBLIQUE } from './toy-example.ts';
import { laterRoot } from './toy-exercise.ts';
import { level } from './toy-family.ts';
import { aForgottenInD } from './toy-misconception.ts';
import { column } from './toy-scene.ts';

/*
 * "An exercise, a family, a scene, a misconception, an example is one new value and one word in an
 * index": one of each that exists in this test only is put into its list, before what derives from
 * the lists is loaded.
 */

const put = <T>(list: readonly T[], entry: T): void => {
  (list as T[]).push(entry);
};
put(EXERCISES, laterRoot);
const added = family(level);
for (const list of [WRITTEN_FAMILIES(), FAMILIES()]) put(list, added);
put(PRESETS, column);
put(MISCONCEPTIONS, aForgottenInD);
// In the same file, made of the list above.
put(ALL_MISCONCEPTIONS, aForgottenInD);
for (const entry of OBLIQUE) put(GALLERY, entry);

describe('an exercise', async () => {
  const { derivationFor } = await import('../../src/check/compose.ts');
  const { judge } = await import('../../src/check/judge.ts');
  const { plan, question } = await import('../../src/check/session.ts');
  const { LATEST_SET } = await import('../../src/check/sets.ts');
  const { readSettings } = await import('../../src/pages/check/settings.ts');

  const placeIn = (seed: number): number =>
    plan(seed, LATEST_SET).findIndex(({ exercise }) => exercise === laterRoot.id);

  test('comes up in a session of a new seed, not in one of an old link', () => {
    const place = placeIn(41);
    expect(place).toBeGreaterThanOrEqual(0);
    expect(plan(41).map(({ exercise }) => exercise)).not.toContain(laterRoot.id);
    expect(readSettings({ set: LATEST_SET, question: String(place + 1) }).problems).toEqual([]);
  });

  test('is posed and graded, and a known mistake is named', () => {
    for (let seed = 1; seed <= 20; seed++) {
      const posed = question(seed, placeIn(seed), LATEST_SET);
      const { hits } = intersect(posed.draft.shape, posed.draft.ray, 'exact');
      const judged = (t: number | undefined) =>
        judge(derivationFor(posed), { t2: shortest(t ?? Number.NaN) });
      expect(judged(hits[1]?.t).verdict).toBe('correct');
      for (const { misconception, answers } of posed.suspects) {
        const { verdict, causes } = judged(answers.t2 as number);
        expect([verdict, causes.map(({ id }) => id)]).toEqual(['wrong', [misconception.id]]);
      }
    }
  });
});

describe('a family', async () => {
  const { casesFor } = await import('../../src/check/program/cases.ts');
  const { qualityOf } = await import('../../src/lab/quality.ts');
  const { batchesOf } = await import('../../src/lab/plan.ts');
  const { METHODS } = await import('../../src/math/index.ts');
  const { findFamily } = await import('../../src/math/families.ts');
  const { readAccuracy } = await import('../../src/state/accuracy/settings.ts');

  test('is opened by a link, and every method is judged on it', () => {
    expect(findFamily(level.id)).toBe(added);
    expect(readAccuracy({ family: level.id }).problems).toEqual([]);
    const batches = batchesOf(added, { seed: 3, shapes: 4, count: 25 });
    for (const method of METHODS) expect(qualityOf(method, batches).rays).toBe(100);
    const exact = METHODS.find(({ id }) => id === 'exact');
    expect(exact && qualityOf(exact, batches).judged.right).toBe(100);
  });

  test('is among the cases that programs are tried on', () => {
    const groups = casesFor(['cone'], 1).flatMap(({ family, group }) =>
      family === level.title ? [group] : [],
    );
    expect(new Set(groups)).toEqual(new Set([level.hardness]));
  });
});

describe('a scene', async () => {
  const { pictureSettings } = await import('../../src/state/picture/settings.ts');
  const { planEffects } = await import('../../src/scene/effects/plan.ts');
  const { validateScene } = await import('../../src/scene/validate.ts');
  const { picture } = await import('./tracer/tracing.ts');

  test('is opened by its name, in order, and traced with what it calls for', async () => {
    const { scene } = pictureSettings({ scene: column.id });
    expect(scene).toEqual(column.scene);
    expect(validateScene(JSON.parse(JSON.stringify(scene)))).toEqual(scene);
    const { ledger } = await picture(scene);
    const called = planEffects(scene).filter(({ needed }) => needed);
    expect(called.map(({ id }) => id)).toContain('shadow');
    expect(Object.keys(ledger.effects).sort()).toEqual(called.map(({ id }) => id).sort());
  });
});

describe('a misconception', async () => {
  const { derivationFor } = await import('../../src/check/compose.ts');
  const { courseOf } = await import('../../src/check/course.ts');
  const { judge } = await import('../../src/check/judge.ts');
  const { checkOwn } = await import('../../src/check/own-numbers.ts');
  const { plan, question } = await import('../../src/check/session.ts');
  const { work } = await import('../../src/check/work.ts');
  const { coefficients } = await import('../../src/math/index.ts');

  test('is named to whoever makes it, in a question and in own numbers', () => {
    const roots = plan(41).findIndex(({ exercise }) => exercise === 'roots');
    let named = 0;
    for (let seed = 1; seed <= 10; seed++) {
      const posed = question(seed, roots);
      const { shape, ray } = posed.draft;
      const edited = aForgottenInD.edit(courseOf(shape));
      if (!edited) throw new Error(`${shape.kind} has a formula for D`);
      // The mistake by hand.
      const { A, B, C } = coefficients(shape, ray);
      const D = B * B - 4 * C;
      // With A = 1 it shows nothing, with A = 4 it gives what B² − AC gives.
      if (A === 1 || A === 4 || D <= 0) continue;
      const both = [-1, 1].map((sign) => (-B + sign * Math.sqrt(D)) / (2 * A));
      const [t1 = 0, t2 = 0] = both.sort((a, b) => a - b);
      const answers = work(edited, posed.draft);
      expect([answers.t1, answers.t2]).toEqual([expect.closeTo(t1, 9), expect.closeTo(t2, 9)]);

      const typed = { t1: shortest(t1), t2: shortest(t2) };
      for (const { causes } of [
        judge(derivationFor(posed), typed),
        checkOwn({ shape, ray }, typed),
      ])
        expect(causes.map(({ id }) => id)).toEqual([aForgottenInD.id]);
      named++;
    }
    expect(named).toBeGreaterThan(2);
  });
});

describe('an example of the gallery', async () => {
  const { exploreDetails } = await import('../../src/state/explore-details.ts');
  const { createDerive } = await import('../../src/state/derive.ts');
  const { exampleOf, provideExamples, titleOf } = await import('../../src/state/example.ts');
  const { decode } = await import('../../src/state/url.ts');
  const { holds, subjectOf } = await import('./state/gallery-claims.ts');

  test('is opened by its link, comes last, and its words hold', () => {
    provideExamples(GALLERY);
    for (const entry of OBLIQUE) {
      const state = decode(entry.link);
      const shown = exampleOf(state);
      expect(shown).toEqual({ entry, number: GALLERY.length, of: GALLERY.length, changed: false });
      expect(shown && titleOf(shown)).toBe(entry.title);
      expect(createDerive(() => exploreDetails)(state).found.class).toBe('two');
      const claims = entry.told.flatMap(([, ...all]) => all);
      expect(claims.filter((claim) => !holds(claim, subjectOf(entry, state.method)))).toEqual([]);
    }
  });
});

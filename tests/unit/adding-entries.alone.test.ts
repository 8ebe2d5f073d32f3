import { describe, expect, test } from 'vitest';
import { EXERCISES } from '../../src/check/exercises/index.ts';
import { FAMILIES } from '../../src/math/families.ts';
import { intersect } from '../../src/math/index.ts';
import { PRESETS } from '../../src/scene/presets/index.ts';
import { shortest } from '../../src/text/format.ts';
import { laterRoot } from './toy-exercise.ts';
import { level } from './toy-family.ts';
import { column } from './toy-scene.ts';

/*
 * "An exercise, a family, a scene is one new file and one word in an index": one of each that
 * exists in this test only is put into its list, before what derives from the lists is loaded.
 */

const put = <T>(list: readonly T[], entry: T): void => {
  (list as T[]).push(entry);
};
put(EXERCISES, laterRoot);
put(FAMILIES, level);
put(PRESETS, column);

describe('an exercise', async () => {
  const { derivationFor } = await import('../../src/check/compose.ts');
  const { judge } = await import('../../src/check/judge.ts');
  const { plan, question } = await import('../../src/check/session.ts');
  const { LATEST_SET } = await import('../../src/check/sets.ts');
  const { readSettings } = await import('../../src/pages/check/settings.ts');

  const place = plan(41, LATEST_SET).findIndex(({ exercise }) => exercise === laterRoot.id);

  test('comes up in a session of a new seed, not in one of an old link', () => {
    expect(place).toBeGreaterThan(0);
    expect(plan(41).map(({ exercise }) => exercise)).not.toContain(laterRoot.id);
    expect(readSettings({ set: LATEST_SET, question: String(place + 1) }).problems).toEqual([]);
  });

  test('is posed and graded, and a known mistake is named', () => {
    for (let seed = 1; seed <= 20; seed++) {
      const posed = question(seed, place, LATEST_SET);
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
  const { qualityOf } = await import('../../src/lab/quality.ts');
  const { batchesOf } = await import('../../src/lab/plan.ts');
  const { METHODS } = await import('../../src/math/index.ts');
  const { findFamily } = await import('../../src/math/families.ts');
  const { readAccuracy } = await import('../../src/state/accuracy/settings.ts');

  test('is opened by a link, and every method is judged on it', () => {
    expect(findFamily(level.id)).toBe(level);
    expect(readAccuracy({ family: level.id }).problems).toEqual([]);
    const batches = batchesOf(level, { seed: 3, shapes: 4, count: 25 });
    for (const method of METHODS) expect(qualityOf(method, batches).rays).toBe(100);
    const exact = METHODS.find(({ id }) => id === 'exact');
    expect(exact && qualityOf(exact, batches).judged.right).toBe(100);
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

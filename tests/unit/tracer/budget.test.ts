import { describe, expect, test } from 'vitest';
import type { EffectId } from '../../../src/scene/effects/index.ts';
import { findPreset, PRESETS } from '../../../src/scene/presets/index.ts';
import { TRIED } from '../../../src/state/picture/budget.ts';
import { wholeOf } from '../../../src/state/picture/comparison.ts';
import {
  type Choice,
  differencesFrom,
  searchBudget,
  type Wanted,
} from '../../../src/tracer/budget.ts';
import { totalOf } from '../../../src/tracer/ledger.ts';
import type { Ledger, TraceSettings } from '../../../src/tracer/types.ts';
import { picture, TINY } from './tracing.ts';

const WHOLE: TraceSettings = { ...wholeOf(TINY), film: true };
const sceneOf = (id: string) => {
  const scene = findPreset(id)?.scene;
  if (!scene) throw new Error(id);
  return scene;
};

async function search(id: string, levels: number, beyond = 0) {
  const scene = sceneOf(id);
  const run = searchBudget(scene, WHOLE);
  const traced = async (settings: TraceSettings) => picture(scene, settings);
  const whole = await traced(WHOLE);
  const film = whole.film ?? new Float64Array(0);
  const block = new Uint8Array(film.length / 3);
  const kept: { settings: TraceSettings; questions: number }[] = [];
  const judged = async (settings: TraceSettings) => {
    const { film: own, ledger } = await traced(settings);
    const differences = differencesFrom(film, { levels, beyond });
    differences.look(own ?? film, block);
    const { questions } = totalOf(ledger);
    const keeps = !differences.breaks();
    if (keeps) kept.push({ settings, questions });
    return { keeps, ledger, questions, differences };
  };
  const asked: (Wanted & { questions: number; keeps: boolean; ledger: Ledger })[] = [];
  let turn = run.next();
  while (!turn.done) {
    const outcome = await judged(turn.value.settings);
    asked.push({ ...turn.value, ...outcome });
    turn = run.next(outcome);
  }
  const choice: Choice = turn.value;
  return {
    choice,
    kept,
    asked,
    found: await judged(choice.settings),
    whole: totalOf(whole.ledger),
  };
}

describe('the cheapest picture within a budget', () => {
  test.each([
    ['cone-on-mirror', 0.5, 0],
    ['cone-on-mirror', 25.5, 0.05],
    ['facing-mirrors', 0.5, 0],
    ['facing-mirrors', 12.75, 0.01],
    ['coloured-light', 255, 0],
    ['plain', 0.5, 0],
  ])(
    '%s, %f levels but for %f: it keeps it, and none that was traced is cheaper',
    async (...of) => {
      const { choice, kept, found, whole } = await search(...of);
      expect(found.keeps).toBe(true);
      expect(found.differences.worst() > of[1]).toBe(found.differences.over() > 0);
      const same = kept.filter(({ settings }) => settings.method === WHOLE.method);
      expect(found.questions).toBe(Math.min(...same.map(({ questions }) => questions)));
      expect(found.questions).toBeLessThanOrEqual(whole.questions);
      for (const { method, ...rest } of choice.methods) {
        expect(rest).toEqual({ ...choice.settings, method: undefined } satisfies object);
        expect(method).not.toBe(WHOLE.method);
      }
    },
  );

  test.each(['cone-on-mirror', 'facing-mirrors', 'glass'])(
    '%s: one effect at a time, then bounces, then methods, and nothing else',
    async (id) => {
      const { asked } = await search(id, 12.75, 0.05);
      const steps = [...new Set(asked.map(({ step }) => step))];
      expect(steps).toEqual(['whole', ...TRIED.map(([step]) => step)]);
      const effects = asked.filter(({ step }) => step === 'whole' || step === 'effects');
      let best = effects[0];
      const tried = new Set<string>();
      for (const one of effects.slice(1)) {
        const before = Object.keys(best?.settings.forced ?? {});
        const left = Object.keys(one.settings.forced).filter((key) => !before.includes(key));
        expect(left).toHaveLength(1);
        const without = (key: string): string => [...before, key].sort().join();
        const dearer = Object.entries(best?.ledger.effects ?? {}).filter(
          ([key, { questions }]) =>
            questions > (best?.ledger.effects[left[0] as EffectId]?.questions ?? 0) &&
            !tried.has(without(key)),
        );
        expect(dearer).toEqual([]);
        tried.add(without(left[0] ?? ''));
        if (one.keeps && one.questions < (best?.questions ?? 0)) best = one;
      }
      for (const { settings } of asked) {
        const { forced, bounces, method, ...others } = settings;
        const { forced: _, bounces: __, method: ___, ...same } = WHOLE;
        expect(others).toEqual(same);
      }
    },
  );

  test('where anything may differ camera rays are left, with nothing to leave all', async () => {
    const { found } = await search('cone-on-mirror', 255);
    expect(totalOf(found.ledger).rays).toBe(TINY.width * TINY.height);
    const { choice, found: plain, whole } = await search('plain', 0.5);
    expect(choice.settings).toEqual(WHOLE);
    expect(plain.questions).toBe(whole.questions);
  });

  test('mirrors that face each other need fewer bounces the more may differ', async () => {
    const depths = await Promise.all(
      [0.5, 5.1, 25.5].map(async (levels) => (await search('facing-mirrors', levels)).choice),
    );
    const bounces = depths.map(({ settings }) => settings.bounces ?? 64);
    expect(bounces[1]).toBeLessThan(bounces[0] ?? 0);
    expect(bounces[2]).toBeLessThan(bounces[1] ?? 0);
  });
});

test.each(PRESETS)('$id: differences are those of the film, each pixel once', async ({ scene }) => {
  const [whole, less] = await Promise.all([
    picture(scene, WHOLE),
    picture(scene, { ...WHOLE, bounces: 0, forced: { shadow: 'off' } }),
  ]);
  const [a, b] = [whole.film ?? new Float64Array(0), less.film ?? new Float64Array(0)];
  const pixels = a.length / 3;
  const differences = differencesFrom(a, { levels: 1, beyond: 0 });
  // Half of the pixels first, then all: none is counted twice.
  const half = new Uint8Array(pixels).map((_, i) => i % 2);
  differences.look(b, half);
  expect(differences.seen()).toBe(Math.ceil(pixels / 2));
  differences.look(b, new Uint8Array(pixels));
  expect(differences.seen()).toBe(pixels);
  expect(differences.counts().reduce((sum, n) => sum + n, 0)).toBe(pixels);
  // Bytes are at most half a level off on either side.
  let most = 0;
  for (let k = 0; k < whole.rgba.length; k++) {
    most = Math.max(most, Math.abs((whole.rgba[k] ?? 0) - (less.rgba[k] ?? 0)));
  }
  expect(Math.abs(differences.worst() - most)).toBeLessThanOrEqual(1);
});

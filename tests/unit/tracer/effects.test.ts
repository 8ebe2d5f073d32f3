import { afterEach, describe, expect, test, vi } from 'vitest';
import type { EffectBody } from '../../../src/scene/effects/body.ts';
import { EFFECTS, type EffectId } from '../../../src/scene/effects/index.ts';
import { planEffects } from '../../../src/scene/effects/plan.ts';
import { findPreset, PRESETS } from '../../../src/scene/presets/index.ts';
import type { Scene } from '../../../src/scene/types.ts';
import type { Ledger } from '../../../src/tracer/types.ts';
import { picture, samePicture } from './tracing.ts';

const presetOf = (id: string): Scene => {
  const found = findPreset(id);
  if (!found) throw new Error(`no preset ${id}`);
  return found.scene;
};

const needs = (scene: Scene, id: EffectId): boolean =>
  planEffects(scene).some((effect) => effect.id === id && effect.needed);

afterEach(() => {
  vi.restoreAllMocks();
});

/** Every preset with every effect that it does not call for, and those that it does. */
const cases = EFFECTS.flatMap(({ id }) =>
  PRESETS.map(({ id: preset, scene }) => ({ id, preset, scene, needed: needs(scene, id) })),
);

test('no effect is called for by every preset; one calls for all that are, one for none', () => {
  const called = (preset: string): string[] =>
    cases.filter((one) => one.preset === preset && one.needed).map(({ id }) => id);
  const calls = cases.filter(({ needed }) => needed).map(({ id }) => id);
  const most = PRESETS.map(({ id }) => called(id)).reduce((a, b) => (a.length < b.length ? b : a));
  expect(new Set(most)).toEqual(new Set(calls));
  expect(PRESETS.filter(({ id }) => called(id).length === 0)).not.toEqual([]);
});

describe.each(cases.filter(({ needed }) => !needed))('$preset needs no $id', ({ id, scene }) => {
  test('its code is not loaded, it fires no ray, and forced on it changes no bit', async () => {
    const loads = new Map(EFFECTS.map((effect) => [effect.id, vi.spyOn(effect, 'load')]));
    const without = await picture(scene);
    expect(loads.get(id)).not.toHaveBeenCalled();
    expect(without.ledger.effects[id]).toBeUndefined();
    expect(Object.keys(without.ledger.effects).sort()).toEqual(
      planEffects(scene)
        .filter(({ needed }) => needed)
        .map((effect) => effect.id)
        .sort(),
    );
    const forced = await picture(scene, { forced: { [id]: 'on' } });
    expect(loads.get(id)).toHaveBeenCalledOnce();
    expect(forced.ledger.effects[id]).toBeDefined();
    expect([...forced.rgba]).toEqual([...without.rgba]);
    expect([...forced.surface]).toEqual([...without.surface]);
    expect([...forced.t]).toEqual([...without.t]);
  });
});

describe.each(cases.filter(({ needed }) => needed))('$preset needs $id', ({ id, scene }) => {
  test('forced off, the picture is another one; forced on it stays', async () => {
    const needed = await samePicture(scene);
    const off = await picture(scene, { forced: { [id]: 'off' } });
    expect(off.ledger.effects[id]).toBeUndefined();
    expect([...off.rgba]).not.toEqual([...needed.rgba]);
    const on = await picture(scene, { forced: { [id]: 'on' } });
    expect([...on.rgba]).toEqual([...needed.rgba]);
    expect(on.ledger.kinds).toEqual(needed.ledger.kinds);
  });
});

describe('what an effect costs if it is forced on where nothing needs it', () => {
  const plain = presetOf('plain');
  const cost = async (id: EffectId): Promise<Ledger> =>
    (await picture(plain, { forced: { [id]: 'on' } })).ledger;

  test('nothing but camera rays without it', async () => {
    const { kinds, effects } = (await picture(plain)).ledger;
    const rays = Object.values(kinds).map((kind) => kind.rays);
    expect(rays).toEqual([48 * 27, 0, 0, 0]);
    expect(effects).toEqual({});
  });

  test('heights: the second root', async () => {
    expect((await cost('heights')).effects.heights).toMatchObject({ rays: 0, solves: 48 * 27 });
  });
});

test.each(EFFECTS)(
  '$id: its code runs where it is called for, and its rays are counted',
  async (effect) => {
    const { id } = effect;
    const body: EffectBody = await effect.load();
    // A body with values of fields is another object at each load.
    vi.spyOn(effect, 'load').mockResolvedValue(body as never);
    const run = body.at === 'roots' ? vi.spyOn(body, 'choose') : vi.spyOn(body, 'run');
    await picture(presetOf('plain'));
    expect(run).not.toHaveBeenCalled();
    const calling = cases.find((one) => one.id === id && one.needed);
    expect(calling, 'a scene that calls for it').toBeDefined();
    const { camera, kinds, effects } = (await picture(calling?.scene ?? presetOf('plain'))).ledger;
    expect(run).toHaveBeenCalled();
    const sum = (all: readonly { readonly rays: number }[]): number =>
      all.reduce((rays, one) => rays + one.rays, 0);
    expect(sum([camera, ...Object.values(effects)])).toBe(sum(Object.values(kinds)));
    const { rays = 0, questions = 0 } = effects[id] ?? {};
    if (rays > 0) expect(questions).toBeGreaterThan(0);
  },
);

describe('the ledger', () => {
  test('take the mirror away, and the reflected rays and what they cost are gone', async () => {
    const scene = presetOf('cone-on-mirror');
    const without = { ...scene, things: scene.things.filter(({ id }) => id !== 'mirror') };
    const before = (await picture(scene)).ledger;
    const after = (await picture(without)).ledger;
    expect(before.effects.reflection?.rays).toBeGreaterThan(200);
    expect(before.effects.reflection?.solves).toBeGreaterThan(200);
    expect(after.effects.reflection).toBeUndefined();
    expect(planEffects(without).find(({ id }) => id === 'reflection')?.reason).toBe(
      'no material is a mirror',
    );
  });

  test('rays are counted by kind and by cause, and the sums agree', async () => {
    const { ledger } = await picture(presetOf('everything'));
    const { kinds, effects } = ledger;
    expect(kinds.camera.rays).toBe(48 * 27);
    expect(ledger.camera.rays).toBe(kinds.camera.rays);
    const toLights = ['shadow', 'soft-shadow', 'coloured-shadow'] as const;
    expect(toLights.reduce((sum, id) => sum + (effects[id]?.rays ?? 0), 0)).toBe(kinds.shadow.rays);
    expect((effects.reflection?.rays ?? 0) + (effects.refraction?.rays ?? 0)).toBe(
      kinds.reflected.rays + kinds.refracted.rays,
    );
    expect(ledger.saved).toBeGreaterThan(0);
  });

  test('a shadow ray works out fewer roots than it asks questions', async () => {
    const { ledger } = await picture(presetOf('shadows'));
    const { questions = 0, solves = 0, rays = 0 } = ledger.effects.shadow ?? {};
    expect(solves).toBeLessThan(questions / 3);
    expect(solves).toBeLessThan(rays);
  });

  test('only glass and mirrors are asked: a ball that is neither fires no such ray', async () => {
    const scene = presetOf('mirror');
    const { ledger, surface } = await picture(scene);
    const onMirror = surface.filter((k) => k === 1).length;
    expect(ledger.kinds.reflected.rays).toBe(onMirror);
  });

  test('time goes to the effect that took it', async () => {
    let now = 0;
    const { prepareTracer } = await import('../../../src/tracer/prepare.ts');
    const { TINY } = await import('./tracing.ts');
    // A clock that goes on by one at each look: every part that is timed gets some, and all
    // together not more than there was.
    const tracer = await prepareTracer(presetOf('everything'), TINY, () => ++now);
    const { ledger } = tracer.trace({ y0: 0, y1: 27, step: 1, refines: false });
    const times = [ledger.camera, ...Object.values(ledger.effects)].map(({ ms }) => ms);
    expect(times.every((ms) => ms > 0)).toBe(true);
    expect(times.reduce((a, b) => a + b)).toBeLessThanOrEqual(now);
  });
});

test('soft shadows forced off become hard ones, not none', async () => {
  const scene = presetOf('soft-light');
  const off = await picture(scene, { forced: { 'soft-shadow': 'off' } });
  expect(off.ledger.effects.shadow?.rays).toBeGreaterThan(0);
  const [light] = scene.lights;
  if (light?.light !== 'sphere') throw new Error('the preset has another light');
  const { radius: _, ...rest } = light;
  const hard = await picture({ ...scene, lights: [{ ...rest, light: 'point' }] });
  expect([...off.rgba]).toEqual([...hard.rgba]);
});

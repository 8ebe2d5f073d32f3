import { describe, expect, test, vi } from 'vitest';
import { pictureActions } from '../../src/pages/picture/page-actions.ts';
import { lightForm } from '../../src/panels/picture-light.ts';
import { thingForm } from '../../src/panels/picture-thing.ts';
import { worldForm } from '../../src/panels/picture-world.ts';
import type { MediumBody, WorldLight } from '../../src/scene/effects/body.ts';
import { fieldRows } from '../../src/scene/effects/declared.ts';
import { readerOf, valuesOf, withValue } from '../../src/scene/effects/fields.ts';
import { EFFECTS } from '../../src/scene/effects/index.ts';
import { planEffects, shownScene } from '../../src/scene/effects/plan.ts';
import { sceneFromJson, sceneToJson } from '../../src/scene/json.ts';
import { material } from '../../src/scene/presets/define.ts';
import { findPreset, PRESETS } from '../../src/scene/presets/index.ts';
import { plain } from '../../src/scene/presets/plain.ts';
import type { Scene } from '../../src/scene/types.ts';
import { validateScene } from '../../src/scene/validate.ts';
import { asLight, LIGHT_KINDS, refusalOf } from '../../src/state/picture/edits.ts';
import { ledgerModel } from '../../src/state/picture/ledger.ts';
import { sceneFromText, textOfScene } from '../../src/state/picture/scene-link.ts';
import { pictureSettings } from '../../src/state/picture/settings.ts';
import { INITIAL } from '../../src/state/state.ts';
import { createStore } from '../../src/state/store.ts';
import { decode, encode } from '../../src/state/url.ts';
import { level, linear } from '../../src/tracer/colour.ts';
import { tracerOf } from '../../src/tracer/prepare.ts';
import { brightest, MOST_BOUNCES } from '../../src/tracer/weight.ts';
import { OLD_SCENES } from './state/picture/old-scenes.ts';
import { air, fog } from './toy-fog.ts';
import { aura, glow, lamp } from './toy-glow.ts';
import { picture, TINY, tracerFor } from './tracer/tracing.ts';

/*
 * "A new effect is one descriptor, its body and one word": two effects that exist in this test only
 * are put into the list. Fog dims and adds light; glow adds light, more than any lamp has.
 */

/** Forms hold custom elements, which are defined when they are imported. */
vi.hoisted(() => {
  Object.assign(globalThis, { HTMLElement: class {}, customElements: { define: () => undefined } });
});

vi.mock('../../src/scene/effects/index.ts', async (original) => {
  const { EFFECTS: own } = await original<{ EFFECTS: readonly unknown[] }>();
  const [toyFog, toyGlow] = await Promise.all([import('./toy-fog.ts'), import('./toy-glow.ts')]);
  return { EFFECTS: [...own, toyFog.fog, toyGlow.glow] };
});

const COLOUR = '#40a0c0';
const foggy = (scene: Scene, density = 0.15): Scene => ({
  ...scene,
  effects: { ...scene.effects, fog: { density, colour: COLOUR } },
});
/** Toys have ids that no type knows. */
const FOG = fog.id as never as (typeof EFFECTS)[number]['id'];
const force = (how: 'on' | 'off') => ({ forced: { [FOG]: how } });

test('both are in the list, and every effect’s fields are sound', () => {
  expect(EFFECTS.map(({ id }) => id as string)).toEqual(expect.arrayContaining(['fog', 'glow']));
  const labels: string[] = [];
  for (const { id, fields } of EFFECTS) {
    const places = fields.map(({ place }: { place: string }) => place);
    expect(new Set(places).size, id).toBe(places.length);
  }
  for (const place of ['scene', 'material', 'light'] as const) {
    for (const { set, key, field } of fieldRows(place, {})) {
      expect(readerOf(field)(field.default, key)).toBe(field.default);
      labels.push(`${set.place} ${field.label}`);
      if (field.type !== 'number') continue;
      expect(field.slider[0]).toBeGreaterThanOrEqual(field.range[0]);
      expect(field.slider[1]).toBeLessThanOrEqual(field.range[1]);
    }
  }
  expect(new Set(labels).size).toBe(labels.length);
});

describe('a scene file', () => {
  test('without fields has the defaults, and says no more than before', () => {
    for (const { scene } of PRESETS) {
      const owners = [scene, ...scene.lights, ...scene.things.map(({ material }) => material)];
      const own = owners.some(({ effects }) => effects);
      if (!own) expect(sceneToJson(validateScene(scene))).not.toContain('effects');
      expect(sceneToJson(validateScene(scene))).not.toContain('fog');
      expect(valuesOf(air, validateScene(scene))).toEqual({ density: 0, colour: '#c8ccd0' });
    }
  });

  test('may set one field and leave out another', () => {
    const scene = validateScene({ ...plain.scene, effects: { fog: { density: 0.5 } } });
    expect(valuesOf(air, scene)).toEqual({ density: 0.5, colour: '#c8ccd0' });
    expect(sceneFromJson(sceneToJson(scene))).toEqual(scene);
  });

  const [ball] = plain.scene.things;
  const [sun] = plain.scene.lights;
  test.each<[object, string]>([
    [
      { effects: { fog: { density: -1 } } },
      'effects.fog.density must be a number from 0 to 1000, got -1',
    ],
    [
      { effects: { fog: { density: '1' } } },
      "effects.fog.density must be a number from 0 to 1000, got '1'",
    ],
    [
      { effects: { fog: { colour: 'grey' } } },
      "effects.fog.colour must be a colour like '#8a5cc2', got 'grey'",
    ],
    [{ effects: { fog: { height: 1 } } }, "'height' means nothing in effects.fog"],
    [{ effects: { smoke: {} } }, "'smoke' means nothing in effects"],
    [{ effects: { glow: {} } }, "'glow' means nothing in effects"],
    [{ effects: 3 }, 'effects must be an object, got 3'],
    [
      {
        things: [
          { ...ball, material: { ...ball?.material, effects: { glow: { power: Number.NaN } } } },
        ],
      },
      'things[0].material.effects.glow.power must be a number from 0 to 1000000, got NaN',
    ],
    [
      { lights: [{ ...sun, effects: { glow: { feeds: 'fog' } } }] },
      "lights[0].effects.glow.feeds must be nothing, glow, got 'fog'",
    ],
  ])('%j is refused', (change, message) => {
    const scene = { ...plain.scene, ...change } as Scene;
    expect(() => validateScene(scene)).toThrow(message);
    // A form says it beside the field, without the path.
    expect(refusalOf(scene)).toBe(message.replace(/^\S*\.(?=\w+ must)/, ''));
  });

  test.each(OLD_SCENES)('$scene.title: an old link opens and stays as it was', (old) => {
    expect(sceneFromText(old.link)).toEqual(old.scene);
    expect(textOfScene(old.scene)).toBe(old.link);
  });
});

/** Everything that a form draws: templates within templates, values and handlers. */
function parts(form: unknown): unknown[] {
  if (Array.isArray(form)) return form.flatMap(parts);
  const values = (form as { values?: unknown[] } | null)?.values;
  return values ? [form, ...values.flatMap(parts)] : [form];
}

/** The control of that name, and its handler. */
function control(form: unknown, label: string) {
  const found = parts(form).find((one) =>
    (one as { values?: unknown[] }).values?.includes(label),
  ) as { values: unknown[] } | undefined;
  if (!found) throw new Error(`no ${label}`);
  const handler = found.values.find((value) => typeof value === 'function') as (e: unknown) => void;
  return { values: found.values, handler };
}

describe('the editor', () => {
  const onPage = () => {
    const store = createStore({ ...INITIAL, page: 'picture' });
    const now = () => pictureSettings(store.get().settings.picture).scene;
    const tools = pictureActions(store.dispatch);
    tools.scene(() => plain.scene);
    return { store, now, change: tools.scene };
  };
  const nowhere = () => {};

  test('shows each field with its default, in the form of what it belongs to', () => {
    const { scene } = plain;
    const [thing] = scene.things;
    const [light] = scene.lights;
    if (!thing || !light) throw new Error('an empty scene');
    const rows = fieldRows('scene', scene).filter(({ set }) => set === air);
    expect(rows.map(({ key, value }) => [key, value])).toEqual([
      ['density', 0],
      ['colour', '#c8ccd0'],
    ]);
    const world = worldForm(scene, nowhere);
    expect(control(world, 'fog density in 1/length').values).toContain(0);
    expect(control(world, 'fog colour').values).toContain('#c8ccd0');
    expect(control(thingForm(scene, thing, nowhere), 'glow').values).toContain(0);
    expect(parts(lightForm(scene, light, nowhere))).toContain('feeds the glow of things');
  });

  test('sets them by actions, and the link carries them; a default leaves no trace', () => {
    const { store, now, change } = onPage();
    const form = () => worldForm(now(), change);
    control(form(), 'fog density in 1/length').handler({ detail: 0.25 });
    control(form(), 'fog colour').handler({ target: { value: COLOUR } });
    control(thingForm(now(), now().things[0] as never, change), 'glow').handler({ detail: 2 });
    control(lightForm(now(), now().lights[0] as never, change), 'glow').handler({
      target: { value: 'glow' },
    });
    const there = pictureSettings(decode(encode(store.get())).settings.picture).scene;
    expect(there).toEqual(now());
    expect(textOfScene(there)).toBe(store.get().settings.picture.scene);
    expect(there.effects).toEqual({ fog: { density: 0.25, colour: COLOUR } });
    expect(there.things[0]?.material.effects).toEqual({ glow: { power: 2 } });
    expect(there.lights[0]?.effects).toEqual({ glow: { feeds: 'glow' } });

    control(form(), 'fog density in 1/length').handler({ detail: -1 });
    expect(now()).toEqual(there);
    change((scene) => withValue(scene, air, 'density', 0));
    expect(now().effects).toEqual({ fog: { colour: COLOUR } });
    change((scene) => ({
      ...withValue(scene, air, 'colour', '#c8ccd0'),
      things: plain.scene.things,
      lights: plain.scene.lights,
    }));
    expect(store.get().settings.picture.scene).toBe('plain');
  });

  test('keeps a light’s when it becomes one of another kind', () => {
    const effects = { glow: { feeds: 'glow' } };
    for (const from of LIGHT_KINDS) {
      for (const to of LIGHT_KINDS) {
        const [sun] = plain.scene.lights;
        if (!sun) throw new Error('no light');
        const light = asLight(asLight({ ...sun, effects }, from, [0, 0, 0]), to, [0, 0, 0]);
        expect(light.effects).toEqual(effects);
        const shown = shownScene({ ...plain.scene, lights: [light] }, { 'soft-shadow': 'off' });
        expect(shown.lights[0]?.effects).toEqual(effects);
      }
    }
  });
});

describe('the picture', () => {
  test('of one ball in fog is the closed form at every pixel', async () => {
    const scene = foggy(plain.scene);
    const { rgba } = await picture(scene);
    const tracer = await tracerFor(scene);
    const { shape, material: own } = scene.things[0] as Scene['things'][number];
    const [sun] = scene.lights;
    if (shape.kind !== 'sphere' || sun?.light !== 'sun') throw new Error('another scene');
    const paint = linear(own.paint.colour);
    const mist = linear(COLOUR);
    const length = Math.hypot(...sun.towards);
    let hits = 0;
    for (let pixel = 0; pixel < TINY.width * TINY.height; pixel++) {
      const x = pixel % TINY.width;
      const [node] = tracer.record(x, (pixel - x) / TINY.width).rays;
      if (!node) throw new Error('no ray');
      const { origin, direction } = node.ray;
      const from = origin.map((e, i) => e - (shape.center[i] ?? 0));
      const half = from.reduce((sum, p, i) => sum + p * (direction[i] ?? 0), 0);
      const D = half * half - from.reduce((sum, p) => sum + p * p, -(shape.radius ** 2));
      const t = -half - Math.sqrt(D);
      // What meets nothing is infinitely far: all fog.
      const T = D >= 0 ? Math.exp(-0.15 * t) : 0;
      const normal = from.map((p, i) => (p + t * (direction[i] ?? 0)) / shape.radius);
      const cosine = normal.reduce((sum, n, i) => sum + (n * (sun.towards[i] ?? 0)) / length, 0);
      const light = scene.ambient + sun.strength * Math.max(0, cosine);
      hits += D >= 0 ? 1 : 0;
      const expected = paint.map((p, k) =>
        level((D >= 0 ? T * p * light : 0) + (1 - T) * (mist[k] ?? 0)),
      );
      expect([...rgba.subarray(4 * pixel, 4 * pixel + 3)], `pixel ${pixel}`).toEqual(expected);
    }
    expect(hits).toBeGreaterThan(100);
  });

  test.each(PRESETS)(
    '$id: without fog its code is not loaded; forced on it changes no bit',
    async ({ scene }) => {
      const load = vi.spyOn(fog, 'load');
      const without = await picture(scene);
      expect(load).not.toHaveBeenCalled();
      load.mockRestore();
      const on = await picture(scene, force('on'));
      expect(on.ledger.effects[FOG]).toBeDefined();
      expect([...on.rgba]).toEqual([...without.rgba]);
      // In fog and forced off it is the picture without it; not forced, another one.
      const off = await picture(foggy(scene), force('off'));
      expect([...off.rgba]).toEqual([...without.rgba]);
      expect(off.ledger.effects[FOG]).toBeUndefined();
      expect([...(await picture(foggy(scene))).rgba]).not.toEqual([...without.rgba]);
    },
  );

  test('does not depend on tiles, mirrors and glass included', async () => {
    const scene = foggy(findPreset('everything')?.scene as Scene);
    const { rgba } = await picture(scene);
    const tracer = await tracerFor(scene);
    const rows = Array.from({ length: TINY.height }, (_, y0) => [
      ...tracer.trace({ y0, y1: y0 + 1, step: 1, refines: false }).rgba,
    ]);
    expect(rows.flat()).toEqual([...rgba]);
  });

  test('has its line in the ledger, with what it cost', async () => {
    const scene = foggy(plain.scene);
    const settings = { ...TINY, forced: {} };
    const { ledger } = await picture(scene);
    const row = (of: Scene) => {
      const { simulated, idle } = ledgerModel(of, settings, ledger, {});
      return [...simulated, ...idle].find(({ id }) => id === FOG);
    };
    expect(row(scene)).toMatchObject({ title: 'fog', runs: true, reason: 'the air is foggy' });
    expect(row(scene)?.cost).toEqual(ledger.effects[FOG]);
    expect(row(plain.scene)).toMatchObject({ runs: false, reason: 'the air is clear' });
    expect(pictureSettings({ on: 'fog' }).forced).toEqual({ fog: 'on' });
  });
});

describe('what is not worth a ray', () => {
  /** A ball that glows 1000 times as bright as white, over a floor that is hardly a mirror. */
  const glowing: Scene = {
    ...plain.scene,
    things: [
      {
        id: 'floor',
        shape: { kind: 'plane', normal: [0, 1, 0], point: [0, -1, 0] },
        material: material('#000000', { mirror: 1e-4 }),
      },
      ...plain.scene.things.map((thing) => ({
        ...thing,
        material: withValue(thing.material, aura, 'power', 1000),
      })),
    ],
    lights: plain.scene.lights.map((light) => withValue(light, lamp, 'feeds', 'glow')),
  };

  test('is judged by the light that effects add: no visible ray is missing', async () => {
    const { rgba, ledger } = await picture(glowing);
    expect(planEffects(glowing).some(({ id, runs }) => id === (glow.id as string) && runs)).toBe(
      true,
    );
    expect(ledger.kinds.reflected.rays).toBeGreaterThan(100);
    const parts = (await tracerFor(glowing)).parts;
    const all = tracerOf(glowing, TINY, parts, () => 0, 0);
    const { rgba: whole } = all.trace({ y0: 0, y1: TINY.height, step: 1, refines: false });
    const levels = [...rgba].map((byte, k) => Math.abs(byte - (whole[k] ?? 0)));
    expect(Math.max(...levels)).toBeLessThanOrEqual(1);
  });

  test('the bound holds for as many generations as there can be', async () => {
    const values = { fog: { density: 1, colour: [2, 3, 5] }, glow: { feeds: 'glow', power: 7 } };
    const light = { colour: [0.5, 0.25, 0.5], values } as never as WorldLight;
    const world = { materials: [{ shine: 0.5, values }], lights: [light], values } as never;
    const ways = (await Promise.all([fog.load(), glow.load()])) as MediumBody[];
    const bound = brightest(world, 0.25, ways);
    for (const through of [0, 0.5, 1]) {
      // Perfect mirrors: what a ray shows at its start is what the one before it gets.
      let shown = 1;
      for (let generation = 0; generation <= MOST_BOUNCES; generation++) {
        shown = 5 * (1 - through) + through * (shown + 7 * 0.5);
      }
      expect(shown).toBeLessThanOrEqual(bound);
    }
    // Without them: what the paint and the background can bring.
    expect(brightest(world, 0.25, [])).toBe(1);
  });
});

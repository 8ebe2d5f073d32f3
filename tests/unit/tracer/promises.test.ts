import { describe, expect, test } from 'vitest';
import { EFFECTS } from '../../../src/scene/effects/index.ts';
import { findPreset, PRESETS } from '../../../src/scene/presets/index.ts';
import { surfacesOf } from '../../../src/scene/surfaces.ts';
import type { Scene } from '../../../src/scene/types.ts';
import { AGAINST, firstAgainst, otherSide } from '../../../src/state/picture/comparison.ts';
import { comparePictures } from '../../../src/tracer/compare.ts';
import { totalOf } from '../../../src/tracer/ledger.ts';
import { DEFAULT_SETTINGS, type TraceSettings } from '../../../src/tracer/types.ts';
import { samePicture } from './tracing.ts';

/* What Compare shows first is what the scene's reason promises. */

const SETTINGS: TraceSettings = { ...DEFAULT_SETTINGS, width: 72, height: 40 };
const FROM = { rule: 'from' } as const;

async function compared(id: string, text: string) {
  const preset = findPreset(id);
  const against = AGAINST.read(text);
  if (!preset || !against) throw new Error(`${id}, ${text}`);
  const [left, right] = await Promise.all([
    samePicture(preset.scene, otherSide(SETTINGS, against)),
    samePicture(preset.scene, SETTINGS),
  ]);
  return { found: comparePictures(left, right), left, right, surfaces: surfacesOf(preset.scene) };
}

describe('a scene that promises a comparison opens with one that keeps it', () => {
  test('far: float32 sees what is not there, the textbook loses the silhouettes', async () => {
    const { found } = await compared('far', firstAgainst('far', FROM, 'certified'));
    expect(found.ghosts).toBeGreaterThan(found.pixels / 3);
    const textbook = (await compared('far', 'method:textbook')).found;
    expect(textbook.holes + textbook.ghosts).toBeGreaterThan(textbook.pixels / 50);
  });

  test.each(['grazing', 'grazing.2'])('%s: a few wrong digits decide hit or miss', async (id) => {
    const { found } = await compared(id, firstAgainst(id, FROM, 'certified'));
    expect(found.holes + found.ghosts).toBeGreaterThan(found.pixels / 50);
  });

  test('hundred: boxes keep questions from being asked for the same picture', async () => {
    const text = firstAgainst('hundred.2', FROM, 'certified');
    const { found, left, right } = await compared('hundred.2', text);
    expect(found.differing).toBe(0);
    const [every, boxed] = [left, right].map(({ ledger }) => totalOf(ledger));
    expect(boxed?.rays).toBe(every?.rays);
    expect(boxed?.questions).toBeLessThan((every?.questions ?? 0) / 2);
  });

  test('facing mirrors: rays that end sooner change pixels', async () => {
    const text = firstAgainst('facing-mirrors.2', FROM, 'certified');
    const { found, left, right } = await compared('facing-mirrors.2', text);
    expect(found.differing).toBeGreaterThan(found.pixels / 50);
    expect(totalOf(left.ledger).rays).toBeLessThan(totalOf(right.ledger).rays);
  });

  test('self-intersection: a third of the pixels, by the exact method too', async () => {
    const text = firstAgainst('self-intersection', FROM, 'exact');
    const { found } = await compared('self-intersection', text);
    expect(found.differing / found.pixels).toBeCloseTo(1 / 3, 1);
    expect(found.verdicts).toBe(0);
  });

  test('two-scales: what cures the hills swallows the little shadows', async () => {
    const text = firstAgainst('two-scales', FROM, 'certified');
    const differing = async (against: string, isHill: boolean): Promise<number> => {
      const { found, right, surfaces } = await compared('two-scales', against);
      const hill = (k: number): boolean => (surfaces[right.surface[k] ?? -1]?.thing ?? 0) >= 3;
      return found.levels.reduce((n, level, k) => n + (level > 0 && hill(k) === isHill ? 1 : 0), 0);
    };
    expect(await differing('start:none', true)).toBeGreaterThan(50);
    expect(await differing(text, true)).toBe(0);
    expect(await differing(text, false)).toBeGreaterThan(20);
  });
});

const forcedOff = PRESETS.filter(({ compare }) =>
  EFFECTS.some(({ id }) => compare === `off:${id}`),
);

test.each(forcedOff)('$id: what it is compared without is seen in it', async ({ id, compare }) => {
  const { found } = await compared(id, compare ?? '');
  expect(found.differing).toBeGreaterThan(found.pixels / 100);
});

describe('what a scene says of itself', () => {
  const sceneOf = (id: string): Scene => {
    const found = PRESETS.find((one) => one.id === id)?.scene;
    if (!found) throw new Error(id);
    return found;
  };

  test('plain: camera rays are all that it takes', async () => {
    const { ledger } = await samePicture(sceneOf('plain'), SETTINGS);
    expect([ledger.effects, ledger.kinds.shadow.rays]).toEqual([{}, 0]);
  });

  test('shadows.2: shadows and nothing else', async () => {
    const { ledger } = await samePicture(sceneOf('shadows.2'), SETTINGS);
    expect(Object.keys(ledger.effects)).toEqual(['shadow']);
  });

  test('facing-mirrors.2: rays go on, and stop for what they can no longer change', async () => {
    const { ledger } = await samePicture(sceneOf('facing-mirrors.2'), SETTINGS);
    expect([ledger.saved > 0, ledger.cut]).toEqual([true, 0]);
  });

  test('six-shapes.2: the course’s six, the round ones cut off', () => {
    const { things } = sceneOf('six-shapes.2');
    const kinds = things.map(({ shape }) => shape.kind).toSorted();
    expect(kinds).toEqual(['circle', 'cone', 'cylinder', 'hyperboloid', 'plane', 'square']);
    const cut = things.filter(({ between }) => between).map(({ shape }) => shape.kind);
    expect(cut.toSorted()).toEqual(['cone', 'cylinder', 'hyperboloid']);
  });

  test('grazing.2: three hundred million lengths away, in light along the ground', () => {
    const { camera, lights } = sceneOf('grazing.2');
    const far = Math.hypot(...camera.eye.map((x, k) => x - (camera.target[k] ?? 0)));
    expect(Math.round(far / 1e7)).toBeCloseTo(31, 0);
    const [sun] = lights;
    if (sun?.light !== 'sun') throw new Error('no sun');
    expect(sun.towards[1] / Math.hypot(...sun.towards)).toBeLessThan(0.1);
  });

  test('hundred.2: boxes keep most questions from being asked', async () => {
    const scene = sceneOf('hundred.2');
    const { ledger } = await samePicture(scene, SETTINGS);
    const rays = ledger.kinds.camera.rays + ledger.kinds.shadow.rays;
    const asked = ledger.kinds.camera.questions + ledger.kinds.shadow.questions;
    expect(asked).toBeLessThan((rays * scene.things.length) / 2);
  });
});

test('a comparison is never of a picture with itself, and every preset’s can be read', () => {
  for (const { id } of PRESETS) {
    for (const start of ['from', 'none'] as const) {
      for (const method of ['textbook32', 'textbook', 'certified']) {
        const settings = { ...SETTINGS, method, start: { rule: start } } as TraceSettings;
        const against = AGAINST.read(firstAgainst(id, settings.start, method));
        expect(against && otherSide(settings, against)).not.toEqual(settings);
      }
    }
  }
});

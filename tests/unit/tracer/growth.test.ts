import { describe, expect, test } from 'vitest';
import { findPreset, PRESETS } from '../../../src/scene/presets/index.ts';
import { surfacesOf } from '../../../src/scene/surfaces.ts';
import { growthOf, slopeOf, WITHIN } from '../../../src/tracer/growth.ts';
import { totalOf } from '../../../src/tracer/ledger.ts';
import type { Cost } from '../../../src/tracer/types.ts';
import { picture, TINY } from './tracing.ts';

const X = [1, 2, 4, 8, 16];
const priced = (of: (x: number) => number) => slopeOf(X.map((x) => ({ x, y: of(x) })));

describe('a growth is named by the criterion', () => {
  test.each([
    ['linear', (x: number) => 3 * x],
    ['linear', (x: number) => 50 + 7 * x],
    ['logarithmic', (x: number) => 5 + 2 * Math.log(x)],
    ['constant', (x: number) => 100 + x / 10],
    ['neither', (x: number) => x ** 1.3],
    ['neither', (x: number) => Math.sqrt(x)],
    ['neither', (x: number) => (x > 3 ? 10 : 1)],
  ])('%s: %s', (growth, of) => {
    expect(priced(of)?.growth).toBe(growth);
  });

  test('off by no more than WITHIN is near enough, and more is not', () => {
    for (const [part, growth] of [
      [0.5 * WITHIN, 'linear'],
      [3 * WITHIN, 'neither'],
    ] as const) {
      const wavy = X.map((x, k) => ({ x, y: x * (1 + (k % 2 ? part : -part)) }));
      expect(slopeOf(wavy)?.growth).toBe(growth);
      // Within the quartiles of a measured price anything may be.
      const measured = wavy.map(({ x, y }) => ({ x, y, low: 0.5 * y, high: 2 * y }));
      expect(slopeOf(measured)?.growth).toBe('linear');
    }
  });

  test('with both axes logarithmic the slope is the exponent', () => {
    expect(priced((x) => 3 * x)?.exponent).toBeCloseTo(1, 12);
    expect(priced((x) => 7 * x ** 1.5)?.exponent).toBeCloseTo(1.5, 12);
  });

  test('too few points, or a price of 0, have no name', () => {
    expect(slopeOf([1, 2, 3].map((x) => ({ x, y: x })))).toBeNull();
    expect(priced((x) => x - 1)).toBeNull();
  });
});

/** The smallest picture of its series has enough pixels to tell of the whole. */
const settings = { ...TINY, width: 320, height: 180 };

describe('the series of a picture', () => {
  test.each(PRESETS)('$id: each varies one number, from what is shown or less', ({ scene }) => {
    for (const { id, points } of growthOf(scene, settings)) {
      for (const [k, point] of points.entries()) {
        expect(point.x).toBeGreaterThan(points[k - 1]?.x ?? 0);
        const { x, scene: own, settings: with_ } = point;
        const number = {
          pixels: with_.width * with_.height,
          samples: with_.samples,
          lights: own.lights.length,
          bounces: (with_.bounces ?? Number.NaN) + 1,
        }[id];
        expect(x).toBe(number ?? surfacesOf(own).length);
        expect(new Set(own.things.map((thing) => thing.id)).size).toBe(own.things.length);
        expect(new Set(own.lights.map((light) => light.id)).size).toBe(own.lights.length);
      }
    }
  });

  async function workOf(preset: string, id: string): Promise<readonly (Cost & { x: number })[]> {
    const scene = findPreset(preset)?.scene;
    const series = scene && growthOf(scene, settings).find((one) => one.id === id);
    if (!series) throw new Error(`${preset} has no ${id}`);
    return Promise.all(
      series.points.map(async ({ x, scene: own, settings: with_ }) => ({
        x,
        ...totalOf((await picture(own, with_)).ledger),
      })),
    );
  }

  test('pixels and samples are linear, no bounces are constant, boxes help', async () => {
    const named = (all: readonly (Cost & { x: number })[]) =>
      slopeOf(all.map(({ x, questions: y }) => ({ x, y })));
    for (const id of ['pixels', 'samples']) {
      const slope = named(await workOf('mirror', id));
      expect(slope).toMatchObject({ growth: 'linear' });
      expect(slope?.exponent).toBeCloseTo(1, 1);
    }
    const bounces = await workOf('mirror', 'bounces');
    expect(named(bounces)?.growth).not.toBe('constant');
    for (const [k, { rays }] of bounces.entries()) {
      expect(rays).toBeGreaterThanOrEqual(bounces[k - 1]?.rays ?? 0);
    }
    expect(named(await workOf('plain', 'bounces'))?.growth).toBe('constant');
    const shapes = await workOf('plain', 'shapes');
    const every = await workOf('plain', 'shapes.boxless');
    expect(named(every)).toMatchObject({ growth: 'linear' });
    const [boxed, asked] = [shapes, every].map((all) => all.at(-1)?.questions ?? Number.NaN);
    expect(boxed).toBeLessThan((asked ?? 0) / 10);
    expect(shapes.at(-1)?.rays).toBe(every.at(-1)?.rays);
  });
});

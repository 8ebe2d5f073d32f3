import { describe, expect, test } from 'vitest';
import { coneOnMirror } from '../../../src/scene/presets/cone-on-mirror.ts';
import { everything } from '../../../src/scene/presets/everything.ts';
import { glass } from '../../../src/scene/presets/glass.ts';
import { PRESETS } from '../../../src/scene/presets/index.ts';
import { shadows } from '../../../src/scene/presets/shadows.ts';
import { surfacesOf } from '../../../src/scene/surfaces.ts';
import type { Scene } from '../../../src/scene/types.ts';
import { level } from '../../../src/tracer/colour.ts';
import { addLedgers, EMPTY_LEDGER, totalOf } from '../../../src/tracer/ledger.ts';
import { prepareTracer, tracerOf } from '../../../src/tracer/prepare.ts';
import { NOTHING, RAY_KINDS, type TileResult } from '../../../src/tracer/types.ts';
import { HALF_A_LEVEL } from '../../../src/tracer/weight.ts';
import { flatten, picture, TINY, tracerFor } from './tracing.ts';

describe('a ray tree is what the picture did', () => {
  test('all pixels’ trees together hold as many rays of each kind as the ledger', async () => {
    const tracer = await tracerFor(everything.scene);
    const { kinds } = (await picture(everything.scene)).ledger;
    const counted = { camera: 0, shadow: 0, reflected: 0, refracted: 0 };
    for (let pixel = 0; pixel < TINY.width * TINY.height; pixel++) {
      const x = pixel % TINY.width;
      const tree = tracer.record(x, (pixel - x) / TINY.width);
      for (const { kind } of flatten(tree.rays)) counted[kind] += 1;
    }
    const fired = RAY_KINDS.map((kind) => [kind, kinds[kind].rays]);
    expect(counted).toEqual(Object.fromEntries(fired));
    expect(RAY_KINDS.every((kind) => counted[kind] > 100)).toBe(true);
  });

  test('its first hit is the frame’s, and each child starts where its parent hit', async () => {
    const { scene } = everything;
    const tracer = await tracerFor(scene);
    const { surface, t } = await picture(scene);
    const surfaces = surfacesOf(scene);
    for (let pixel = 0; pixel < surface.length; pixel += 17) {
      const x = pixel % TINY.width;
      const { rays } = tracer.record(x, (pixel - x) / TINY.width);
      const [camera] = rays;
      expect(rays).toHaveLength(1);
      if (camera?.end.end === 'hit') {
        expect([camera.end.surface, camera.end.t]).toEqual([surface[pixel], t[pixel]]);
      } else expect([surface[pixel], t[pixel]]).toEqual([NOTHING, Number.NaN]);
      for (const node of flatten(rays)) {
        for (const child of node.children) {
          if (node.end.end !== 'hit') throw new Error('a ray from nowhere');
          expect(child.ray.origin).toEqual(node.end.point);
          expect(child.from).toBe(node.end.surface);
          expect(surfaces[child.from]).toBeDefined();
          expect(child.weight).toBeLessThanOrEqual(node.weight);
        }
      }
    }
  });

  test('with four samples a pixel has four camera rays, and the picture is smoother', async () => {
    const tracer = await tracerFor(shadows.scene, { samples: 4 });
    const { rays } = tracer.record(24, 13);
    expect(rays.map(({ kind }) => kind)).toEqual(['camera', 'camera', 'camera', 'camera']);
    expect(new Set(rays.map(({ ray }) => ray.direction.join())).size).toBe(4);
    const one = await picture(shadows.scene);
    const four = await picture(shadows.scene, { samples: 4 });
    const levels = (rgba: Uint8ClampedArray): number => new Set(rgba).size;
    expect(levels(four.rgba)).toBeGreaterThan(levels(one.rgba));
    expect(four.ledger.kinds.camera.rays).toBe(4 * one.ledger.kinds.camera.rays);
  });

  test.each([coneOnMirror, everything])(
    'sixteen pictures of one sample each are the picture of $id with sixteen',
    async ({ scene }) => {
      const whole = { y0: 0, y1: TINY.height, step: 1, refines: false };
      const all = (await picture(scene, { samples: 16 })).rgba;
      const sums = new Float64Array(3 * TINY.width * TINY.height);
      const pixels = new Uint8Array(TINY.width * TINY.height).fill(1);
      for (let s = 0; s < 16; s++) {
        const part = { samples: [s], pixels };
        const { film } = (await tracerFor(scene, { samples: 16, part })).trace(whole);
        film?.forEach((x, k) => {
          sums[k] = (sums[k] ?? 0) + x;
        });
      }
      const mean = Array.from(sums, (x) => level(x / 16));
      expect(mean).toEqual([...all].filter((_, k) => k % 4 !== 3));
    },
  );

  test.each(PRESETS.map(({ id, scene }) => ({ id, scene })))(
    '$id: a tracer that takes over the engine of another one traces what a new one does',
    async ({ scene }) => {
      const whole = { y0: 0, y1: TINY.height, step: 1, refines: false };
      const first = await tracerFor(scene);
      first.trace(whole);
      const pixels = new Uint8Array(TINY.width * TINY.height).fill(1);
      const finer = { ...TINY, samples: 4, part: { samples: [2, 0], pixels } };
      const taken = await prepareTracer(scene, finer, () => 0, first);
      expect(taken.engine).toBe(first.engine);
      expect(taken.trace(whole)).toEqual((await tracerFor(scene, finer)).trace(whole));
      for (const change of [{ method: 'textbook' }, { bounces: 1 }, { lightSamples: 9 }]) {
        const other = await prepareTracer(scene, { ...TINY, ...change }, () => 0, first);
        expect(other.engine).not.toBe(first.engine);
      }
      const moved = { ...scene, ambient: scene.ambient / 2 };
      expect((await prepareTracer(moved, TINY, () => 0, first)).engine).not.toBe(first.engine);
    },
  );

  test('a part of a picture is those rays of those pixels, light added in order', async () => {
    const whole = { y0: 0, y1: TINY.height, step: 1, refines: false };
    const count = TINY.width * TINY.height;
    const every = new Uint8Array(count).fill(1);
    const some = every.map((_, i) => +(i % 7 === 2));
    const order = [13, 2, 7];
    const trace = async (samples: readonly number[], pixels: Uint8Array) =>
      (await tracerFor(everything.scene, { samples: 16, part: { samples, pixels } })).trace(whole);
    const sums = new Float64Array(3 * count);
    for (const s of order) {
      (await trace([s], every)).film?.forEach((x, k) => {
        sums[k] = (sums[k] ?? 0) + x;
      });
    }
    const { pixels, film, ledger } = await trace(order, some);
    expect([...pixels]).toEqual([...every.keys()].filter((i) => some[i] === 1));
    expect([...(film ?? [])]).toEqual(
      [...pixels].flatMap((i) => [...sums.slice(3 * i, 3 * i + 3)]),
    );
    expect(ledger.kinds.camera.rays).toBe(order.length * pixels.length);
  });

  test('recording does not disturb the picture', async () => {
    const tracer = await tracerFor(everything.scene);
    const tile = { y0: 0, y1: TINY.height, step: 1, refines: false };
    const before = tracer.trace(tile);
    tracer.record(20, 20);
    expect([...tracer.trace(tile).rgba]).toEqual([...before.rgba]);
  });
});

describe('the weight bound', () => {
  const whole = { y0: 0, y1: TINY.height, step: 1, refines: false };
  const with_ = async (scene: Scene, unseen?: number): Promise<TileResult> => {
    const { parts } = await tracerFor(scene);
    return tracerOf(scene, TINY, parts, () => 0, unseen).trace(whole);
  };

  test.each([glass, coneOnMirror, everything])(
    'changes no pixel of $id by more than a level, and saves rays',
    async ({ scene }) => {
      const usual = await with_(scene);
      const finer = await with_(scene, HALF_A_LEVEL / 64);
      const apart = usual.rgba.map((x, k) => Math.abs(x - (finer.rgba[k] as number)));
      expect(Math.max(...apart)).toBeLessThanOrEqual(1);
      expect(totalOf(usual.ledger).rays).toBeLessThan(totalOf(finer.ledger).rays);
    },
  );

  test('a bound a hundred times as coarse would be seen', async () => {
    const coarse = await with_(glass.scene, 100 * HALF_A_LEVEL);
    const usual = await with_(glass.scene);
    const apart = usual.rgba.map((x, k) => Math.abs(x - (coarse.rgba[k] as number)));
    expect(Math.max(...apart)).toBeGreaterThan(1);
  });
});

describe('the ledger', () => {
  test('adding ledgers adds all that they hold', async () => {
    const { ledger } = await picture(everything.scene);
    expect(addLedgers(EMPTY_LEDGER, ledger)).toEqual(ledger);
    const twice = addLedgers(ledger, ledger);
    expect(totalOf(twice).rays).toBe(2 * totalOf(ledger).rays);
    expect(twice.saved).toBe(2 * ledger.saved);
    expect(twice.kinds.refracted.roots).toBe(2 * ledger.kinds.refracted.roots);
  });
});

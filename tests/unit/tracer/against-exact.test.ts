import { describe, expect, test } from 'vitest';
import { ulpDistance } from '../../../src/math/float/ulp.ts';
import { intersect } from '../../../src/math/intersect.ts';
import type { Ray } from '../../../src/math/ray.ts';
import { seeded, uniform } from '../../../src/math/rng.ts';
import { body as heights } from '../../../src/scene/effects/heights-body.ts';
import { hundred } from '../../../src/scene/presets/hundred.ts';
import { findPreset, PRESETS } from '../../../src/scene/presets/index.ts';
import { sixShapes } from '../../../src/scene/presets/six-shapes.ts';
import { type Surface, surfacesOf } from '../../../src/scene/surfaces.ts';
import type { Scene } from '../../../src/scene/types.ts';
import { createFinder } from '../../../src/tracer/find.ts';
import { newTally } from '../../../src/tracer/ledger.ts';
import { NOTHING, type RayNode } from '../../../src/tracer/types.ts';
import { createShadowRays, createWave } from '../../../src/tracer/wave.ts';
import { worldOf } from '../../../src/tracer/world.ts';
import { someRays } from './tracing.ts';

/**
 * Where a ray from `from` meets a surface first, by whole numbers and one surface at a time;
 * Infinity: nowhere.
 */
function first(surface: Surface, ray: Ray, from: Surface | undefined): number {
  const options = { from: from?.shape };
  const { hits } = intersect(surface.shape, ray, 'exact', options);
  const [low, high] = surface.between ?? [Number.NEGATIVE_INFINITY, Number.POSITIVE_INFINITY];
  const ahead = hits.filter(({ t, point }) => t > 0 && point[1] >= low && point[1] <= high);
  return ahead[0]?.t ?? Number.POSITIVE_INFINITY;
}

const distance = (scene: Scene, id: string, { ray }: RayNode): number => {
  const light = scene.lights.find((one) => one.id === id);
  if (light?.light !== 'point') return Number.POSITIVE_INFINITY;
  return Math.hypot(...light.at.map((x, k) => x - (ray.origin[k] as number)));
};

describe.each(['shadows', 'six-shapes', 'self-intersection', 'far', 'hundred', 'mirror'])(
  '%s, each ray asked again by exact',
  (id) => {
    const scene = findPreset(id)?.scene as Scene;
    const surfaces = surfacesOf(scene);

    test('the nearest hit is the nearest, and shadow rays are right', async () => {
      const rays = await someRays(scene, id === 'hundred' ? 61 : 11);
      let shadows = 0;
      let blocked = 0;
      for (const { kind, ray, from, end } of rays) {
        const start = surfaces[from];
        const found = surfaces.map((surface) => first(surface, ray, start));
        if (kind !== 'shadow') {
          const nearest = Math.min(...found);
          if (end.end === 'hit') {
            expect(found.indexOf(nearest)).toBe(end.surface);
            expect(ulpDistance(end.t, nearest)).toBeLessThanOrEqual(1);
          } else expect(nearest).toBe(Number.POSITIVE_INFINITY);
          continue;
        }
        if (end.end !== 'light' && end.end !== 'blocked') throw new Error('a shadow ray ended');
        const limit = distance(scene, end.light, { kind, ray, from, end, weight: 1, children: [] });
        expect(found.some((t) => t < limit)).toBe(end.end === 'blocked');
        shadows += 1;
        blocked += end.end === 'blocked' ? 1 : 0;
      }
      expect(shadows).toBeGreaterThan(10);
      expect(blocked).toBeGreaterThan(0);
    });
  },
);

describe('each kind of shape throws its own shadow', () => {
  test.each(sixShapes.scene.things.map(({ id }) => id))('%s', async (id) => {
    // The one shape over a floor far below, so that whatever is dark is dark because of it.
    const scene: Scene = {
      ...sixShapes.scene,
      things: sixShapes.scene.things
        .filter((thing) => thing.id === id || thing.id === 'floor')
        .map((thing) =>
          thing.id === 'floor' && id !== 'floor'
            ? { ...thing, shape: { kind: 'plane', normal: [0, 1, 0], point: [0, -0.5, 0] } }
            : thing,
        ),
    };
    const surfaces = surfacesOf(scene);
    const rays = await someRays(scene, 3);
    let blocked = 0;
    for (const node of rays) {
      const { end } = node;
      if (end.end !== 'light' && end.end !== 'blocked') continue;
      const limit = distance(scene, end.light, node);
      const hit = surfaces.some((one) => first(one, node.ray, surfaces[node.from]) < limit);
      expect(hit).toBe(end.end === 'blocked');
      blocked += hit ? 1 : 0;
    }
    // A plane alone shades nothing, and no shadow ray is fired at all.
    if (id === 'floor') expect(rays.some(({ kind }) => kind === 'shadow')).toBe(false);
    else expect(blocked).toBeGreaterThan(2);
  });
});

describe('boxes', () => {
  test.each(PRESETS)('change no answer: $id (2000 rays, seed 3)', ({ scene }) => {
    const { targets } = worldOf(scene, 'certified', 'needed');
    const random = seeded(3);
    const wave = createWave(2000);
    const shadowRays = createShadowRays(2000);
    const [tx, ty, tz] = scene.camera.target;
    for (let i = 0; i < 2000; i++) {
      // From anywhere about what the camera looks at, some along an axis exactly.
      const d = [0, 1, 2].map(() => (random() < 0.1 ? 0 : uniform(random, -1, 1)));
      const length = Math.hypot(...d) || 1;
      const origin = [tx, ty, tz].map((x) => x + uniform(random, -6, 6));
      for (const rays of [wave.rays, shadowRays.rays]) {
        [rays.Ex[i], rays.Ey[i], rays.Ez[i]] = origin as [number, number, number];
        rays.dx[i] = (d[0] as number) / length;
        rays.dy[i] = (d[1] as number) / length;
        rays.dz[i] = length === 1 && d.every((x) => x === 0) ? 1 : (d[2] as number) / length;
      }
      wave.from[i] = NOTHING;
      shadowRays.from[i] = NOTHING;
      shadowRays.limit[i] = random() < 0.5 ? Number.POSITIVE_INFINITY : uniform(random, 0, 8);
    }
    wave.count = 2000;
    wave.depth = 1;
    wave.rays.count = 2000;
    shadowRays.count = 2000;
    shadowRays.rays.count = 2000;
    const effect = { body: heights, clock: () => 0, spend: () => {} };
    const answers = [0, Number.POSITIVE_INFINITY].map((least) => {
      const finder = createFinder(targets, { rule: 'from' }, effect, least);
      finder.nearest(wave, newTally());
      const surface = [...wave.surface];
      const t = [...wave.t];
      finder.blocked(shadowRays, newTally());
      const blocked = [...shadowRays.blocker].map((k) => k !== NOTHING);
      const asked = newTally();
      const chords = finder.through(shadowRays, asked);
      expect(asked.questions).toBe(shadowRays.asked.reduce((sum, n) => sum + n, 0));
      return { surface, t, blocked, chords, roots: asked.roots, questions: asked.questions };
    });
    const [boxed, every] = answers.map(({ questions }) => questions);
    const coloured = targets.some(({ absorbs, box }) => absorbs && box);
    if (coloured) expect(boxed).toBeLessThan(every ?? 0);
    expect({ ...answers[0], questions: 0 }).toEqual({ ...answers[1], questions: 0 });
    expect(answers[0]?.surface.some((k) => k !== NOTHING)).toBe(true);
  });

  test('keep most questions of a hundred shapes from being asked', () => {
    const { targets } = worldOf(hundred.scene, 'certified', 'needed');
    expect(targets.filter(({ box }) => !box)).toHaveLength(1);
  });
});

import { describe, expect, test } from 'vitest';
import type { Vec3 } from '../../../src/math/vec3.ts';
import { fresnel, snell } from '../../../src/scene/optics.ts';
import { coneOnMirror } from '../../../src/scene/presets/cone-on-mirror.ts';
import { everything } from '../../../src/scene/presets/everything.ts';
import { facingMirrors } from '../../../src/scene/presets/facing-mirrors.ts';
import { glass as glassPreset } from '../../../src/scene/presets/glass.ts';
import type { Material, Scene, Thing } from '../../../src/scene/types.ts';
import { encoded, level, linear } from '../../../src/tracer/colour.ts';
import type { RayNode } from '../../../src/tracer/types.ts';
import { HALF_A_LEVEL, MOST_BOUNCES } from '../../../src/tracer/weight.ts';
import { flatten, picture, someRays, TINY, tracerFor } from './tracing.ts';

const white: Material = {
  paint: { pattern: 'plain', colour: '#ffffff' },
  shine: { strength: 0, exponent: 20 },
  mirror: 0,
};
const glassOf = (index: number, sigma = 0): Material => ({
  ...white,
  glass: { index, absorption: [sigma, sigma, sigma] },
});

/**
 * Everything white and equally bright: whatever is put in, every pixel stays white if no energy is
 * gained or lost.
 */
const furnace = (things: readonly Thing[], camera: Scene['camera']): Scene => ({
  title: 'furnace',
  camera,
  background: { low: '#ffffff', high: '#ffffff' },
  ambient: 1,
  things,
  lights: [],
});

const plane = (id: string, y: number, up: 1 | -1, material: Material): Thing => ({
  id,
  shape: { kind: 'plane', normal: [0, up, 0], point: [0, y, 0] },
  material,
});
/** Glass between y = 0 and y = `thick`. */
const slab = (index: number, thick: number, sigma = 0): Thing[] => [
  plane('top', thick, 1, glassOf(index, sigma)),
  plane('bottom', 0, -1, glassOf(index, sigma)),
];
const ball = (material: Material, radius = 1): Thing => ({
  id: 'ball',
  shape: { kind: 'hyperboloid', center: [0, 0, 0], flare: -1, radius },
  material,
});

/** The one ray through the middle of a picture of 1 × 1. */
async function middle(scene: Scene): Promise<RayNode> {
  const tracer = await tracerFor(scene, { width: 1, height: 1 });
  const [ray] = tracer.record(0, 0).rays;
  if (!ray) throw new Error('no camera ray');
  return ray;
}
const looking = (from: Vec3, at: Vec3): Scene['camera'] => ({ eye: from, target: at, angle: 30 });
const dot = (a: Vec3, b: Vec3): number => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
const next = (node: RayNode | undefined, kind: RayNode['kind']): RayNode | undefined =>
  node?.children.find((child) => child.kind === kind);

describe('the two laws, as closed forms', () => {
  test('Snell: n₁ sin θ₁ = n₂ sin θ₂', () => {
    for (const eta of [1 / 1.5, 1.5, 1 / 2.4, 1]) {
      for (let angle = 0; angle < 1.5; angle += 0.1) {
        const inside = snell(eta, Math.cos(angle));
        if (eta * Math.sin(angle) > 1) expect(inside).toBeNaN();
        else expect(Math.sqrt(1 - inside ** 2)).toBeCloseTo(eta * Math.sin(angle), 7);
      }
    }
  });

  test('Fresnel: straight on, at Brewster’s angle, at a grazing angle, without a boundary', () => {
    for (const n of [1.33, 1.5, 2.4]) {
      const straight = ((n - 1) / (n + 1)) ** 2;
      expect(fresnel(1 / n, 1)).toBeCloseTo(straight, 14);
      expect(fresnel(n, 1)).toBeCloseTo(straight, 14);
      // tan θ = n: nothing of the one polarisation comes back, ((n² − 1)/(n² + 1))² of the other.
      const brewster = Math.cos(Math.atan(n));
      expect(fresnel(1 / n, brewster)).toBeCloseTo(((n * n - 1) / (n * n + 1)) ** 2 / 2, 12);
      expect(fresnel(1 / n, 0)).toBe(1);
    }
    expect(fresnel(1, 0.3)).toBeCloseTo(0, 15);
    expect(fresnel(1, 0)).toBe(1);
  });

  test('either side reflects the same share, and from the critical angle on all of it', () => {
    for (let angle = 0; angle < 1.55; angle += 0.05) {
      const outside = Math.cos(angle);
      expect(fresnel(1.5, snell(1 / 1.5, outside))).toBeCloseTo(fresnel(1 / 1.5, outside), 12);
    }
    const critical = Math.asin(1 / 1.5);
    expect(fresnel(1.5, Math.cos(critical + 1e-9))).toBe(1);
    expect(fresnel(1.5, Math.cos(critical - 1e-4))).toBeLessThan(0.95);
  });
});

describe('rays at glass', () => {
  test('obey Snell and Fresnel, and stay in the plane of incidence', async () => {
    const rays = await someRays(glassPreset.scene, 7);
    const hits = rays.filter(({ children }) => children.some(({ kind }) => kind === 'refracted'));
    expect(hits.length).toBeGreaterThan(20);
    for (const ray of hits) {
      if (ray.end.end !== 'hit') throw new Error('bent where nothing was hit');
      const { normal } = ray.end;
      const d = ray.ray.direction;
      const cosine = -dot(d, normal);
      const bent = next(ray, 'refracted') as RayNode;
      const out = bent.ray.direction;
      const inside = -dot(out, normal);
      const sine = Math.sqrt(1 - cosine ** 2);
      const other = Math.sqrt(Math.max(0, 1 - inside ** 2));
      const eta = other > sine ? 1.5 : 1 / 1.5;
      expect(other).toBeCloseTo(eta * sine, 7);
      expect(dot(out, out)).toBeCloseTo(1, 13);
      // d, N and the bent ray lie in one plane.
      const volume =
        out[0] * (d[1] * normal[2] - d[2] * normal[1]) +
        out[1] * (d[2] * normal[0] - d[0] * normal[2]) +
        out[2] * (d[0] * normal[1] - d[1] * normal[0]);
      expect(volume).toBeCloseTo(0, 14);
      expect(bent.weight / ray.weight).toBeCloseTo(1 - fresnel(eta, cosine), 12);
      const back = next(ray, 'reflected');
      if (back) {
        expect(back.weight / ray.weight).toBeCloseTo(fresnel(eta, cosine), 12);
        expect(dot(back.ray.direction, normal)).toBeCloseTo(cosine, 13);
      }
    }
  });

  test.each([
    ['below the critical angle some gets out', -1e-3, true],
    ['beyond it none does', 1e-3, false],
  ])('%s', async (_, beyond, leaves) => {
    const angle = Math.asin(1 / 1.5) + beyond;
    const scene = furnace(
      [plane('water', 0, 1, glassOf(1.5))],
      looking([0, -1, 0], [Math.sin(angle), -1 + Math.cos(angle), 0]),
    );
    const ray = await middle(scene);
    expect(next(ray, 'refracted') !== undefined).toBe(leaves);
    if (!leaves) expect(next(ray, 'reflected')?.weight).toBe(1);
  });

  test('a slab with parallel sides: what comes out is parallel and moved aside', async () => {
    const thick = 0.7;
    const n = 1.5;
    for (const angle of [0.1, 0.6, 1.2]) {
      const d: Vec3 = [Math.sin(angle), -Math.cos(angle), 0];
      const ray = await middle(furnace(slab(n, thick), looking([0, 2, 0], [d[0], 2 + d[1], d[2]])));
      const out = next(next(ray, 'refracted'), 'refracted');
      if (!out) throw new Error('nothing came out');
      out.ray.direction.forEach((x, k) => {
        expect(x).toBeCloseTo(ray.ray.direction[k] as number, 14);
      });
      const inside = Math.asin(Math.sin(angle) / n);
      const aside = (thick * Math.sin(angle - inside)) / Math.cos(inside);
      const from = [out.ray.origin[0] - 0, out.ray.origin[1] - 2] as const;
      const moved = Math.abs(from[0] * d[1] - from[1] * d[0]);
      expect(moved).toBeCloseTo(aside, 13);
    }
  });

  test('absorption is e^(−σ · chord): through a slab and through a ball', async () => {
    const sigma = 0.8;
    const angle = 0.6;
    const down: Vec3 = [Math.sin(angle), 2 - Math.cos(angle), 0];
    const ray = await middle(furnace(slab(1.5, 0.7, sigma), looking([0, 2, 0], down)));
    const through = next(next(ray, 'refracted'), 'refracted');
    const chord = 0.7 / Math.cos(Math.asin(Math.sin(angle) / 1.5));
    const passes = 1 - fresnel(1 / 1.5, Math.cos(angle));
    expect(through?.weight).toBeCloseTo(passes * passes * Math.exp(-sigma * chord), 13);

    const axis = await middle(furnace([ball(glassOf(1.5, sigma))], looking([0, 0, 5], [0, 0, 0])));
    const out = next(next(axis, 'refracted'), 'refracted');
    expect(out?.weight).toBeCloseTo(0.96 * 0.96 * Math.exp(-2 * sigma), 13);
  });

  test('a pixel behind a slab, all inner reflections summed: R + T²a/(1 − Ra)', async () => {
    const sigma = 0.5;
    for (const angle of [0, 0.5, 1.1]) {
      const at: Vec3 = [Math.sin(angle), 2 - Math.cos(angle), 0.0001];
      const scene = furnace(slab(1.5, 0.7, sigma), looking([0, 2, 0], at));
      const { rgba } = await picture(scene, { width: 1, height: 1 });
      const R = fresnel(1 / 1.5, Math.cos(angle));
      const a = Math.exp((-sigma * 0.7) / Math.cos(Math.asin(Math.sin(angle) / 1.5)));
      const right = level(R + ((1 - R) ** 2 * a) / (1 - R * a));
      expect(Math.abs((rgba[0] as number) - right)).toBeLessThanOrEqual(1);
    }
  });
});

test('a camera inside of coloured glass begins in it: aT / (1 − Ra²) amid a ball', async () => {
  const inside = furnace([ball(glassOf(1.5, 0.8))], looking([0, 0, 0], [0, 0, -1]));
  const { rgba } = await picture(inside, { width: 1, height: 1 });
  const a = Math.exp(-0.8);
  const right = level((0.96 * a) / (1 - 0.04 * a * a));
  expect(Math.abs((rgba[0] as number) - right)).toBeLessThanOrEqual(1);
});

test('each colour fades by its own σ', async () => {
  const sigma: Vec3 = [0.2, 0.9, 2.5];
  const coloured = slab(1.5, 0.7).map((side) => ({
    ...side,
    material: { ...white, glass: { index: 1.5, absorption: sigma } },
  }));
  const { rgba } = await picture(furnace(coloured, looking([0, 2, 0], [0, 0, 0.001])), {
    width: 1,
    height: 1,
  });
  sigma.forEach((s, k) => {
    const a = Math.exp(-0.7 * s);
    const right = level(0.04 + (0.96 ** 2 * a) / (1 - 0.04 * a));
    expect(Math.abs((rgba[k] as number) - right)).toBeLessThanOrEqual(1);
  });
});

describe('light on its way', () => {
  const floorSeen: Scene['camera'] = { eye: [0, 1, 1e-6], target: [0, 0, 0], angle: 1 };
  const under = (
    things: readonly Thing[],
    light: Partial<Scene['lights'][number]> = {},
  ): Scene => ({
    ...furnace([plane('floor', 0, 1, white), ...things], floorSeen),
    ambient: 0,
    effects: { 'coloured-shadow': { light: 'dimmed' } },
    lights: [
      { light: 'point', id: 'lamp', colour: '#ffffff', strength: 0.8, at: [4, 3, 0], ...light },
    ] as Scene['lights'],
  });
  const sigma: Vec3 = [0.1, 0.4, 1.2];
  const coloured: Material = { ...white, glass: { index: 1.5, absorption: sigma } };
  /** The floor's middle: cosine 3/5 with the lamp at (4, 3, 0), 5 away. */
  const seen = async (scene: Scene): Promise<readonly number[]> =>
    [...(await picture(scene, { width: 1, height: 1 })).rgba].slice(0, 3);
  const levels = (...linear: readonly number[]): readonly number[] =>
    linear.map((x) => level(0.8 * 0.6 * x));
  const afterGlass = (chord: number): readonly number[] =>
    levels(...sigma.map((s) => Math.exp(-s * chord)));

  test('falls off as the square from a distance on, and not before', async () => {
    const with_ = (full: number) => under([], { effects: { 'fall-off': { full } } });
    expect(await seen(with_(0))).toEqual(levels(1, 1, 1));
    expect(await seen(with_(7))).toEqual(levels(1, 1, 1));
    expect(await seen(with_(2.5))).toEqual(levels(1 / 4, 1 / 4, 1 / 4));
    expect(await seen(with_(1))).toEqual(levels(1 / 25, 1 / 25, 1 / 25));
  });

  test('fades in glass as e^(−σ · chord): a ball, a closed cylinder, planes', async () => {
    const ball: Thing = {
      id: 'ball',
      shape: { kind: 'sphere', center: [2, 1.5, 0], radius: 0.5 },
      material: coloured,
    };
    expect(await seen(under([ball]))).toEqual(afterGlass(1));
    const drum: Thing = {
      id: 'drum',
      shape: { kind: 'cylinder', center: [2, 0, 0], radius: 1 },
      between: [1.2, 1.8],
      capped: true,
      material: coloured,
    };
    // Along (4, 3, 0)/5, 0.6 of height is a chord of 1, from cap to cap.
    expect(await seen(under([drum]))).toEqual(afterGlass(1));
    const planes = [plane('top', 2, 1, coloured), plane('bottom', 1.4, -1, coloured)];
    expect(await seen(under(planes))).toEqual(afterGlass(1));
    const higher = planes.map((one, k): Thing => {
      const point: Vec3 = [0, k ? 2.2 : 2.5, 0];
      return { ...one, shape: { kind: 'plane', normal: [0, k ? -1 : 1, 0], point } };
    });
    expect(await seen(under([ball, ...higher]))).toEqual(afterGlass(1.5));
  });

  test('from within glass the rest of the way counts', async () => {
    const around: Thing = {
      id: 'around',
      shape: { kind: 'sphere', center: [0, 0, 0], radius: 2 },
      material: coloured,
    };
    // From the eye to the floor 1, and from there 2 to where light enters the ball.
    expect(await seen(under([around]))).toEqual(afterGlass(3));
  });
});

describe('energy', () => {
  test.each([coneOnMirror, everything, glassPreset, facingMirrors])(
    'no hit of $id sends on more than it got',
    async ({ scene }) => {
      const rays = await someRays(scene, 5);
      for (const ray of rays) {
        const sent = ray.children
          .filter(({ kind }) => kind !== 'shadow')
          .reduce((sum, { weight }) => sum + weight, 0);
        expect(sent).toBeLessThanOrEqual(ray.weight * (1 + 1e-15));
      }
    },
  );

  test('in a white furnace nothing white is seen: paint, mirrors, clear glass', async () => {
    const camera: Scene['camera'] = { eye: [0.3, 2, 6], target: [0, 0.2, 0], angle: 40 };
    const things: Thing[] = [
      plane('floor', -1, 1, white),
      { ...ball(glassOf(1.5)), id: 'glass' },
      {
        id: 'mirror',
        shape: { kind: 'square', corner: [-2.5, -1, -2], side: 2.5, axis: 'z' },
        material: { ...white, mirror: 0.7 },
      },
      {
        id: 'cone',
        shape: { kind: 'cone', vertex: [1.8, 1, 0], slope: 0.4 },
        material: glassOf(1.3),
        between: [-0.9, 1],
        capped: true,
      },
    ];
    const { rgba } = await picture(furnace(things, camera));
    // The weight bound takes away at most a level here.
    expect(Math.min(...rgba)).toBeGreaterThanOrEqual(254);
  });
});

describe('the weight bound', () => {
  test('half a level is half a level where sRGB is steepest, and less anywhere else', () => {
    expect(255 * encoded(HALF_A_LEVEL)).toBeCloseTo(0.5, 12);
    for (let x = 0; x < 1; x += 1 / 512) {
      expect(255 * (encoded(x + HALF_A_LEVEL) - encoded(x))).toBeLessThan(0.5 + 1e-9);
    }
  });

  const hall = (mirror: number): Scene => ({
    ...furnace(
      [plane('below', 0, 1, { ...white, mirror }), plane('above', 2, -1, { ...white, mirror })],
      looking([0, 1, 0], [0, 0, 0.001]),
    ),
    background: { low: '#000000', high: '#000000' },
    ambient: 1,
  });

  test.each([0.5, 0.85])(
    'mirrors of %f that face each other: as deep as half a level needs',
    async (share) => {
      const tracer = await tracerFor(hall(share), { width: 1, height: 1 });
      const depth = flatten(tracer.record(0, 0).rays).length - 1;
      // The k-th reflected ray has weight share^k, and nothing is brighter than 1 here.
      const bound = Math.floor(Math.log(HALF_A_LEVEL) / Math.log(share));
      expect(depth).toBe(bound);
      const { ledger } = tracer.trace({ y0: 0, y1: 1, step: 1, refines: false });
      expect(ledger).toMatchObject({ saved: 1, cut: 0, kinds: { reflected: { rays: bound } } });
    },
  );

  test('perfect ones: the limit of bounces, and it is said', async () => {
    const tracer = await tracerFor(hall(1), { width: 1, height: 1 });
    const { ledger } = tracer.trace({ y0: 0, y1: 1, step: 1, refines: false });
    expect(ledger).toMatchObject({
      saved: 0,
      cut: 1,
      kinds: { reflected: { rays: MOST_BOUNCES } },
    });
  });

  test('the sum of a mirror hall: (1 − s)(1 + s + s² + …) is white, up to the bound', async () => {
    const { rgba } = await picture(hall(0.85), { width: 1, height: 1 });
    expect(rgba[0]).toBe(255);
  });
});

describe('pixels against analytic values, to a level', () => {
  const lamp: Vec3 = [3, 4, 5];
  const lit = (material: Material): Scene => ({
    ...furnace([ball(material)], looking([0, 0, 6], [0, 0, 0])),
    background: { low: '#102030', high: '#405060' },
    ambient: 0.2,
    lights: [{ light: 'point', id: 'lamp', colour: '#ffffff', strength: 0.7, at: lamp }],
  });
  const paint = linear('#8090a0');
  const painted: Material = { ...white, paint: { pattern: 'plain', colour: '#8090a0' } };

  test.each<[string, Material]>([
    ['Lambert', painted],
    ['Lambert and Phong', { ...painted, shine: { strength: 0.4, exponent: 12 } }],
  ])('%s on a ball', async (_, material) => {
    const tracer = await tracerFor(lit(material));
    const { rgba } = await picture(lit(material));
    let checked = 0;
    for (let pixel = 0; pixel < TINY.width * TINY.height; pixel += 3) {
      const x = pixel % TINY.width;
      const [ray] = tracer.record(x, (pixel - x) / TINY.width).rays;
      const d = ray?.ray.direction as Vec3;
      const b = 6 * d[2];
      const D = b * b - 35;
      const up = (d[1] + 1) / 2;
      const expected = [0, 1, 2].map((k) => {
        const [low, high] = [linear('#102030')[k] as number, linear('#405060')[k] as number];
        if (D < 0) return level(low + up * (high - low));
        const t = -b - Math.sqrt(D);
        const P: Vec3 = [t * d[0], t * d[1], 6 + t * d[2]];
        const way: Vec3 = [lamp[0] - P[0], lamp[1] - P[1], lamp[2] - P[2]];
        const length = Math.hypot(...way);
        const cosine = Math.max(0, dot(way, P) / length);
        const mirrored = 2 * cosine * -dot(P, d) + dot(way, d) / length;
        const gloss =
          cosine > 0
            ? material.shine.strength * Math.max(0, mirrored) ** material.shine.exponent
            : 0;
        return level((paint[k] as number) * (0.2 + 0.7 * cosine) + 0.7 * gloss);
      });
      expected.forEach((right, k) => {
        expect(Math.abs((rgba[4 * pixel + k] as number) - right)).toBeLessThanOrEqual(1);
      });
      checked += D < 0 ? 0 : 1;
    }
    expect(checked).toBeGreaterThan(60);
  });

  test('a mirror shows what stands at the mirrored place', async () => {
    const camera: Scene['camera'] = { eye: [0, 1, 6], target: [0, 1, 0], angle: 40 };
    const things = (z: number): Thing[] => [
      {
        ...ball(painted, 0.6),
        shape: { kind: 'hyperboloid', center: [1, 1, z], flare: -1, radius: 0.6 },
      },
    ];
    const mirror: Thing = {
      id: 'mirror',
      shape: { kind: 'square', corner: [-20, -20, 0], side: 40, axis: 'z' },
      material: { ...white, mirror: 1 },
    };
    const scene = (list: readonly Thing[]): Scene => ({
      ...furnace(list, camera),
      background: { low: '#000000', high: '#ffffff' },
      ambient: 0.5,
    });
    // The ball stands before the mirror and behind the camera; its image at −z.
    const shown = await picture(scene([mirror, ...things(9)]));
    const real = await picture(scene(things(-9)));
    expect([...shown.rgba]).toEqual([...real.rgba]);
  });
});

import { describe, expect, test } from 'vitest';
import { exact } from '../../../src/math/arithmetic/exact.ts';
import { float64 } from '../../../src/math/arithmetic/float64.ts';
import { evaluate, evaluateTriple } from '../../../src/math/formula/evaluate.ts';
import { intersect, SHAPES, type Shape } from '../../../src/math/index.ts';
import { valuesOf } from '../../../src/math/methods/tree-method.ts';
import type { Ray } from '../../../src/math/ray.ts';
import { type Random, seeded, uniform } from '../../../src/math/rng.ts';
import { definitionOf } from '../../../src/math/shapes/lookup.ts';
import { withPoint } from '../../../src/math/shapes/planar.ts';
import type { Vec3 } from '../../../src/math/vec3.ts';
import { createDerive } from '../../../src/state/derive.ts';
import { exactResultOf } from '../../../src/state/exact-result.ts';
import { exploreDetails } from '../../../src/state/explore-details.ts';
import { advance, historyOf } from '../../../src/state/history.ts';
import { distanceToSurface } from '../../../src/state/near-tangent.ts';
import { nearestTangent } from '../../../src/state/nearest-tangent.ts';
import { tangentTarget } from '../../../src/state/snap.ts';
import { type AppState, INITIAL, rayOf, shapeOf } from '../../../src/state/state.ts';
import { update } from '../../../src/state/update.ts';
import { decode, encode } from '../../../src/state/url.ts';

const CURVED = SHAPES.filter(({ circleNear }) => circleNear).map(({ kind }) => kind);
const RANDOM_STATES = 60;

const vector = (random: Random, size: number): Vec3 => [
  uniform(random, -size, size),
  uniform(random, -size, size),
  uniform(random, -size, size),
];

/** A state whose shape and ray are like a slider's, in hundredths. */
function ordinary(kind: AppState['kind'], random: Random): AppState {
  const round = (x: number) => Math.round(x * 100) / 100;
  const put = (size: number) => vector(random, size).map(round) as unknown as Vec3;
  const old = INITIAL.shapes[kind];
  const shape = Object.fromEntries(
    Object.entries(old).map(([key, value]) => [
      key,
      typeof value === 'number'
        ? round(uniform(random, 0.2, 2))
        : Array.isArray(value)
          ? put(2)
          : value,
    ]),
  ) as unknown as Shape;
  return {
    ...INITIAL,
    kind,
    shapes: { ...INITIAL.shapes, [kind]: shape },
    E: put(4),
    d: put(1),
  };
}

/**
 * What a drag of E, or of the tip of d, over the place where D changes its sign leaves; null where
 * there is no such place.
 */
function snapped(state: AppState, symbol: 'E' | 'd', random: Random): AppState | null {
  const model = createDerive(() => exploreDetails)(state);
  const handle = model.scene.handles.find((h) => h.symbol === symbol);
  if (!handle?.tangency || typeof handle.value === 'number') return null;
  const [from, course] = [handle.value, vector(random, symbol === 'E' ? 0.3 : 0.05)];
  const way = (s: number): Vec3 => from.map((x, i) => x + s * (course[i] ?? 0)) as unknown as Vec3;
  const offer = tangentTarget([way], handle.tangency, []);
  return offer && update(state, handle.action(offer.value));
}

const cases = (kind: AppState['kind'], seed: number): AppState[] => {
  const random = seeded(seed);
  return Array.from({ length: RANDOM_STATES }, () => ordinary(kind, random)).flatMap((state) =>
    (['E', 'd'] as const).flatMap((symbol) => snapped(state, symbol, random) ?? []),
  );
};

describe.each(CURVED)('%s', (kind) => {
  const states = cases(kind, 20260711);
  const derive = createDerive(() => exploreDetails);

  test('what a drag snaps to is said to touch as nearly as doubles can, later too', () => {
    expect(states.length).toBeGreaterThan(RANDOM_STATES / 3);
    for (const state of states) {
      const { found, verdict } = derive(state);
      if (found.class === 'tangent' || found.class === 'one') continue;
      expect(verdict.text, encode(state)).toMatch(/^touches as nearly as doubles can: D = /);
      // A link and a reload know nothing of the drag.
      expect(derive(decode(encode(state))).verdict.text).toBe(verdict.text);
    }
  });

  test('the sentence has the signs of exact arithmetic', () => {
    for (const state of states) {
      const { verdict, near } = derive(state);
      if (!near) continue;
      const { details, hits } = intersect(shapeOf(state), rayOf(state), 'exact');
      if (details.family !== 'curved') throw new Error('a flat shape');
      expect(verdict.text.includes('D = −')).toBe(details.signs.D === -1);
      expect(/misses by|stays inside by/.test(verdict.text)).toBe(hits.length === 0);
      expect(verdict.text.includes('t₂ − t₁ = ')).toBe(hits.length === 2);
    }
  });

  test('what is offered instead is tangent, near, and one step of undo', () => {
    const offers = states.flatMap((state) => {
      const found = nearestTangent(state);
      return found ? [{ state, found }] : [];
    });
    expect(offers.length).toBeGreaterThan(0.8 * states.length);
    for (const { state, found } of offers) {
      const ray = { origin: found.E, direction: found.d };
      const touched = intersect(found.shape, ray, 'exact');
      expect(touched.class).toBe('tangent');
      expect(touched.hits[0]?.singular).toBe(false);
      const history = advance(historyOf(state), { type: 'tangent', find: nearestTangent }, null);
      expect(shapeOf(history.present)).toEqual(found.shape);
      expect(rayOf(history.present)).toEqual(ray);
      const back = advance(history, { type: 'undo' }, null).present;
      expect([back.E, back.d, shapeOf(back)]).toEqual([state.E, state.d, shapeOf(state)]);
    }
  });

  test('a state that is nowhere near is not said to be', () => {
    const random = seeded(5);
    for (let i = 0; i < 100; i++) {
      const state = ordinary(kind, random);
      const { near, found } = derive(state);
      const { details } = found;
      if (near === null || details.family !== 'curved') continue;
      expect(Math.abs(details.D)).toBeLessThan(1e-12);
    }
  });

  test('the distance is the one from the line to the surface', () => {
    const random = seeded(77);
    let checked = 0;
    for (const state of states) {
      // Moved off a little more, so that plain doubles can measure it too.
      const E = state.E.map((x) => x + uniform(random, -1e-5, 1e-5)) as unknown as Vec3;
      const [shape, ray] = [shapeOf(state), { origin: E, direction: state.d }];
      const found = distanceToSurface(shape, ray, exactResultOf(shape, ray));
      if (found === null || found < 1e-8) continue;
      checked++;
      expect(measured(shape, ray) / found).toBeCloseTo(1, 2);
    }
    expect(checked).toBeGreaterThan(states.length / 2);
  });
});

/** |s| for which F(X + sN) = 0 with the unit normal N, at the X of the line where F turns. */
function measured(shape: Shape, ray: Ray): number {
  const formula = definitionOf(shape).formula(shape);
  const { surface } = definitionOf(shape);
  if (formula.family !== 'curved') throw new Error('a flat shape');
  const values = valuesOf(shape, ray, float64);
  const F = (x: Vec3): number => {
    const at = withPoint(values, x);
    return evaluate(surface.left, float64, at) - evaluate(surface.right, float64, at);
  };
  const { details } = intersect(shape, ray, 'exact');
  if (details.family !== 'curved') throw new Error('a flat shape');
  const turn = -details.B / (2 * details.A);
  const on = (t: number): Vec3 =>
    ray.origin.map((x, i) => x + t * (ray.direction[i] ?? 0)) as unknown as Vec3;
  const place = on(turn);
  const half = evaluateTriple(formula.normal, float64, withPoint(values, place));
  const length = Math.hypot(...half);
  // The sign of D is the side; f there from D, which cancels less than F at a rounded place.
  const goal = -details.D / (4 * details.A) - F(place);
  let s = 0;
  for (let i = 0; i < 5; i++) {
    const moved = place.map((x, k) => x + (s * (half[k] ?? 0)) / length) as unknown as Vec3;
    s -= (F(moved) + goal) / (2 * length);
  }
  return Math.abs(s);
}

test('the miss of a cylinder is its axis’ distance less r, to the last digit', () => {
  for (const state of cases('cylinder', 3)) {
    const shape = state.shapes.cylinder as Extract<Shape, { kind: 'cylinder' }>;
    const ray = rayOf(state);
    const found = distanceToSurface(shape, ray, exactResultOf(shape, ray));
    const of = exact.of;
    const [dx, dz] = [of(ray.direction[0]), of(ray.direction[2])];
    const x = exact.sub(of(ray.origin[0]), of(shape.center[0]));
    const z = exact.sub(of(ray.origin[2]), of(shape.center[2]));
    const my = exact.sub(exact.mul(dz, x), exact.mul(dx, z));
    const A = exact.add(exact.sqr(dx), exact.sqr(dz));
    if (exact.sign(A) === 0 || found === null) continue;
    const off = exact.sub(exact.sqrt(exact.div(exact.sqr(my), A)), of(shape.radius));
    expect(found / Math.abs(exact.toNumber(off))).toBeCloseTo(1, 6);
  }
});

test('a flat shape and a unit d are offered nothing', () => {
  expect(nearestTangent({ ...INITIAL, kind: 'plane' })).toBeNull();
  expect(nearestTangent({ ...INITIAL, kind: 'cylinder', unit: true })).toBeNull();
});

import { describe, expect, test } from 'vitest';
import { exact } from '../../../src/math/arithmetic/exact.ts';
import { powerOfTwo, scale } from '../../../src/math/float/bits.ts';
import { nextDown, nextUp } from '../../../src/math/float/ulp.ts';
import { coefficients, intersect } from '../../../src/math/index.ts';
import type { Intersection } from '../../../src/math/intersection.ts';
import { integer, type Random, seeded, uniform } from '../../../src/math/rng.ts';
import type { ShapeDefinition } from '../../../src/math/shapes/define.ts';
import type { Stage } from '../../../src/math/shapes/drawing.ts';
import type { Shape } from '../../../src/math/shapes/index.ts';
import type { Axis, Vec3 } from '../../../src/math/vec3.ts';
import {
  type GridCase,
  gridCases,
  gridShape,
  mapParams,
  shift,
  swapAxis,
  swapXZ,
  timesPower,
} from './on-a-grid.ts';
import { isFloat32, METHOD_IDS, ray } from './shorthand.ts';
import {
  courseNormal,
  fAt,
  gradient,
  gradientTerms,
  polynomial,
  residual,
  termsAt,
} from './surface.ts';

/* What every shape promises. */

const SEED = 31415;
const EPSILON = Number.EPSILON;

/**
 * Fewer roundings than this lead from u and v to a point, and from there to left − right; each is
 * at most ε/2.
 */
const ROUNDINGS = 32;

const isCurved = (definition: ShapeDefinition<Shape>, shape: Shape): boolean =>
  definition.formula(shape).family === 'curved';

/** A stage about any place near the world's middle. */
function someStage(random: Random): Stage {
  const center: Vec3 = [uniform(random, -3, 3), uniform(random, -3, 3), uniform(random, -3, 3)];
  const radius = uniform(random, 2, 9);
  const ground = center[1] - 0.44 * radius;
  return { center, radius, ground, low: ground, high: center[1] + 0.64 * radius };
}

/** The coordinates of whatever is drawn on a stage are made of numbers up to these. */
const reach = (x: Vec3, { center, radius }: Stage): Vec3 => [
  Math.abs(x[0]) + Math.abs(center[0]) + 2 * radius,
  Math.abs(x[1]) + Math.abs(center[1]) + 2 * radius,
  Math.abs(x[2]) + Math.abs(center[2]) + 2 * radius,
];

const cross = (a: Vec3, b: Vec3): Vec3 => [
  a[1] * b[2] - a[2] * b[1],
  a[2] * b[0] - a[0] * b[2],
  a[0] * b[1] - a[1] * b[0],
];
const dot = (a: Vec3, b: Vec3): number => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
const numbers = (v: readonly (typeof ZERO)[]): Vec3 => v.map(exact.toNumber) as unknown as Vec3;
const ZERO = exact.of(0);

const CLASSES_OF = {
  curved: ['none', 'one', 'tangent', 'two'],
  flat: ['contained', 'none', 'one'],
};

/** The tests that every shape passes: a new one by standing in SHAPES. */
export function contractOf(definition: ShapeDefinition<Shape>): void {
  describe(`on 24 stages of seed ${SEED}`, () => {
    const random = seeded(SEED);
    const drawn = Array.from({ length: 24 }, () => {
      const shape = gridShape(random, definition, 1 / 8);
      const stage = someStage(random);
      return { shape, stage, drawing: definition.draw(shape, stage) };
    });
    const points = drawn.flatMap(({ shape, stage, drawing }) =>
      drawing.patches.flatMap((patch) =>
        Array.from({ length: 40 }, () => {
          const [u, v] = [integer(random, 0, 16) / 16, integer(random, 0, 16) / 16];
          return { shape, stage, x: patch.at(u, v), n: patch.normal(u, v) };
        }),
      ),
    );

    test('there is something to look at', () => {
      expect(points.length).toBeGreaterThan(400);
      expect(points.every(({ x, n }) => [...x, ...n].every(Number.isFinite))).toBe(true);
    });

    test('every drawn point satisfies the surface’s equation', () => {
      for (const { shape, stage, x } of points) {
        const tolerance = ROUNDINGS * EPSILON * termsAt(shape, reach(x, stage));
        const f = Math.abs(residual(shape, x));
        if (!(f <= tolerance)) expect({ shape, x, f }).toEqual({ tolerance });
      }
    });

    test('every drawn normal points along the gradient, by finite differences', () => {
      let steep = 0;
      for (const { shape, stage, x, n } of points) {
        const g = numbers(gradient(shape, x));
        const tolerance = ROUNDINGS * EPSILON * gradientTerms(shape, reach(x, stage));
        const across = Math.hypot(...cross(g, n)) / Math.hypot(...n);
        if (!(across <= tolerance)) expect({ shape, x, n, g, across }).toEqual({ tolerance });
        if (Math.hypot(...g) <= tolerance) continue;
        if (!(dot(g, n) > 0)) expect({ shape, x, n, g }).toBe('the same way');
        steep++;
      }
      expect(steep).toBeGreaterThan(0.9 * points.length);
    });

    test('the course’s normal is half the gradient of a curved surface, N that of a plane', () => {
      for (const { shape, x } of points) {
        const factor = exact.of(isCurved(definition, shape) ? 0.5 : 1);
        const half = gradient(shape, x).map((c) => exact.mul(c, factor));
        const normal = courseNormal(shape, x);
        const off = half.map((c, i) => exact.sign(exact.sub(c, normal[i] ?? ZERO)));
        if (off.some((s) => s !== 0)) expect({ shape, x, off }).toEqual({ off: [0, 0, 0] });
      }
    });

    test('what has no end of its own ends with the stage', () => {
      for (const { shape, stage, x } of points) {
        // A figure, an ellipsoid: drawn whole.
        if (!isCurved(definition, shape) || definition.body().box(shape, null)) continue;
        const slack = ROUNDINGS * EPSILON * (Math.abs(stage.center[1]) + stage.radius);
        expect(x[1]).toBeGreaterThanOrEqual(stage.low - slack);
        expect(x[1]).toBeLessThanOrEqual(stage.high + slack);
      }
    });

    test('closed patches close, points are points, rings are on the patch', () => {
      for (const { drawing, stage } of drawn) {
        const slack = ROUNDINGS * EPSILON * Math.hypot(...reach([0, 0, 0], stage));
        const gap = (a: Vec3, b: Vec3) => Math.hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]);
        for (const patch of drawing.patches) {
          if (patch.closed) expect(gap(patch.at(0, 0.3), patch.at(1, 0.3))).toBeLessThan(slack);
          // √ε, because near a pole the radius is the root of a difference that cancels.
          const tip = Math.sqrt(ROUNDINGS * EPSILON) * (stage.radius + 1);
          if (patch.start === 'point')
            expect(gap(patch.at(0, 0), patch.at(0.5, 0))).toBeLessThan(tip);
          if (patch.end === 'point')
            expect(gap(patch.at(0, 1), patch.at(0.5, 1))).toBeLessThan(tip);
          expect(patch.rings.every((v) => v > 0 && v < 1)).toBe(true);
        }
      }
    });

    test('the anchor and the marks are the shape’s own points', () => {
      for (const { shape, drawing } of drawn) {
        expect(drawing.marks.length).toBeGreaterThan(0);
        const { at, size } = definition.anchor(shape);
        expect([...at, size].every(Number.isFinite)).toBe(true);
        expect(size).toBeGreaterThanOrEqual(0);
        const symbols = definition.params.map(({ symbol }) => symbol);
        expect(symbols).toEqual(expect.arrayContaining(drawing.marks.map(({ symbol }) => symbol)));
      }
    });
  });

  describe(`for 80 rays on grids, seed ${SEED}`, () => {
    const cases = gridCases(seeded(SEED), definition, 80);
    const family = definition.formula((cases[0] as GridCase).shape).family;

    test('every class that its polynomial has comes up among 2000 rays', () => {
      const drawn = gridCases(seeded(SEED), definition, 2000);
      const found = drawn.map(({ shape, ray: r }) => intersect(shape, r, 'textbook').class);
      const linear = drawn.some(({ shape, ray: r }) => {
        const { A, B } = coefficients(shape, r, 'exact');
        return A === 0 && B !== 0;
      });
      // On a cylinder or sphere A = 0 leaves no B: 'one' cannot be.
      const possible = CLASSES_OF[family].filter((c) => linear || c !== 'one');
      expect([...new Set(found)].sort()).toEqual(expect.arrayContaining(possible));
    });

    test('A, B and C are what the surface’s equation says along the ray', () => {
      for (const { shape, ray: r } of cases) {
        const { A, B, C } = polynomial(shape, r);
        const said = coefficients(shape, r, 'exact');
        expect({ shape, r, ...said }).toEqual({
          shape,
          r,
          A: exact.toNumber(A),
          B: exact.toNumber(B),
          C: exact.toNumber(C),
        });
      }
    });

    test('the class is that of the surface’s own polynomial: no hit is lost, none invented', () => {
      for (const { shape, ray: r } of cases) {
        const found = intersect(shape, r, 'exact');
        expect({ shape, r, class: found.class }).toEqual({
          shape,
          r,
          class: classOf(definition, shape, r),
        });
      }
    });

    test('f changes its sign at every hit and nowhere else', () => {
      for (const { shape, ray: r } of cases) {
        const found = intersect(shape, r, 'exact');
        const crossings = found.class === 'tangent' ? 0 : crossed(found).length;
        const counted = signChanges(shape, r, crossed(found));
        if (counted !== crossings) expect({ shape, r, found, counted }).toEqual({ crossings });
        for (const t of crossed(found)) {
          const [before, after] = signsAbout(shape, r, t);
          const expected = found.class === 'tangent' ? before : -(before ?? 0);
          if (!before || after !== expected) {
            expect({ shape, r, t, before, after }).toEqual({ after: expected });
          }
        }
      }
    });

    test('hits lie on the surface, ascending, with the normal of their place', () => {
      for (const { shape, ray: r } of cases) {
        const { hits } = intersect(shape, r, 'exact');
        hits.forEach(({ point, normal, t }, i) => {
          expect(t).toBeGreaterThanOrEqual(hits[i - 1]?.t ?? -Infinity);
          // Each coordinate is off by ε/2 of itself, which counts twice in a square; the rest is
          // the test's own.
          const tolerance = 8 * EPSILON * termsAt(shape, point);
          expect(Math.abs(residual(shape, point))).toBeLessThanOrEqual(tolerance);
          const there = numbers(courseNormal(shape, point));
          const slack = 2 * EPSILON * gradientTerms(shape, point);
          expect(Math.hypot(...there.map((c, k) => c - (normal[k] ?? 0)))).toBeLessThanOrEqual(
            slack,
          );
        });
      }
    });

    describe.each(METHOD_IDS)('%s', (method) => {
      test('d times a power of two: the same places, t divided by it', () => {
        for (const { shape, ray: r } of cases) {
          const found = intersect(shape, r, method);
          for (const k of isFloat32(method) ? [-20, 7, 20] : [-300, 7, 300]) {
            const scaled = ray(r.origin, timesPower(r.direction, powerOfTwo(k)));
            const again = intersect(shape, scaled, method);
            expect({ shape, r, k, ...meaning(again) }).toEqual({
              shape,
              r,
              k,
              ...meaning(found, (t) => scale(t, -k)),
            });
          }
        }
      });

      test('−d: the same places in reverse, t negated', () => {
        for (const { shape, ray: r } of cases) {
          const found = intersect(shape, r, method);
          // With B = 0 the two roots of a stable formula come from two expressions that swap
          // places, an ulp apart.
          if (method !== 'exact' && coefficients(shape, r, 'exact').B === 0) continue;
          const back = intersect(shape, ray(r.origin, timesPower(r.direction, -1)), method);
          const mirrored = meaning(found, (t) => -t);
          expect({ shape, r, ...meaning(back) }).toEqual({
            shape,
            r,
            class: mirrored.class,
            hits: mirrored.hits.toReversed(),
          });
        }
      });

      test('everything moved by the same exact amount: the same t and normals', () => {
        const by: Vec3 = [64, -32.5, 16.25];
        for (const { shape, ray: r } of cases) {
          const moved = mapParams(shape, definition, (param, value) =>
            param.type === 'vector' && !param.nonZero ? shift(value as Vec3, by) : value,
          );
          const found = meaning(intersect(shape, r, method));
          const there = meaning(intersect(moved, ray(shift(r.origin, by), r.direction), method));
          const told = ({ class: verdict, hits }: typeof found) => ({
            class: verdict,
            // A float method's normal is made from its rounded point, so it may change with the
            // place; t may not.
            hits: hits.map(({ t, normal }) => (method === 'exact' ? { t, normal } : { t })),
          });
          expect({ shape, r, ...told(there) }).toEqual({ shape, r, ...told(found) });
        }
      });
    });

    test('x and z exchanged: the same t, places and normals exchanged', () => {
      for (const { shape, ray: r } of cases) {
        const other = mapParams(shape, definition, (param, value) =>
          param.type === 'vector'
            ? swapXZ(value as Vec3)
            : param.type === 'axis'
              ? swapAxis(value as Axis)
              : value,
        );
        const swappedRay = ray(swapXZ(r.origin), swapXZ(r.direction));
        // Not every surface stays the same when x and z are exchanged.
        if (!sameCoefficients(polynomial(shape, r), polynomial(other, swappedRay))) continue;
        const found = intersect(shape, r, 'exact');
        const swapped = intersect(other, swappedRay, 'exact');
        expect({ shape, r, ...meaning(swapped) }).toEqual({
          shape,
          r,
          class: found.class,
          hits: meaning(found).hits.map(({ t, point, normal, singular }) => ({
            t,
            point: swapXZ(point),
            normal: swapXZ(normal),
            singular,
          })),
        });
        expect(coefficients(other, swappedRay, 'exact')).toEqual(coefficients(shape, r, 'exact'));
      }
    });
  });
}

/** Class and hits, t sent through `f`; −0 and 0 are one place. */
function meaning({ class: verdict, hits }: Intersection, f: (t: number) => number = (t) => t) {
  const plain = (v: Vec3): Vec3 => [v[0] + 0, v[1] + 0, v[2] + 0];
  return {
    class: verdict,
    hits: hits.map(({ t, point, normal, singular }) => ({
      t: f(t) + 0,
      point: plain(point),
      normal: plain(normal),
      singular,
    })),
  };
}

type Polynomial = ReturnType<typeof polynomial>;
const sameCoefficients = (f: Polynomial, g: Polynomial): boolean =>
  (['A', 'B', 'C'] as const).every((id) => exact.sign(exact.sub(f[id], g[id])) === 0);

/** The roots of f: the hits, and for a figure that is missed, where its plane is met. */
function crossed({ hits, details }: Intersection): number[] {
  if (details.family === 'flat') return details.plane ? [details.plane.t] : [];
  return hits.map(({ t }) => t);
}

const signAt = (shape: Shape, r: GridCase['ray'], t: number): number =>
  exact.sign(fAt(shape, r, exact.of(t)));

const signsAbout = (shape: Shape, r: GridCase['ray'], t: number): [number, number] => [
  signAt(shape, r, nextDown(t)),
  signAt(shape, r, nextUp(t)),
];

/**
 * On a fine exact sample, with every root that was found between two neighbours of it, and far
 * beyond.
 */
function signChanges(shape: Shape, r: GridCase['ray'], found: readonly number[]): number {
  const sample = Array.from({ length: 65 }, (_, i) => (i - 32) / 2);
  const about = found.flatMap((t) => [nextDown(t), nextUp(t)]);
  const signs = [...sample, ...about, -(2 ** 60), 2 ** 60]
    .sort((a, b) => a - b)
    .map((t) => signAt(shape, r, t))
    .filter((sign) => sign !== 0);
  return signs.filter((sign, i) => i > 0 && sign !== signs[i - 1]).length;
}

/**
 * By hand, from f(−1), f(0) and f(1); a figure's conditions are asked at its plane's exact point.
 */
function classOf(definition: ShapeDefinition<Shape>, shape: Shape, r: GridCase['ray']): string {
  const { A, B, C } = polynomial(shape, r);
  const four = exact.of(4);
  const D = exact.sub(exact.mul(B, B), exact.mul(four, exact.mul(A, C)));
  if (exact.sign(A) !== 0) return ['none', 'tangent', 'two'][exact.sign(D) + 1] ?? '';
  if (exact.sign(B) === 0) return exact.sign(C) === 0 ? 'contained' : 'none';
  if (isCurved(definition, shape)) return 'one';
  const t = exact.neg(exact.div(C, B));
  const x = [0, 1, 2].map((i) =>
    exact.add(exact.of(r.origin[i] ?? 0), exact.mul(t, exact.of(r.direction[i] ?? 0))),
  );
  return isInside(shape, x) ? 'one' : 'none';
}

/** The figures' conditions, written here once more: |X − C|² ≤ r²; P ≤ X ≤ P + L. */
function isInside(shape: Shape, x: readonly (typeof ZERO)[]): boolean {
  const notAbove = (a: typeof ZERO, b: typeof ZERO): boolean => exact.sign(exact.sub(a, b)) <= 0;
  if (shape.kind === 'circle') {
    const squares = x.map((c, i) => exact.sqr(exact.sub(c, exact.of(shape.center[i] ?? 0))));
    return notAbove(squares.reduce(exact.add), exact.sqr(exact.of(shape.radius)));
  }
  if (shape.kind === 'square') {
    return x.every((c, i) => {
      const low = exact.of(shape.corner[i] ?? 0);
      const isNormal = 'xyz'[i] === shape.axis;
      return isNormal || (notAbove(low, c) && notAbove(c, exact.add(low, exact.of(shape.side))));
    });
  }
  return true;
}

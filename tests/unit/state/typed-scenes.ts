import * as fc from 'fast-check';
import {
  add,
  cross,
  type Fraction,
  fraction,
  neg,
  over,
  type Point,
  point,
  scale,
  times,
  written,
  ZERO,
} from './fraction.ts';

/** A scene in fractions; the numbers are the shape's by their letters in a link. */
export interface FractionScene {
  readonly kind: string;
  readonly E: Point;
  readonly d: Point;
  readonly points: Readonly<Record<string, Point>>;
  readonly scalars: Readonly<Record<string, Fraction>>;
  readonly axis?: 'x' | 'y' | 'z';
}

/** p² + q² = h². */
const triple = fc
  .constantFrom([3, 4, 5], [5, 12, 13], [8, 15, 17], [20, 21, 29], [4, 3, 5])
  .map(([p = 0, q = 0, h = 0]) => ({ p: fraction(p), q: fraction(q), h: fraction(h) }));
const size = fc.constantFrom(
  ...[fraction(1, 10), fraction(1, 100), fraction(3, 10), fraction(1, 7), fraction(2, 3)],
);
const tenths = fc.integer({ min: -30, max: 30 }).map((k) => fraction(k, 10));
const place = fc.tuple(tenths, tenths, tenths).map((v): Point => v);
const nonZero = tenths.filter(({ n }) => n !== 0n);
const parts = fc.record({ triple, s: size, k: size, at: place, far: nonZero, turn: place });
type Parts = typeof parts extends fc.Arbitrary<infer T> ? T : never;

/**
 * A point of the circle of radius s·h about the y axis, and what is tangential there, of length h.
 */
function round({ triple: { p, q, h }, s }: Parts) {
  return {
    on: scale(s, point(p, ZERO, q)),
    along: point(neg(q), ZERO, p),
    radius: times(s, h),
  };
}

const up = (y: Fraction): Point => point(ZERO, y, ZERO);

/** Scenes on the border between two cases, one entry a kind of border. */
const BORDERS: Readonly<Record<string, readonly ((x: Parts) => FractionScene)[]>> = {
  plane: [
    (x) => inPlane(x, (N) => [along(N, x.far), cross(N, x.turn)]),
    (x) => inPlane(x, (N) => [along(N, x.far), x.turn]),
    (x) => inPlane(x, (N) => [add(along(N, x.far), N), along(N, x.k)]),
  ],
  cylinder: [
    (x) => cylinder(x, add(round(x).on, scale(x.far, round(x).along)), round(x).along),
    (x) => cylinder(x, round(x).on, up(x.far)),
    (x) => cylinder(x, round(x).on, x.turn),
  ],
  cone: [
    (x) => cone(x, generator(x), generator(x)),
    (x) => cone(x, scale(x.far, generator(x)), x.turn),
    (x) => cone(x, add(generator(x), scale(x.far, round(x).along)), generator(x)),
  ],
  hyperboloid: [
    (x) => hyperboloid(x, round(x).on, ruling(x)),
    (x) => hyperboloid(x, add(round(x).on, scale(x.far, round(x).along)), round(x).along),
    (x) => hyperboloid(x, add(round(x).on, up(x.far)), ruling(x)),
  ],
  circle: [
    (x) => circle(x, add(x.turn, rim(x)), x.turn),
    (x) => circle(x, rim(x), add(x.triple.h.n > 9n ? x.turn : ONE_UP, ONE_UP)),
    (x) => circle(x, add(rim(x), scale(x.far, tangent(x))), tangent(x)),
  ],
  square: [
    (x) => square(x, add(x.turn, point(x.k, x.k, ZERO)), x.turn),
    (x) => square(x, add(x.turn, point(ZERO, times(x.k, fraction(1, 2)), ZERO)), x.turn),
    (x) => square(x, point(ZERO, x.far, ZERO), point(ZERO, x.s, ZERO)),
    (x) => square(x, point(neg(x.s), x.s, ZERO), point(x.s, neg(x.s), ZERO)),
  ],
};

const ONE_UP = point(fraction(1, 10), fraction(1, 5), fraction(1, 2));

const along = (N: Point, k: Fraction): Point => scale(k, point(N[1], neg(N[0]), ZERO));

function inPlane(x: Parts, lines: (N: Point) => readonly [Point, Point]): FractionScene {
  const N = point(x.triple.p, times(x.s, x.far), x.k);
  const [E, d] = lines(N);
  return { kind: 'plane', E: add(x.at, E), d, points: { N, P: x.at }, scalars: {} };
}

function cylinder(x: Parts, E: Point, d: Point): FractionScene {
  const scalars = { r: round(x).radius };
  return { kind: 'cylinder', E: add(x.at, E), d, points: { C: x.at }, scalars };
}

/** Along (p, k, q) the cone of slope h/k goes. */
const generator = ({ triple: { p, q }, k }: Parts): Point => point(p, k, q);

function cone(x: Parts, E: Point, d: Point): FractionScene {
  const scalars = { c: over(x.triple.h, x.k) };
  return { kind: 'cone', E: add(x.at, E), d, points: { V: x.at }, scalars };
}

/** Through round(x).on, in the hyperboloid of flare k². */
function ruling(x: Parts): Point {
  return add(scale(x.k, round(x).along), up(x.triple.h));
}

function hyperboloid(x: Parts, E: Point, d: Point): FractionScene {
  const scalars = { a: times(x.k, x.k), r: round(x).radius };
  return { kind: 'hyperboloid', E: add(x.at, E), d, points: { C: x.at }, scalars };
}

/** In the plane with the normal (p, 0, q). */
function rim({ triple: { p, q, h }, s }: Parts): Point {
  return scale(s, add(scale(over(p, h), point(q, ZERO, neg(p))), up(q)));
}

const tangent = ({ triple: { p, q, h } }: Parts): Point =>
  add(scale(over(neg(q), h), point(q, ZERO, neg(p))), up(p));

function circle(x: Parts, E: Point, d: Point): FractionScene {
  const { p, q } = x.triple;
  const points = { N: point(p, ZERO, q), C: x.at };
  return { kind: 'circle', E: add(x.at, E), d, points, scalars: { r: round(x).radius } };
}

function square(x: Parts, E: Point, d: Point): FractionScene {
  const rest = { kind: 'square', axis: 'z', points: { P: x.at }, scalars: { L: x.k } } as const;
  return { ...rest, E: add(x.at, E), d };
}

export const KINDS = Object.keys(BORDERS);

/** A scene on a border, or a thousandth beside it. */
export function borderScene(kind: string): fc.Arbitrary<FractionScene> {
  const builders = fc.constantFrom(...(BORDERS[kind] ?? []));
  const off = fc.constantFrom(ZERO, ZERO, ZERO, fraction(1, 1000), fraction(-1, 1000));
  return fc
    .tuple(builders, parts, off)
    .map(([build, x, by]) => {
      const scene = build(x);
      return { ...scene, E: add(scene.E, point(by, ZERO, ZERO)) };
    })
    .filter(({ d }) => d.some(({ n }) => n !== 0n));
}

export function linkOf({ kind, E, d, points, scalars, axis }: FractionScene): string {
  const pairs = [
    ...Object.entries({ E, d, ...points }).map(([key, v]) => `${key}=${v.map(written).join(',')}`),
    ...Object.entries(scalars).map(([key, x]) => `${key}=${written(x)}`),
    ...(axis ? [`axis=${axis}`] : []),
  ];
  return `#/explore?shape=${kind}&${pairs.join('&')}`;
}

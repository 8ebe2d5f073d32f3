import type { Arithmetic } from '../arithmetic/arithmetic.ts';
import { components } from '../formula/common.ts';
import { squaredNorm, type Triple, type Values } from '../formula/evaluate.ts';
import { norm, plus, scalar, squared, times, vec, vecMinus } from '../formula/expr.ts';
import { lazily } from '../lazily.ts';
import type { Vec3 } from '../vec3.ts';
import { planarBody } from './body.ts';
import type { ShapeDefinition } from './define.ts';
import { drawDisc } from './flat-drawing.ts';
import { pointGrip, radiusGrip } from './grips.ts';
import type { PlanarNumbers } from './numbers.ts';
import { LENGTH, NORMAL, POINT } from './params.ts';
import { type Bound, notPositive, planarFormula, planarSurface } from './planar.ts';

/** The disc about `center` in the plane with this normal; its rim belongs to it. */
export interface Circle {
  readonly kind: 'circle';
  readonly normal: Vec3;
  readonly center: Vec3;
  readonly radius: number;
}

const between = <T>(a: Triple<T>, b: Triple<T>, ar: Arithmetic<T>): Triple<T> => [
  ar.sub(a[0], b[0]),
  ar.sub(a[1], b[1]),
  ar.sub(a[2], b[2]),
];

const get = <T>(values: Values<T>) => ({
  E: values.vectors.E as Triple<T>,
  d: values.vectors.d as Triple<T>,
  C: values.vectors.C as Triple<T>,
  r: values.scalars.r as T,
});

const bound = (): Bound => ({
  conditions: [{ left: norm(vecMinus(vec('X'), vec('C'))), relation: '≤', right: scalar('r') }],
  momentConditions: [
    {
      left: plus(...components('w').map(squared)),
      relation: '≤',
      right: times(squared(scalar('r')), squared(scalar('rate'))),
    },
  ],
  distance(x, values, ar) {
    const { C, r } = get(values);
    return ar.sub(ar.sqrt(squaredNorm(between(x, C, ar), ar)), r);
  },
  /** |E − C + t d|² = r², which is A t² + 2 B t + C = 0. */
  span(values, ar) {
    const { E, d, C, r } = get(values);
    const from = between(E, C, ar);
    const [A, B] = [squaredNorm(d, ar), inner(d, from, ar)];
    const c = ar.sub(squaredNorm(from, ar), ar.sqr(r));
    const D = ar.sub(ar.sqr(B), ar.mul(A, c));
    if (ar.sign(D) < 0) return null;
    const root = ar.sqrt(D);
    return [ar.div(ar.sub(ar.neg(B), root), A), ar.div(ar.sub(root, B), A)];
  },
  /**
   * The line's distance from C is |d × (E − C)| / |d|; squared and freed of the quotient it is
   * exact.
   */
  meetsLine(values, ar) {
    const { E, d, C, r } = get(values);
    const moment = squaredNorm(cross(d, between(E, C, ar), ar), ar);
    return notPositive(ar.sign(ar.sub(moment, ar.mul(ar.sqr(r), squaredNorm(d, ar)))));
  },
});

function inner<T>(a: Triple<T>, b: Triple<T>, ar: Arithmetic<T>): T {
  const [x, y, z] = [ar.mul(a[0], b[0]), ar.mul(a[1], b[1]), ar.mul(a[2], b[2])];
  return ar.add(ar.add(x, y), z);
}

function cross<T>(a: Triple<T>, b: Triple<T>, ar: Arithmetic<T>): Triple<T> {
  const minor = (i: 0 | 1 | 2, j: 0 | 1 | 2): T => ar.sub(ar.mul(a[i], b[j]), ar.mul(a[j], b[i]));
  return [minor(1, 2), minor(2, 0), minor(0, 1)];
}

const surface = lazily(() => planarSurface('C'));
const formula = lazily(() => planarFormula('C', bound()));

const NUMBERS: PlanarNumbers<Circle> = {
  family: 'planar',
  read: ({ normal, center, radius }) => ({
    N: normal,
    P: center,
    bound: 'circle',
    size: radius,
    u: 0,
    v: 0,
  }),
};

/**
 * A disc: its rim belongs to it.
 * The entry of SHAPES, for `prepareWith`.
 */
export const circle: ShapeDefinition<Circle> = {
  kind: 'circle',
  title: 'circle',
  named: ({ radius }) => ({
    name: 'circle',
    singular: null,
    straight: null,
    border: [
      radius === 0
        ? 'the centre, all that is left of the circle'
        : 'on the rim, which belongs to the circle',
    ],
  }),
  icon: 'M2.5 12a9.5 5 0 0 0 19 0a9.5 5 0 0 0 -19 0',
  params: [
    { ...NORMAL, initial: [1, 0.5, 0] },
    { ...POINT, key: 'center', symbol: 'C', title: 'centre', initial: [0, 1, 0] },
    { ...LENGTH, key: 'radius', symbol: 'r', title: 'radius', initial: 2 },
  ],
  get surface() {
    return surface();
  },
  formula,
  values: ({ normal, center, radius }) => ({
    scalars: { r: radius },
    vectors: { N: normal, C: center },
  }),
  numbers: NUMBERS,
  body: lazily(() => planarBody(NUMBERS.read)),
  ownFamilies: true,
  meaning: ({ radius }) => (radius === 0 ? 'r = 0: only the centre is left' : ''),
  anchor: ({ center, radius }) => ({ at: center, size: radius }),
  draw: ({ normal, center, radius }) => ({
    ...drawDisc(normal, center, radius),
    grips: [pointGrip('center', center), radiusGrip('radius', center, radius, normal)],
  }),
};

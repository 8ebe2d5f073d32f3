import { components, momentAbout } from '../formula/common.ts';
import {
  comp,
  type Expr,
  minus,
  num,
  plus,
  type Relation,
  scalar,
  signedSum,
  squared,
  times,
} from '../formula/expr.ts';
import { lazily } from '../lazily.ts';
import { AXES, type Axis, type Vec3 } from '../vec3.ts';
import type { CurvedFormula } from './axial-quadric.ts';
import { quadricBody } from './body.ts';
import { type Naming, type ShapeDefinition, SPHERE } from './define.ts';
import { pointGrip, radiusGrip } from './grips.ts';
import { isAt, type QuadricNumbers } from './numbers.ts';
import { LENGTH, POINT } from './params.ts';
import { drawRevolution } from './revolve.ts';

/** A sphere. */
export interface Sphere {
  readonly kind: 'sphere';
  readonly center: Vec3;
  readonly radius: number;
}

const d = (axis: Axis): Expr => comp('d', axis);
const p = (axis: Axis): Expr => minus(comp('E', axis), comp('C', axis));
const n = (axis: Axis): Expr => minus(scalar(axis), comp('C', axis));
const square = (): Expr => squared(scalar('r'));

const surface = lazily(
  (): Relation => ({
    left: plus(...AXES.map((axis) => squared(n(axis)))),
    relation: '=',
    right: square(),
  }),
);

const formula = lazily(
  (): CurvedFormula => ({
    family: 'curved',
    A: plus(...AXES.map((axis) => squared(d(axis)))),
    B: plus(...AXES.map((axis) => times(num(2), d(axis), p(axis)))),
    C: signedSum(...AXES.map((axis): [1, Expr] => [1, squared(p(axis))]), [-1, square()]),
    moment: momentAbout('C'),
    // Lagrange's identity: (d·d)(p·p) − (d·p)² = |d × p|².
    momentD: times(
      num(4),
      minus(times(square(), scalar('A')), plus(...components('m').map(squared))),
    ),
    normal: [n('x'), n('y'), n('z')],
  }),
);

/** The round quadric with a = −1 and ρ = r². Its trees have their own order of terms. */
const NUMBERS: QuadricNumbers<Sphere> = {
  family: 'quadric',
  read: ({ center: C, radius }) => ({
    Cx: C[0],
    Cy: C[1],
    Cz: C[2],
    hasY: true,
    flare: -1,
    squared: false,
    r: radius,
    hasR: true,
  }),
  holds: ({ center, radius }, q) => radius === q.r && isAt(center, q),
};

const CENTRE: Naming = { name: 'point', singular: 'the centre', straight: null, border: [] };

/**
 * A sphere.
 * The entry of SHAPES, for `prepareWith`.
 */
export const sphere: ShapeDefinition<Sphere> = {
  kind: 'sphere',
  title: 'sphere',
  named: ({ radius }) => (radius === 0 ? CENTRE : SPHERE),
  icon: 'M3.5 12a8.5 8.5 0 0 0 17 0a8.5 8.5 0 0 0 -17 0M3.5 12a8.5 3.2 0 0 0 17 0',
  params: [
    { ...POINT, key: 'center', symbol: 'C', title: 'centre', initial: [0, 1, 0] },
    { ...LENGTH, key: 'radius', symbol: 'r', title: 'radius', initial: 1.5 },
  ],
  get surface() {
    return surface();
  },
  formula,
  values: ({ center, radius }) => ({ scalars: { r: radius }, vectors: { C: center } }),
  numbers: NUMBERS,
  body: lazily(() => quadricBody(NUMBERS.read)),
  ownFamilies: false,
  meaning: ({ radius }) => (radius === 0 ? 'r = 0: only the centre is left' : ''),
  anchor: ({ center, radius }) => ({ at: center, size: radius }),
  draw: ({ center, radius }, stage) => ({
    ...drawRevolution({ center, a: -1, r: radius }, 'C', stage),
    // A sphere has no axis of its own.
    lines: [],
    grips: [pointGrip('center', center), radiusGrip('radius', center, radius)],
  }),
};

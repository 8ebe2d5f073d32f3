import { scalar, squared } from '../formula/expr.ts';
import { lazily } from '../lazily.ts';
import type { Vec3 } from '../vec3.ts';
import { type AxialQuadric, axialFormula, axialSurface } from './axial-quadric.ts';
import { quadricBody } from './body.ts';
import { AXIS, CYLINDER, type ShapeDefinition } from './define.ts';
import { pointGrip, radiusGrip } from './grips.ts';
import { isAt, type QuadricNumbers } from './numbers.ts';
import { LENGTH, POINT } from './params.ts';
import { axisPoint, drawRevolution } from './revolve.ts';
import { short, shortPoint } from './short.ts';

/** Axis parallel to y; the centre's y does not matter. */
export interface Cylinder {
  readonly kind: 'cylinder';
  readonly center: Vec3;
  readonly radius: number;
}

const quadric = lazily((): AxialQuadric => ({ center: 'C', a: null, rho: squared(scalar('r')) }));
const surface = lazily(() => axialSurface(quadric()));
const formula = lazily(() => axialFormula(quadric()));

const NUMBERS: QuadricNumbers<Cylinder> = {
  family: 'quadric',
  read: ({ center: C, radius }) => ({
    Cx: C[0],
    Cy: C[1],
    Cz: C[2],
    hasY: false,
    flare: 0,
    squared: false,
    r: radius,
    hasR: true,
  }),
  holds: ({ center, radius }, q) => radius === q.r && isAt(center, q),
};

/**
 * An endless cylinder about an axis parallel to y.
 * The entry of SHAPES, for `prepareWith`.
 */
export const cylinder: ShapeDefinition<Cylinder> = {
  kind: 'cylinder',
  title: 'cylinder',
  named: ({ radius }) => (radius === 0 ? AXIS : CYLINDER),
  icon: 'M6 6v12a6 2.4 0 0 0 12 0V6M6 6a6 2.4 0 0 0 12 0a6 2.4 0 0 0 -12 0',
  params: [
    { ...POINT, key: 'center', symbol: 'C', title: 'centre of the axis', initial: [0, 1, 0] },
    { ...LENGTH, key: 'radius', symbol: 'r', title: 'radius', initial: 1.5 },
  ],
  get surface() {
    return surface();
  },
  formula,
  values: ({ center, radius }) => ({ scalars: { r: radius }, vectors: { C: center } }),
  numbers: NUMBERS,
  body: lazily(() => quadricBody(NUMBERS.read)),
  ownFamilies: true,
  meaning: ({ radius }) => (radius === 0 ? 'r = 0: only the axis is left' : ''),
  anchor: ({ center, radius }) => ({ at: center, size: radius }),
  circleNear({ center, radius, ...rest }, height, hypotenuse, bits) {
    const unit = short(radius / hypotenuse, bits);
    const shape = { ...rest, center: shortPoint(center, bits), radius: unit * hypotenuse };
    return { shape, height: short(height, bits), unit, out: 0, up: 1 };
  },
  draw({ center, radius }, stage) {
    const middle = axisPoint(center, stage);
    return {
      ...drawRevolution({ center, a: 0, r: radius }, 'C', stage),
      grips: [pointGrip('center', middle), radiusGrip('radius', middle, radius)],
    };
  },
};

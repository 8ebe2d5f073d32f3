import { scalar, squared } from '../formula/expr.ts';
import { lazily } from '../lazily.ts';
import type { Vec3 } from '../vec3.ts';
import { type AxialQuadric, axialFormula, axialSurface } from './axial-quadric.ts';
import { quadricBody } from './body.ts';
import { AXIS, CONE, CYLINDER, type Naming, type ShapeDefinition, SPHERE } from './define.ts';
import { flareGrip, pointGrip, radiusGrip } from './grips.ts';
import { isAt, type QuadricNumbers } from './numbers.ts';
import { LENGTH, POINT } from './params.ts';
import { drawRevolution } from './revolve.ts';
import { short, shortPoint } from './short.ts';

/**
 * Axis parallel to y: at height h from the centre the circle has radius √(flare · h² + radius²).
 */
export interface Hyperboloid {
  readonly kind: 'hyperboloid';
  readonly center: Vec3;
  readonly flare: number;
  readonly radius: number;
}

const quadric = lazily(
  (): AxialQuadric => ({ center: 'C', a: scalar('a'), rho: squared(scalar('r')) }),
);
const surface = lazily(() => axialSurface(quadric()));
const formula = lazily(() => axialFormula(quadric()));

const NUMBERS: QuadricNumbers<Hyperboloid> = {
  family: 'quadric',
  read: ({ center: C, flare, radius }) => ({
    Cx: C[0],
    Cy: C[1],
    Cz: C[2],
    hasY: true,
    flare,
    squared: false,
    r: radius,
    hasR: true,
  }),
  holds: ({ center, flare, radius }, q) => flare === q.flare && radius === q.r && isAt(center, q),
};

/**
 * A hyperboloid of one sheet about an axis parallel to y; an ellipsoid for a < 0.
 * The entry of SHAPES, for `prepareWith`.
 */
export const hyperboloid: ShapeDefinition<Hyperboloid> = {
  kind: 'hyperboloid',
  title: 'hyperboloid',
  alsoCalled: { ellipsoid: 'a < 0' },
  named: ({ flare, radius }) => nameOf(flare, radius),
  icon:
    'M6 4.4a6 1.9 0 0 0 12 0a6 1.9 0 0 0 -12 0c3.6 5 3.6 10.2 0 15.2a6 1.9 0 0 0 12 0c-3.6 ' +
    '-5 -3.6 -10.2 0 -15.2',
  params: [
    { ...POINT, key: 'center', symbol: 'C', title: 'centre', initial: [0, 1, 0] },
    {
      type: 'number',
      key: 'flare',
      symbol: 'a',
      title: 'flare',
      initial: 1,
      linkDefault: 0.4,
      range: [-2, 2],
      step: 0.05,
      unit: 'ratio',
    },
    {
      ...LENGTH,
      key: 'radius',
      symbol: 'r',
      title: 'radius of the waist',
      initial: 0.5,
      linkDefault: 1,
    },
  ],
  get surface() {
    return surface();
  },
  formula,
  values: ({ center, flare, radius }) => ({
    scalars: { a: flare, r: radius },
    vectors: { C: center },
  }),
  numbers: NUMBERS,
  body: lazily(() => quadricBody(NUMBERS.read)),
  ownFamilies: true,
  meaning: ({ flare, radius }) => meaningOf(flare, radius),
  anchor: ({ center, radius }) => ({ at: center, size: radius }),
  circleNear({ center, flare, radius, ...rest }, height, hypotenuse, bits) {
    const at = shortPoint(center, bits);
    const r = Math.abs(radius);
    if (Math.abs(height) * 16 < r) {
      const unit = short(r / hypotenuse, bits);
      const shape = { ...rest, center: at, flare: short(flare, bits), radius: unit * hypotenuse };
      return { shape, height: 0, unit, out: 0, up: 1 };
    }
    // R² − r² = a h² by its factors: R − r = λh, R + r = μh, a = λμ.
    const ratio = r / Math.abs(height);
    const root = Math.sqrt(ratio * ratio + flare);
    if (!(root > 0)) return null;
    const lambda = short(flare / (ratio + root), bits);
    const w = short(root / hypotenuse, bits);
    const mu = 2 * hypotenuse * w - lambda;
    const k = short(Math.abs(height), bits);
    const a = lambda * mu;
    const shape = { ...rest, center: at, flare: a, radius: (k * (mu - lambda)) / 2 };
    const side = height < 0 ? -1 : 1;
    return {
      shape,
      height: side * k,
      unit: k * w,
      out: side * a,
      up: w * hypotenuse * hypotenuse,
    };
  },
  draw: ({ center, flare, radius }, stage) => ({
    ...drawRevolution({ center, a: flare, r: radius }, 'C', stage),
    grips: [
      pointGrip('center', center),
      flareGrip('flare', { center, a: flare, r: radius }, stage),
      radiusGrip('radius', center, radius),
    ],
  }),
};

/** What (x−Cx)² + (z−Cz)² = a(y−Cy)² + r² is, as a and r move. */
function nameOf(a: number, r: number): Naming {
  if (r === 0) {
    if (a > 0) return CONE;
    return a === 0 ? AXIS : { ...CLOSED, name: 'point', singular: 'the centre' };
  }
  if (a === 0) return CYLINDER;
  if (a < 0) return a === -1 ? SPHERE : { ...CLOSED, name: 'ellipsoid' };
  return { name: 'hyperboloid', singular: null, straight: 'a generator', border: [] };
}

const CLOSED = { singular: null, straight: null, border: [] } as const;

function meaningOf(a: number, r: number): string {
  if (r === 0) {
    if (a > 0) return 'r = 0: a cone';
    return a === 0
      ? 'r = 0, a = 0: only the axis is left'
      : 'r = 0, a < 0: only the centre is left';
  }
  if (a === 0) return 'a = 0: a cylinder';
  if (a === -1) return 'a = −1: a sphere';
  return a < 0 ? 'a < 0: an ellipsoid' : 'at h above C: √(ah² + r²)';
}

import { scalar, squared } from '../formula/expr.ts';
import { lazily } from '../lazily.ts';
import type { Vec3 } from '../vec3.ts';
import { type AxialQuadric, axialFormula, axialSurface } from './axial-quadric.ts';
import { quadricBody } from './body.ts';
import { AXIS, CONE, type ShapeDefinition } from './define.ts';
import { pointGrip, slopeGrip } from './grips.ts';
import { isAt, type QuadricNumbers } from './numbers.ts';
import { POINT } from './params.ts';
import { drawRevolution } from './revolve.ts';
import { short, shortPoint } from './short.ts';

/**
 * Axis parallel to y, both nappes: at height h above the vertex the circle has radius |slope · h|.
 */
export interface Cone {
  readonly kind: 'cone';
  readonly vertex: Vec3;
  readonly slope: number;
}

const quadric = lazily((): AxialQuadric => ({ center: 'V', a: squared(scalar('c')), rho: null }));
const surface = lazily(() => axialSurface(quadric()));
const formula = lazily(() => axialFormula(quadric()));

const NUMBERS: QuadricNumbers<Cone> = {
  family: 'quadric',
  read: ({ vertex: V, slope }) => ({
    Cx: V[0],
    Cy: V[1],
    Cz: V[2],
    hasY: true,
    flare: slope,
    squared: true,
    r: 0,
    hasR: false,
  }),
  holds: ({ vertex, slope }, q) => slope === q.flare && isAt(vertex, q),
};

/**
 * Both nappes of a cone about an axis parallel to y.
 * The entry of SHAPES, for `prepareWith`.
 */
export const cone: ShapeDefinition<Cone> = {
  kind: 'cone',
  title: 'cone',
  named: ({ slope }) => (slope === 0 ? AXIS : CONE),
  icon: 'M6 4.4a6 1.9 0 0 0 12 0a6 1.9 0 0 0 -12 0L18 19.6a6 1.9 0 0 1 -12 0L18 4.4',
  params: [
    {
      ...POINT,
      key: 'vertex',
      symbol: 'V',
      title: 'vertex',
      initial: [0, 2.5, 0],
      linkDefault: [0, 3, 0],
    },
    {
      type: 'number',
      key: 'slope',
      symbol: 'c',
      title: 'slope',
      initial: 1,
      linkDefault: 0.5,
      range: [0, 2],
      step: 0.02,
      unit: 'ratio',
    },
  ],
  get surface() {
    return surface();
  },
  formula,
  values: ({ vertex, slope }) => ({ scalars: { c: slope }, vectors: { V: vertex } }),
  numbers: NUMBERS,
  body: lazily(() => quadricBody(NUMBERS.read)),
  ownFamilies: true,
  meaning: ({ slope }) =>
    slope === 0 ? 'c = 0: only the axis is left' : 'at h above V: radius |ch|',
  anchor: ({ vertex }) => ({ at: vertex, size: 0 }),
  circleNear({ vertex, slope, ...rest }, height, hypotenuse, bits) {
    const c = short(slope, bits);
    const k = short(height / hypotenuse, bits);
    const shape = { ...rest, vertex: shortPoint(vertex, bits), slope: c };
    // On the lower nappe the radius is −c times the height.
    const side = c * k < 0 ? -1 : 1;
    return { shape, height: k * hypotenuse, unit: side * c * k, out: side * c, up: hypotenuse };
  },
  draw: ({ vertex, slope }, stage) => ({
    ...drawRevolution({ center: vertex, a: slope * slope, r: 0 }, 'V', stage),
    grips: [pointGrip('vertex', vertex), slopeGrip('slope', vertex, slope, stage)],
  }),
};

import { lazily } from '../lazily.ts';
import type { Vec3 } from '../vec3.ts';
import { planarBody } from './body.ts';
import type { ShapeDefinition } from './define.ts';
import { drawPlane } from './flat-drawing.ts';
import { pointGrip } from './grips.ts';
import type { PlanarNumbers } from './numbers.ts';
import { NORMAL, POINT } from './params.ts';
import { planarFormula, planarSurface } from './planar.ts';

/** A whole plane. */
export interface Plane {
  readonly kind: 'plane';
  readonly normal: Vec3;
  readonly point: Vec3;
}

const surface = lazily(() => planarSurface('P'));
const formula = lazily(() => planarFormula('P', null));

const NUMBERS: PlanarNumbers<Plane> = {
  family: 'planar',
  read: ({ normal, point }) => ({ N: normal, P: point, bound: 'none', size: 0, u: 0, v: 0 }),
};

/**
 * A whole plane.
 * The entry of SHAPES, for `prepareWith`.
 */
export const plane: ShapeDefinition<Plane> = {
  kind: 'plane',
  title: 'plane',
  named: () => ({ name: 'plane', singular: null, straight: null, border: [] }),
  icon: 'M6.5 7.5h14l-4.5 9h-14z',
  params: [
    { ...NORMAL, initial: [1, 0.5, 0.5], linkDefault: [1, 1, 0.5] },
    { ...POINT, key: 'point', symbol: 'P', title: 'point of the plane', initial: [0, 1, 0] },
  ],
  get surface() {
    return surface();
  },
  formula,
  values: ({ normal, point }) => ({ scalars: {}, vectors: { N: normal, P: point } }),
  numbers: NUMBERS,
  body: lazily(() => planarBody(NUMBERS.read)),
  ownFamilies: true,
  meaning: () => '',
  anchor: ({ point }) => ({ at: point, size: 0 }),
  draw: ({ normal, point }, stage) => ({
    ...drawPlane(normal, point, stage),
    grips: [pointGrip('point', point)],
  }),
};

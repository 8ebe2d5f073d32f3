import { components, momentAbout } from '../formula/common.ts';
import {
  comp,
  type Expr,
  minus,
  negative,
  num,
  over,
  plus,
  type Relation,
  scalar,
  signedSum,
  squared,
  times,
} from '../formula/expr.ts';
import { lazily } from '../lazily.ts';
import type { Axis, Vec3 } from '../vec3.ts';
import type { CurvedFormula } from './axial-quadric.ts';
import { type Body, roomyBox } from './body.ts';
import { AXIS, type Naming, type ShapeDefinition } from './define.ts';
import type { Patch, Stage } from './drawing.ts';
import { pointGrip, widthGrip } from './grips.ts';
import { POINT } from './params.ts';
import { aboutAxis, type Heights, type Piece, revolvedPatch } from './revolve.ts';

/** Axis parallel to y: at height h above the vertex the circle has radius √(width · h). */
export interface Paraboloid {
  readonly kind: 'paraboloid';
  readonly vertex: Vec3;
  /** k, of any sign; a length. */
  readonly width: number;
}

const d = (axis: Axis): Expr => comp('d', axis);
const p = (axis: Axis): Expr => minus(comp('E', axis), comp('V', axis));
const n = (axis: Axis): Expr => minus(scalar(axis), comp('V', axis));

const surface = lazily(
  (): Relation => ({
    left: plus(squared(n('x')), squared(n('z'))),
    relation: '=',
    right: times(scalar('k'), n('y')),
  }),
);

const formula = lazily((): CurvedFormula => {
  const k = scalar('k');
  const [mx, my, mz] = components('m');
  return {
    family: 'curved',
    A: plus(squared(d('x')), squared(d('z'))),
    B: signedSum(
      [1, times(num(2), d('x'), p('x'))],
      [1, times(num(2), d('z'), p('z'))],
      [-1, times(k, d('y'))],
    ),
    C: signedSum([1, squared(p('x'))], [1, squared(p('z'))], [-1, times(k, p('y'))]),
    moment: momentAbout('V'),
    // B² − 4AC with p only in m = d × p: the terms in py add up to dx·mz − dz·mx.
    momentD: signedSum(
      [1, times(squared(k), squared(d('y')))],
      [1, times(num(4), k, minus(times(d('x'), mz), times(d('z'), mx)))],
      [-1, times(num(4), squared(my))],
    ),
    normal: [n('x'), negative(over(k, num(2))), n('z')],
  };
});

/**
 * √(kh), 0 on the side where there is no surface. As a product of roots: kh need not be a double.
 */
const radiusAt = (width: number, h: number): number =>
  width < 0 === h < 0 ? Math.sqrt(Math.abs(width)) * Math.sqrt(Math.abs(h)) : 0;

const body: Body<Paraboloid> = {
  box({ vertex, width }, between) {
    if (!between) return null;
    const [low, high] = [between[0] - vertex[1], between[1] - vertex[1]];
    const widest = Math.max(radiusAt(width, low), radiusAt(width, high));
    return roomyBox([-widest, low, -widest], [widest, high, widest], vertex);
  },
  circleAt({ vertex, width }, y) {
    const radius = radiusAt(width, y - vertex[1]);
    return radius > 0 ? { x: vertex[0], z: vertex[2], radius } : null;
  },
  convex: () => true,
};

const PARABOLOID: Naming = {
  name: 'paraboloid',
  singular: null,
  straight: 'the axis',
  border: [],
};

/**
 * A paraboloid about an axis parallel to y, open upwards for k > 0.
 * The entry of SHAPES, for `prepareWith`.
 */
export const paraboloid: ShapeDefinition<Paraboloid> = {
  kind: 'paraboloid',
  title: 'paraboloid',
  named: ({ width }) => (width === 0 ? AXIS : PARABOLOID),
  icon: 'M5 5a7 2 0 0 0 14 0a7 2 0 0 0 -14 0c1.6 9.5 4 15 7 15s5.4 -5.5 7 -15',
  params: [
    {
      ...POINT,
      key: 'vertex',
      symbol: 'V',
      title: 'vertex',
      initial: [0, 1, 0],
      linkDefault: [0, 0, 0],
    },
    {
      type: 'number',
      key: 'width',
      symbol: 'k',
      title: 'width',
      initial: 1,
      linkDefault: 2,
      range: [-4, 4],
      step: 0.05,
      unit: 'length',
    },
  ],
  get surface() {
    return surface();
  },
  formula,
  values: ({ vertex, width }) => ({ scalars: { k: width }, vectors: { V: vertex } }),
  numbers: null,
  body: () => body,
  ownFamilies: false,
  meaning: ({ width }) =>
    width === 0 ? 'k = 0: only the axis is left' : 'at h above V: radius √(kh)',
  anchor: ({ vertex }) => ({ at: vertex, size: 0 }),
  draw({ vertex, width }, stage) {
    return {
      ...aboutAxis(patches(vertex, width, stage), vertex, 'V', stage),
      grips: [pointGrip('vertex', vertex), widthGrip('width', vertex, width, stage)],
    };
  },
};

/** From the vertex to the end of the stage, not wider than the stage. */
function patches(vertex: Vec3, width: number, stage: Stage): Patch[] {
  if (width === 0) return [];
  const { low, high } = stage;
  const y = vertex[1];
  const widest = stage.radius * 1.15;
  const reach = widest * (widest / width);
  const piece: Piece =
    width > 0
      ? {
          from: Math.max(low, y),
          to: Math.min(high, y + reach),
          start: low > y ? 'rim' : 'point',
          end: 'goes-on',
        }
      : {
          from: Math.max(low, y + reach),
          to: Math.min(high, y),
          start: 'rim',
          end: high < y ? 'goes-on' : 'point',
        };
  if (!(piece.from < piece.to)) return [];
  const radius = (height: number): number => radiusAt(width, height - y);
  const spread = radiusSteps(radius, y, width, piece);
  return [revolvedPatch(vertex, radius, () => -width / 2, piece, spread, stage)];
}

/** Steps of equal radius, so that the vertex is round in the picture. */
function radiusSteps(
  radius: (y: number) => number,
  vertex: number,
  width: number,
  { from, to }: Piece,
): Heights {
  const first = radius(from);
  const whole = radius(to) - first;
  return {
    at(v) {
      const r = first + whole * v;
      return Math.min(to, Math.max(from, vertex + r * (r / width)));
    },
    inverse: (y) => (radius(y) - first) / whole,
  };
}

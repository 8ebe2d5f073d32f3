import { components, momentAbout } from '../../src/math/formula/common.ts';
import {
  comp,
  type Expr,
  minus,
  num,
  plus,
  scalar,
  signedSum,
  squared,
  times,
} from '../../src/math/formula/expr.ts';
import { UNKNOWN_BODY } from '../../src/math/shapes/body.ts';
import type { ShapeDefinition } from '../../src/math/shapes/define.ts';
import type { Patch, Stage } from '../../src/math/shapes/drawing.ts';
import { pointGrip } from '../../src/math/shapes/grips.ts';
import { LENGTH, POINT } from '../../src/math/shapes/params.ts';
import type { Axis, Vec3 } from '../../src/math/vec3.ts';

/*
 * A shape that is not Graze's own, as a newcomer would add it: with the least that an entry may
 * say.
 */

/** (x − Cx)² + 4(z − Cz)² = r². */
interface EllipticCylinder {
  readonly kind: 'elliptic-cylinder';
  readonly center: Vec3;
  readonly radius: number;
}

const d = (axis: Axis): Expr => comp('d', axis);
const p = (axis: Axis): Expr => minus(comp('E', axis), comp('C', axis));
const n = (axis: Axis): Expr => minus(scalar(axis), comp('C', axis));
const [, my] = components('m');

export const ellipticCylinder: ShapeDefinition<EllipticCylinder> = {
  kind: 'elliptic-cylinder',
  title: 'elliptic cylinder',
  named: () => ({
    name: 'elliptic cylinder',
    singular: null,
    straight: 'the axis',
    border: [],
  }),
  icon: 'M6 6v12a6 2.4 0 0 0 12 0V6',
  params: [
    { ...POINT, key: 'center', symbol: 'C', title: 'centre', initial: [0, 1, 0] },
    { ...LENGTH, key: 'radius', symbol: 'r', title: 'half width', initial: 1.5 },
  ],
  surface: {
    left: plus(squared(n('x')), times(num(4), squared(n('z')))),
    relation: '=',
    right: squared(scalar('r')),
  },
  formula: () => FORMULA,
  values: ({ center, radius }) => ({ scalars: { r: radius }, vectors: { C: center } }),
  numbers: null,
  body: () => UNKNOWN_BODY,
  ownFamilies: false,
  meaning: () => '',
  anchor: ({ center, radius }) => ({ at: center, size: radius }),
  draw: (shape, stage) => ({
    patches: shape.radius > 0 ? [patchOf(shape, stage)] : [],
    lines: [],
    marks: [{ symbol: 'C', at: shape.center }],
    normals: [],
    grips: [pointGrip('center', shape.center)],
  }),
};

const FORMULA = {
  family: 'curved',
  A: plus(squared(d('x')), times(num(4), squared(d('z')))),
  B: plus(times(num(2), d('x'), p('x')), times(num(8), d('z'), p('z'))),
  C: signedSum(
    [1, squared(p('x'))],
    [1, times(num(4), squared(p('z')))],
    [-1, squared(scalar('r'))],
  ),
  moment: momentAbout('C'),
  // B² − 4AC with p only in m = d × p: (dx·px + 4dz·pz)² − (dx² + 4dz²)(px² + 4pz²) = −4my².
  momentD: signedSum(
    [1, times(num(4), squared(scalar('r')), scalar('A'))],
    [-1, times(num(16), squared(my))],
  ),
  normal: [n('x'), num(0), times(num(4), n('z'))],
} as const;

function patchOf({ center: [x, , z], radius }: EllipticCylinder, { low, high }: Stage): Patch {
  const about = (u: number): readonly [number, number] => [
    radius * Math.sin(2 * Math.PI * u),
    (radius / 2) * Math.cos(2 * Math.PI * u),
  ];
  return {
    at(u, v) {
      const [dx, dz] = about(u);
      return [x + dx, low + (high - low) * v, z + dz];
    },
    normal(u) {
      const [dx, dz] = about(u);
      return [dx, 0, 4 * dz];
    },
    closed: true,
    rings: [],
    start: 'rim',
    end: 'goes-on',
    sides: 'joins',
    stepsV: 1,
  };
}

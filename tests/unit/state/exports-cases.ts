import { intersect, type Solid } from '../../../src/math/index.ts';
import type { Ray } from '../../../src/math/ray.ts';
import type { Shape } from '../../../src/math/shapes/index.ts';
import type { EndsValue } from '../../../src/state/actions.ts';
import { createDerive, type ExploreModel } from '../../../src/state/derive.ts';
import { exploreDetails } from '../../../src/state/explore-details.ts';
import { INITIAL } from '../../../src/state/state.ts';
import { share } from '../many.ts';
import { rayCases } from '../math/read-vectors.ts';
import { circle, cone, cylinder, hyperboloid, plane, ray, square } from '../math/shorthand.ts';

export interface ExportCase {
  readonly name: string;
  readonly shape: Shape;
  readonly ray: Ray;
  readonly ends?: EndsValue;
}

const at = (name: string, shape: Shape, r: Ray): ExportCase => ({ name, shape, ray: r });
const ended = (
  name: string,
  shape: Shape,
  r: Ray,
  low: number,
  high: number,
  caps: boolean,
): ExportCase => ({ name, shape, ray: r, ends: { between: [low, high], caps } });
const axis = cylinder([0, 0, 0], 2);
const disc = circle([0, 0, 2], [1, 1, 5], 5);
const tile = square([1, 2, 3], 2, 'y');

/** Every shape in every class it can answer, and the numbers at which programs go wrong. */
export const EXPORT_CASES: readonly ExportCase[] = [
  at('cylinder, two', cylinder([1, 7, 2], 2.3), ray([5, 1, 2], [-1, 0.5, 0.1])),
  at('cylinder, tangent', axis, ray([2, 3, 5], [0, 1, -2])),
  at('cylinder, none', axis, ray([3, 3, 5], [0, 1, -2])),
  at('cylinder, A = 0, inside', axis, ray([1, 0, 0], [0, 1, 0])),
  at('cylinder, A = 0, contained', axis, ray([2, 0, 0], [0, -1, 0])),
  at('cylinder, both roots behind', axis, ray([5, 1, 0.3], [1, 0, 0])),
  at('cylinder, t = −0 at E', axis, ray([2, 0, 0], [1, 0, 0])),
  at('cylinder, radius 0, singular', cylinder([0, 0, 0], 0), ray([2, 0, 0], [-1, 0, 0])),
  at('cylinder, far away', axis, ray([1e9, 0.1, 1], [-1, 0.3, 1e-9])),
  at('cylinder, tangent in doubles only', axis, ray([1e9, 0, 1.9], [-1, 0, 0])),
  at('cylinder, D overflows', axis, ray([1e200, 0, 0], [-1e100, 0, 0])),
  at('cylinder, D is −∞', axis, ray([0, 0, 1e100], [1e150, 0, 0])),
  at('cylinder, A overflows', axis, ray([1, 0, 0], [1e160, 0, 0])),
  at('cylinder, t overflows', cylinder([0, 0, 0], 9e153), ray([1e154, 0, 0], [1e-155, 1, 1e-155])),
  at(
    'cylinder, double t overflows',
    cylinder([0, 0, 0], 0),
    ray([2 ** 511, 0, 2 ** 511], [2 ** -515, 1, 2 ** -515]),
  ),
  at('cylinder, A underflows, t overflows', axis, ray([1e150, 0, 0], [1e-170, 1, 1e-170])),
  at('cylinder, C overflows', axis, ray([1e200, 0, 0], [0, 1, 0])),
  at('cylinder, A underflows', axis, ray([1, 0, 0], [1e-170, 1, 0])),
  at('cone, two', cone([0, 3, 0], 0.5), ray([3, 1, 1], [-0.8, -0.2, -0.3])),
  at('cone, A < 0', cone([0, 0, 0], 2), ray([5, -1, 0.2], [1, 1, 0])),
  at('cone, negative slope', cone([1, -1, 0], -2), ray([4, 1, 2], [1, 1, 2])),
  at('cone, A = 0, one', cone([0, 0, 0], 1), ray([3, 1, 0], [1, 1, 0])),
  at('cone, A = B = 0, none', cone([0, 0, 0], 1), ray([2, 2, 3], [1, 1, 0])),
  at('cone, A = 0, B overflows', cone([0, 0, 0], 1), ray([1.3e154, 0, 0], [1.3e154, 1.3e154, 0])),
  at('cone, contained', cone([0, 0, 0], 1), ray([2, 2, 0], [1, 1, 0])),
  at('cone, through the vertex', cone([0, 1, 0], 0.5), ray([2, 1, 0], [-1, 0, 0])),
  at('cone, none', cone([0, 0, 0], 0.5), ray([3, 1, 0], [0, 0, 1])),
  at(
    'cone, slope 0 and an infinite point',
    cone([0, 0, 0], 0),
    ray([1e-160, 1, 0], [1e-160, 1e300, 0]),
  ),
  at('hyperboloid, two', hyperboloid([0, 1, -1], 0.3, 2.25), ray([1, -1, 0.25], [2, 2, 0])),
  at('hyperboloid, tangent', hyperboloid([0, 0, 0], -1, 1), ray([1, 3, 0], [0, -1, 0])),
  at('hyperboloid, ellipsoid missed', hyperboloid([0, 0, 0], -4, 1), ray([3, 3, 0], [0, -1, 0.5])),
  at('hyperboloid, one', hyperboloid([0, 0, 0], 1, 1), ray([3, 1, 0], [1, 1, 0])),
  at('hyperboloid, contained', hyperboloid([0, 0, 0], 1, 1), ray([1, 0, 0], [0, 1, 1])),
  at('hyperboloid, asymptote, none', hyperboloid([0, 0, 0], 1, 1), ray([0, 0, 0], [1, 1, 0])),
  at('hyperboloid, flare −0', hyperboloid([0, 0, 0], -0, 1), ray([3, -0, 0.1], [-1, -0, 0])),
  at(
    'hyperboloid, a normal that is no number',
    hyperboloid([0, 0, 0], 0, 0.5),
    ray([1, 0, 0], [-1e-160, 1e150, 0]),
  ),
  at('plane, one', plane([1, 1, 0.5], [0, 1, 0]), ray([3, 1, 1], [-0.8, -0.2, -0.3])),
  at('plane, behind', plane([2, 0, -1], [0, 1, 3]), ray([1, 1, 0], [1, 1, 0])),
  at('plane, parallel', plane([0, 2, 0], [0, 1, 0]), ray([1, 3, 0], [1, 0, -2])),
  at('plane, in it', plane([0, 2, 0], [0, 1, 0]), ray([1, 1, 0], [1, 0, -2])),
  at('plane, t = −0', plane([0, 1, 0], [0, 1, 0]), ray([-0, 1, 2], [-0, 1, 0])),
  at('plane, overflow', plane([1e300, 0, 0], [0, 0, 0]), ray([1e300, 0, 0], [1, 0, 0])),
  at('plane, N·d overflows', plane([1e300, 0, 0], [0, 0, 0]), ray([1, 0, 0], [1e300, 0, 0])),
  at('plane, parallel, overflow', plane([1e300, 0, 0], [0, 0, 0]), ray([1e300, 0, 0], [0, 1, 0])),
  at('plane, t overflows', plane([1e-300, 0, 0], [0, 0, 0]), ray([1e300, 0, 0], [1e-20, 1, 1])),
  at('plane, an infinite point', plane([1, 0, 0], [0, 0, 0]), ray([1e10, 0, 0], [-1, 1e300, 0])),
  at('circle, inside', circle([1, 0.5, 0], [0, 1, 0], 2), ray([3, 1, 1], [-0.8, -0.2, -0.3])),
  at('circle, on its rim', disc, ray([0, 0, 1], [2, 2.5, 2])),
  at('circle, outside', circle([0, 0, 2], [1, 1, 5], 4.5), ray([0, 0, 1], [2, 2.5, 2])),
  at('circle, parallel', disc, ray([0, 0, 1], [2, 2.5, 0])),
  at('circle, in its plane, across', disc, ray([0, 0, 5], [2, 2.5, 0])),
  at('circle, in its plane, beside', disc, ray([0, 90, 5], [1, 0, 0])),
  at('circle, overflow', disc, ray([1e200, 0, 1], [0, 0, 1])),
  at('square, inside', tile, ray([0, 6, 0], [0.5, -1, 1.1])),
  at('square, on its edge', tile, ray([1, 6, 0], [0, -1, 1])),
  at('square, outside in x', tile, ray([3, 6, 0], [0.5, -1, 1])),
  at('square, outside in x, lost in z', tile, ray([9, 6, 0], [0, -1, 1e308])),
  at('square, outside in z', tile, ray([0, 6, 2], [0.5, -1, 1])),
  at('square, axis x', square([1, 2, 3], 2, 'x'), ray([-1, 4, 2], [1, -0.5, 1])),
  at('square, axis z', square([1, 2, 3], 2, 'z'), ray([2, 3, 7], [0.25, 0, -2])),
  at('square, parallel', tile, ray([0, 6, 0], [1, 0, 1])),
  at('square, in its plane', tile, ray([0, 2, 3.5], [1, 0, 0.1])),
  ended('can, walls', axis, ray([5, 1, 0], [-1, 0.1, 0]), 0, 3, true),
  ended('can, caps', axis, ray([1, 5, 0.5], [-0.1, -1, 0]), -1, 2, true),
  ended('can, upwards', axis, ray([1, -5, 0.5], [-0.1, 1, 0]), -1, 2, true),
  ended('can, a cap and a wall', axis, ray([0, 4, 0], [1, -1, 0]), 0, 3, true),
  ended('can, along a rim', axis, ray([5, 3, 0], [-1, 0, 0]), 0, 3, true),
  ended('can, through a rim', axis, ray([4, 5, 0], [-1, -1, 0]), 0, 3, true),
  ended('can, in its wall', axis, ray([2, 9, 0], [0, -2, 0]), 0, 3, true),
  ended('can, along the axis', axis, ray([1, 9, 0], [0, -2, 0]), 0, 3, true),
  ended('can, beside', axis, ray([9, 9, 0], [0, -2, 0]), 0, 3, true),
  ended('pipe, through its open ends', axis, ray([1, 5, 0.5], [-0.1, -1, 0]), -1, 2, false),
  ended('cup of a cone', cone([0, 1, 0], 0.5), ray([3, 1, 0.1], [-1, 0.3, 0]), 1, 4, true),
  ended('cone, A < 0', cone([0, 0, 0], 2), ray([5, -1, 0.2], [1, 1, 0]), -2, 5, true),
  ended(
    'hyperboloid',
    hyperboloid([0, 1, -1], 0.3, 2.25),
    ray([1, -9, 0.25], [0.1, 2, 0]),
    0,
    2,
    true,
  ),
  ended(
    'ellipsoid',
    hyperboloid([0, 0, 0], -4, 1),
    ray([3, 0.3, 0], [-1, 0.01, 0.1]),
    -0.2,
    0.25,
    true,
  ),
  ended('can, D overflows', axis, ray([1e200, 0, 0], [-1e100, 1, 0]), 0, 3, true),
];

/** Rays of the hard families: every third of each, or of a quarter of them. */
export const HARD_CASES: readonly ExportCase[] = share(rayCases)
  .filter((_, i) => i % 3 === 0)
  .map(({ id, shape, ray: r }) => at(id, shape, r));

/** The page's model of a case. */
export function modelOf({ shape, ray: r, ends }: ExportCase, method = 'exact'): ExploreModel {
  return createDerive(() => exploreDetails)({
    ...INITIAL,
    kind: shape.kind,
    shapes: { ...INITIAL.shapes, [shape.kind]: shape },
    E: r.origin,
    d: r.direction,
    method,
    ...ends,
  });
}

/** What the exported programs have to print: the textbook method's answer, every bit of it. */
export function textbookAnswer({ shape, ray: r, ends }: ExportCase) {
  const { class: verdict, hits } = intersect({ ...shape, ...ends } as Solid, r, 'textbook');
  return {
    class: verdict,
    hits: hits.map(({ t, point, normal, singular, fate }) => ({
      ...{ t, point, normal, singular },
      ...(fate && { fate }),
    })),
  };
}

import {
  alongAxes,
  comp,
  type Expr,
  type ExprTriple,
  evaluate,
  evaluateTriple,
  float64,
  minus,
  negative,
  num,
  over,
  plus,
  root,
  scalar,
  squared,
  squaredNorm,
  times,
  type Values,
  withScalars,
  withVector,
} from '../math/formula.ts';
import type { Vec3 } from '../math/index.ts';
import type { Camera } from './types.ts';

/*
 * From a pixel to its ray, as formulas: the tracer's camera is made of them, and the page writes
 * them down. E is the eye, T the target, α the full vertical angle of view, W and H the picture's
 * size in pixels; x counts pixels from the left and y from the top, i and j the n · n rays of a
 * pixel.
 */

const [h, u, v] = ['h', 'u', 'v'].map(scalar) as [Expr, Expr, Expr];
const [W, H, n] = ['W', 'H', 'n'].map(scalar) as [Expr, Expr, Expr];
const HALF = num(0.5);

/** F, from the eye to the target. */
export const TO_TARGET: ExprTriple = alongAxes((axis) => minus(comp('T', axis), comp('E', axis)));

const lengthOf = (vector: string): Expr =>
  root(plus(squared(comp(vector, 'x')), squared(comp(vector, 'y')), squared(comp(vector, 'z'))));

/** λ = |F| */
export const DISTANCE = lengthOf('F');

/** g, the direction of view. */
export const VIEW_DIRECTION: ExprTriple = alongAxes((axis) => over(comp('F', axis), scalar('λ')));

const level = root(plus(squared(comp('g', 'z')), squared(comp('g', 'x'))));

/** s, to the right: level, and at right angles to g. */
export const SIDE: ExprTriple = [
  over(negative(comp('g', 'z')), level),
  num(0),
  over(comp('g', 'x'), level),
];

/** s for a view straight up or down: the picture's top is then towards −z. */
export const STEEP_SIDE: ExprTriple = [num(1), num(0), num(0)];

/** w = s × g, without the products with sy, which is 0. */
export const UPRIGHT: ExprTriple = [
  negative(times(comp('s', 'z'), comp('g', 'y'))),
  minus(times(comp('s', 'z'), comp('g', 'x')), times(comp('s', 'x'), comp('g', 'z'))),
  times(comp('s', 'x'), comp('g', 'y')),
];

/** h = tan(α/2), half the picture's height at distance 1; `angle` in degrees. */
const halfHeight = (angle: number): number => Math.tan((angle * Math.PI) / 360);

/** R, half the picture's width at distance 1. */
export const RIGHT: ExprTriple = alongAxes((axis) => times(h, over(W, H), comp('s', axis)));

/** U, half its height. */
export const UP: ExprTriple = alongAxes((axis) => times(h, comp('w', axis)));

/** Middle of a ray's share of the pixel, from the pixel's edge: half a pixel for one ray. */
const middle = (index: string, alone: boolean): Expr =>
  alone ? HALF : over(plus(scalar(index), HALF), n);

/** u, from −1 at the picture's left edge to 1 at the right one. */
export const across = (alone: boolean): Expr =>
  minus(over(times(num(2), plus(scalar('x'), middle('i', alone))), W), num(1));

/** v, from 1 at the top edge to −1 at the bottom. */
export const upwards = (alone: boolean): Expr =>
  minus(num(1), over(times(num(2), plus(scalar('y'), middle('j', alone))), H));

/** D, from the eye to the ray's point of the picture at distance 1. */
export const TO_PIXEL: ExprTriple = alongAxes((axis) =>
  plus(comp('g', axis), times(u, comp('R', axis)), times(v, comp('U', axis))),
);

/** μ = |D| */
export const PIXEL_DISTANCE = lengthOf('D');

/** d, of length 1. */
export const DIRECTION: ExprTriple = alongAxes((axis) => over(comp('D', axis), scalar('μ')));

/** Whether the view is straight up or down, where no direction is level and at right angles. */
export const isSteep = ({ vectors }: Values<number>): boolean =>
  vectors.g?.[0] === 0 && vectors.g?.[2] === 0;

/** What all pixels have in common: E, T, F, λ, g, s, w, h, R and U. */
export function cameraNumbers(
  { eye, target, angle }: Camera,
  width: number,
  height: number,
): Values<number> {
  const given: Values<number> = {
    scalars: { α: angle, W: width, H: height, h: halfHeight(angle) },
    vectors: { E: eye, T: target },
  };
  const F = evaluateTriple(TO_TARGET, float64, given);
  const { near, scale } = inRange(F);
  const λ = Math.sqrt(squaredNorm(near, float64));
  const g = evaluateTriple(VIEW_DIRECTION, float64, { scalars: { λ }, vectors: { F: near } });
  const seen = withVector(withScalars(withVector(given, 'F', F), { λ: λ / scale }), 'g', g);
  const flat = { scalars: {}, vectors: { g: inRange([g[0], 0, g[2]]).near } };
  const s = evaluateTriple(isSteep(seen) ? STEEP_SIDE : SIDE, float64, flat);
  return [['w', UPRIGHT] as const, ['R', RIGHT] as const, ['U', UP] as const].reduce(
    (values, [id, exprs]) => withVector(values, id, evaluateTriple(exprs, float64, values)),
    withVector(seen, 's', s),
  );
}

/** The vector times a power of 2, which is exact, so that no square over- or underflows. */
function inRange(v: Vec3): { readonly near: Vec3; readonly scale: number } {
  const size = Math.max(...v.map(Math.abs));
  const scale = size === 0 ? 1 : 2 ** Math.min(1023, -Math.floor(Math.log2(size)));
  return { near: [v[0] * scale, v[1] * scale, v[2] * scale], scale };
}

/** Those of one ray of a pixel besides: x, y, i, j, n, u, v, D, μ and d. */
export function pixelNumbers(
  camera: Values<number>,
  [x, y]: readonly [number, number],
  sample: number,
  samples: number,
): Values<number> {
  const side = Math.round(Math.sqrt(samples));
  const place = { x, y, i: sample % side, j: Math.floor(sample / side), n: side };
  const values = withScalars(camera, place);
  const alone = side === 1;
  const shifted = withScalars(values, {
    u: evaluate(across(alone), float64, values),
    v: evaluate(upwards(alone), float64, values),
  });
  const D = withVector(shifted, 'D', evaluateTriple(TO_PIXEL, float64, shifted));
  const stretched = withScalars(D, { μ: evaluate(PIXEL_DISTANCE, float64, D) });
  return withVector(stretched, 'd', evaluateTriple(DIRECTION, float64, stretched));
}

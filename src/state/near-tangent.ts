import type { Surd } from '../math/exact.ts';
import {
  evaluateTriple,
  exact,
  POINT,
  squaredNorm,
  valuesOf,
  withPoint,
  withScalars,
} from '../math/formula.ts';
import type { Ray, Shape } from '../math/index.ts';
import { definitionOf, nextDown, nextUp } from '../math/shapes.ts';
import { display } from '../text/format.ts';
import { exactText } from './exact-digits.ts';
import type { ExactResult } from './exact-result.ts';
import type { Handle } from './handles.ts';
import type { Tangency, Value } from './snap.ts';

/** Words on a ray that no neighbouring doubles bring nearer to tangency. */
export interface NearTangent {
  /** "touches as nearly as doubles can: D = −1.1 · 10⁻¹⁵; exactly, it misses by 1.2 · 10⁻¹⁶" */
  readonly text: string;
  /** Which number's neighbouring double gives D the other sign. */
  readonly reason: string;
}

/**
 * Largest ratio of |D| to B² + |4AC| at which neighbouring doubles are tried. A step of one ulp
 * changes D by far less.
 */
const SMALL = 1e-6;

/**
 * Set if D is not 0, and is 0 or has the other sign after a step of one ulp in a coordinate of E or
 * d, or in a number of the shape. Then no doubles lie between this ray and the other side.
 */
export function nearTangent(
  shape: Shape,
  ray: Ray,
  exactly: ExactResult,
  handles: readonly Handle[],
): NearTangent | null {
  const { details, hits } = exactly.found;
  if (details.family !== 'curved') return null;
  const { A, B, C, D, signs } = details;
  if (!signs.A || !signs.D || !(Math.abs(D) <= SMALL * (B * B + Math.abs(4 * A * C)))) return null;
  const side = signs.D;
  if (![...ray.origin, ...ray.direction, D].every(isOrdinary)) return null;
  const by = handles.find(({ tangency, value }) => tangency && turns(value, side, tangency));
  const exactD = exactly.quantities.D;
  if (!by || !exactD) return null;
  const gap = distanceToSurface(shape, ray, exactly);
  const apart = hits.length === 2 && exactly.quantities.A ? rootsApart(exactly) : null;
  const how =
    gap === null
      ? ''
      : `; exactly, it ${WORDS_BY_SIGNS[`${signs.D} ${signs.A}`]} ${display(gap, 2)}`;
  const between = apart ? `, t₂ − t₁ = ${apart}` : '';
  const text = `touches as nearly as doubles can: D = ${shortly(exactD)}${how}${between}`;
  return {
    text,
    reason: `At a neighbouring double of ${by.symbol}, D is 0 or has the other sign.`,
  };
}

/** Outside of this range exact numbers are too long to evaluate all neighbours at every step. */
const isOrdinary = (x: number): boolean => x === 0 || (Math.abs(x) < 1e50 && Math.abs(x) > 1e-50);

/** Words for the line at its point nearest to the surface, by the signs of D and A. */
const WORDS_BY_SIGNS: Readonly<Record<string, string>> = {
  '-1 1': 'misses by',
  '-1 -1': 'stays inside by',
  '1 1': 'goes in by',
  '1 -1': 'comes out by',
};

function rootsApart({ quantities: { A, D } }: ExactResult): string | null {
  if (!A || !D) return null;
  return shortly(exact.div(exact.sqrt(D), exact.sign(A) < 0 ? exact.neg(A) : A));
}

/** Two digits of a number; six if it is out of the doubles' range. */
function shortly(a: Surd): string {
  const x = exact.toNumber(a);
  return x === 0 || !Number.isFinite(x) ? exactText(a) : display(x, 2);
}

/** Whether steps of at most one ulp in the coordinates of a value change the sign of D. */
function turns(value: Value, side: number, { exact: ask }: Tangency): boolean {
  const parts = typeof value === 'number' ? [value] : [...value];
  const made = (next: readonly number[]): Value =>
    typeof value === 'number' ? (next[0] ?? value) : (next as unknown as Value);
  const largest = Math.max(...parts.map(Math.abs));
  const unit = nextUp(largest) - largest;
  const best = [...parts];
  for (const [i, x] of parts.entries()) {
    // Near 0 doubles are denser: every coordinate is moved by the ulp of the largest one.
    const steps = [Math.max(nextUp(x), x + unit), Math.min(nextDown(x), x - unit)];
    const asked = steps.map((to) => ({ to, probe: ask(made(parts.with(i, to))) }));
    if (asked.some(({ probe }) => probe.sign !== null && probe.sign !== side)) return true;
    const [a, b] = asked;
    if (a && b) best[i] = Math.abs(a.probe.size) < Math.abs(b.probe.size) ? a.to : b.to;
  }
  const { sign } = ask(made(best));
  return sign !== null && sign !== side;
}

/** Largest relative error of the distance by the surface's curvature. */
const LINEAR = 1e-3;

/**
 * How far the line stays from the surface, or goes beyond it: |f| / |∇F| where f turns, with
 * f = −D/4A, in exact arithmetic up to the last rounding. That is the first term of a series in f.
 * Null if the second term is larger than `LINEAR` times the first, as near a vertex.
 */
export function distanceToSurface(
  shape: Shape,
  ray: Ray,
  { quantities }: ExactResult,
): number | null {
  const { A, B, D } = quantities;
  const formula = definitionOf(shape).formula(shape);
  if (!A || !B || !D || formula.family !== 'curved') return null;
  const two = exact.of(2);
  const t = exact.neg(exact.div(B, exact.mul(two, A)));
  const f = exact.div(D, exact.mul(exact.of(4), A));
  const values = valuesOf(shape, ray, exact);
  const place = evaluateTriple(POINT, exact, withScalars(values, { t }));
  const half = evaluateTriple(formula.normal, exact, withPoint(values, place));
  const steep: Surd = squaredNorm(half, exact);
  if (exact.sign(steep) === 0) return null;
  const size = Math.abs(exact.toNumber(f));
  const slope = 2 * Math.sqrt(exact.toNumber(steep));
  // Second derivatives of F: 2 along x and z; along y twice the change of ½ ∂F/∂y from y to y + 1.
  const above = exact.add(place[1], exact.of(1));
  const next = evaluateTriple(
    formula.normal,
    exact,
    withPoint(values, [place[0], above, place[2]]),
  );
  const bend = 2 * Math.max(1, Math.abs(exact.toNumber(exact.sub(next[1], half[1]))));
  const found = size / slope;
  const isLinear = (found * bend) / slope < LINEAR;
  return found > 0 && Number.isFinite(found) && isLinear ? found : null;
}

import type { Sign } from './intersection.ts';
import type { ShapeDefinition } from './shapes/define.ts';

/** The same object, or the same kind with equal numbers: two such surfaces are one. */
export function isSameSurface<S extends { readonly kind: string }>(
  { params }: Pick<ShapeDefinition<S>, 'params'>,
  a: S,
  b: S,
): boolean {
  if (a === b) return true;
  if (a.kind !== b.kind) return false;
  const given = (shape: S, key: string): unknown =>
    (shape as unknown as Readonly<Record<string, unknown>>)[key];
  return params.every(({ key }) => equal(given(a, key), given(b, key)));
}

function equal(a: unknown, b: unknown): boolean {
  if (!Array.isArray(a) || !Array.isArray(b)) return a === b;
  return a.every((x, i) => x === b[i]);
}

type Signs = { readonly A: Sign | null; readonly B: Sign | null };

/**
 * Whether |t2| < |t1|, or |t2| = |t1| (then t2 is the positive one), for exact roots t1 < t2. Signs
 * tell unless the roots lie on either side of 0; there t1 + t2 = −B/A ≤ 0 is the question. Rounding
 * to doubles is monotone, so different sizes of correctly rounded roots tell, too; faithful ones
 * only if they are more than two neighbours apart. Between, a method that knows the signs of A and
 * B exactly is asked for them; null where it does not, and then the doubles count as they are.
 */
export function isSecondNearer(t1: number, t2: number, signs: () => Signs | null): boolean {
  if (t2 < 0) return true;
  if (t1 > 0) return false;
  const near = -t1;
  const far = t2;
  const apart = Math.abs(near - far) > WELL_APART * Math.max(near, far) + FOUR_STEPS;
  if (apart && Number.isFinite(near) && Number.isFinite(far)) return far < near;
  const known = signs();
  if (!known) return far <= near;
  // −B/A ≤ 0: B is 0, or of A's sign.
  return known.B === 0 || known.A === known.B;
}

/**
 * Two faithful roots are off by one neighbour each: 2^-52 of their size, or 2^-1074 among the
 * subnormals.
 */
const WELL_APART = 2 ** -50;
const FOUR_STEPS = 2 ** -1072;

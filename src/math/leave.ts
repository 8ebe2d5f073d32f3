import type { Hit, Intersection } from './intersection.ts';
import type { Shape } from './shapes/index.ts';
import { definitionOf } from './shapes/lookup.ts';

/**
 * The answer for a ray that starts on `from`: if that is the shape asked about, its root nearest 0
 * is dropped.
 */
export function withoutStart(found: Intersection, shape: Shape, from: Shape): Intersection {
  if (!sameShape(shape, from)) return found;
  const { hits } = found;
  const [first, second] = hits;
  if (!first) return found;
  const dropped = second && secondIsNearer(found, first, second) ? second : first;
  const kept = hits.filter((hit) => hit !== dropped);
  return {
    class: found.class,
    hits: kept,
    method: found.method,
    decidedBy: found.decidedBy,
    // The algebra may be worked out only when it is read.
    get details() {
      return found.details;
    },
    dropped,
  };
}

/** The same object, or the same kind with equal numbers: two such surfaces are one. */
function sameShape(a: Shape, b: Shape): boolean {
  if (a === b) return true;
  if (a.kind !== b.kind) return false;
  const given = (shape: Shape, key: string): unknown =>
    (shape as unknown as Readonly<Record<string, unknown>>)[key];
  return definitionOf(a).params.every(({ key }) => equal(given(a, key), given(b, key)));
}

function equal(a: unknown, b: unknown): boolean {
  if (!Array.isArray(a) || !Array.isArray(b)) return a === b;
  return a.every((x, i) => x === b[i]);
}

/**
 * Whether |t2| < |t1|, or |t2| = |t1| (then t2 is the positive one), for exact roots t1 < t2. Signs
 * tell unless the roots lie on either side of 0; there t1 + t2 = −B/A ≤ 0 is the question. Rounding
 * to doubles is monotone, so different sizes of correctly rounded roots tell, too; faithful ones
 * only if they are more than two neighbours apart. Between, a method that knows the signs of A and
 * B exactly is asked for them.
 */
function secondIsNearer(found: Intersection, first: Hit, second: Hit): boolean {
  if (second.t < 0) return true;
  if (first.t > 0) return false;
  const near = -first.t;
  const far = second.t;
  if (!KNOWS_SIGNS.has(found.method)) return far <= near;
  const apart = Math.abs(near - far) > WELL_APART * Math.max(near, far) + FOUR_STEPS;
  if (apart && Number.isFinite(near) && Number.isFinite(far)) return far < near;
  const { details } = found;
  if (details.family !== 'curved') return far <= near;
  const { A, B } = details.signs;
  // −B/A ≤ 0: B is 0, or of A's sign.
  return B === 0 || A === B;
}

/** The methods whose details hold exact signs. */
const KNOWS_SIGNS: ReadonlySet<string> = new Set(['certified', 'exact']);

/**
 * Two faithful roots are off by one neighbour each: 2^-52 of their size, or 2^-1074 among the
 * subnormals.
 */
const WELL_APART = 2 ** -50;
const FOUR_STEPS = 2 ** -1072;

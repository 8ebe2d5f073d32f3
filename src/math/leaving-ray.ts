import type { Hit, Intersection } from './intersection.ts';
import { isSameSurface, isSecondNearer } from './nearer.ts';
import type { Shape } from './shapes/index.ts';
import { definitionOf } from './shapes/lookup.ts';

/**
 * The answer for a ray that starts on `from`: if that is the shape asked about, its root nearest 0
 * is dropped. One that is cut off is none that the ray could start at.
 */
export function withoutStart(found: Intersection, shape: Shape, from: Shape): Intersection {
  if (!sameShape(shape, from)) return found;
  const { hits } = found;
  const dropped = hits
    .filter(({ fate }) => fate !== 'cut')
    .reduce<Hit | null>(
      (first, second) => (first && !secondIsNearer(found, first, second) ? first : second),
      null,
    );
  if (!dropped) return found;
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

const sameShape = (a: Shape, b: Shape): boolean => isSameSurface(definitionOf(a), a, b);

function secondIsNearer(found: Intersection, first: Hit, second: Hit): boolean {
  const oneIsACap = first.fate === 'cap' || second.fate === 'cap';
  const known = KNOWS_SIGNS.includes(found.method) && !oneIsACap;
  return isSecondNearer(first.t, second.t, () => {
    const { details } = found;
    return known && details.family === 'curved' ? details.signs : null;
  });
}

/** The methods whose details hold exact signs. */
const KNOWS_SIGNS: readonly string[] = ['certified', 'exact'];

import { CONTAINED, NONE, ONE, TWO } from '../batch/batch.ts';
import { type Ending, exactEnding } from '../ends.ts';
import type { Hit, Verdict } from '../intersection.ts';
import { solveSlowly } from '../methods/certified/doubled.ts';
import { placeOnQuadric } from '../methods/certified/hits.ts';
import { certifiedQuadric, certifiedSlot } from '../methods/certified/numbers.ts';
import type { ExactLine } from '../methods/exact-line.ts';
import type { Ray } from '../ray.ts';
import type { ShapeDefinition } from '../shapes/define.ts';
import type { Quadric } from '../shapes/numbers.ts';
import { type AskOne, createHit, FAR, NEAR, OPEN, put, sharpLine, UNPLACED } from './sharp.ts';

/** All roots of a line, ascending, with their points and normals. */
interface Roots {
  readonly verdict: Verdict;
  readonly hits: readonly Hit[];
}

/** A prepared shape as its lines see it. */
export interface Surface {
  /** One root, if that is quickly told; null for a shape of which it never is. */
  readonly ask: AskOne | null;
  /** The same, with twice the digits, of a ray that `ask` leaves OPEN; OPEN but for two or none. */
  readonly settle: AskOne;
  /** @param whole exact arithmetic about this ray, asked for only where doubles cannot tell. */
  readonly roots: (ray: Ray, whole: () => ExactLine) => Roots;
  /** Point and normal of root k, whose faithful double is t. */
  readonly place: (ray: Ray, k: number, t: number, whole: () => ExactLine) => Hit;
  /** Whether roots are one of the two doubles around the exact one, and it where that is one. */
  readonly isExact: boolean;
  readonly ending: (ray: Ray, whole: () => ExactLine) => Ending;
  /** The numbers of a round quadric, for filters. */
  readonly quadric: Quadric | null;
}

/** The exact method's, with the double that was found for t: either of the two around it. */
export const exactHit = (whole: () => ExactLine, k: number, t: number): Hit => ({
  ...(whole().answer().hits[k] as Hit),
  t,
});

/** By `certified`. A shape that is no round quadric is answered by its trees: exactly, slowly. */
export function curvedSurface<S extends { readonly kind: string }>(
  { numbers }: ShapeDefinition<S>,
  shape: S,
): Surface {
  return numbers?.family === 'quadric' ? quadricSurface(numbers.read(shape)) : byTrees;
}

const byTrees: Surface = {
  ask: null,
  settle: neverTold,
  quadric: null,
  isExact: true,
  ending: (ray, whole) => exactEnding(ray, null, whole),
  roots(_, whole) {
    const { class: verdict, hits } = whole().answer();
    return { verdict, hits };
  },
  place: (_, k, t, whole) => exactHit(whole, k, t),
};

function quadricSurface(q: Quadric): Surface {
  const ask = sharpLine(q, certifiedQuadric(q));
  const slot = certifiedSlot();
  const [near, far] = [createHit(), createHit()];
  const place: Surface['place'] = (ray, k, t, whole) =>
    placeOnQuadric(q, ray, t) ?? exactHit(whole, k, t);
  return {
    ask,
    settle(ray, wanted, placed, out) {
      if (!isOrdered(ray)) return OPEN;
      const verdict = solveSlowly(q, ray, slot);
      if (verdict === NONE) return 0;
      if (verdict !== TWO) return OPEN;
      const isFar = wanted === FAR || (wanted !== NEAR && slot.t0 < 0);
      if (isFar && wanted !== FAR) {
        // A root has one double, whoever else is asked for.
        const said = ask(ray, FAR, placed, out);
        if (said !== OPEN) return said;
      }
      const told = isFar ? FAR : NEAR;
      out.t = isFar ? slot.t1 : slot.t0;
      if (!placed) return told;
      const hit = placeOnQuadric(q, ray, out.t);
      if (hit) put(out, hit);
      return hit ? told : told + UNPLACED;
    },
    quadric: q,
    isExact: true,
    ending: (ray, whole) => exactEnding(ray, q, whole),
    place,
    roots(ray, whole) {
      const first = ask(ray, NEAR, true, near);
      if (first === 0) return MISSED;
      const second = ask(ray, FAR, true, far);
      const at = (k: number, said: number, { t, point, normal }: Hit): Hit =>
        said === k + 1
          ? { t, point: [...point], normal: [...normal], singular: false }
          : place(ray, k, t, whole);
      if (first !== OPEN && second !== OPEN) {
        return { verdict: 'two', hits: [at(0, first, near), at(1, second, far)] };
      }
      const verdict = solveSlowly(q, ray, slot);
      if (verdict === NONE) return MISSED;
      if (verdict === CONTAINED) return { verdict: 'contained', hits: [] };
      if (verdict !== TWO) {
        const single = verdict === ONE ? 'one' : 'tangent';
        return { verdict: single, hits: [exactHit(whole, 0, slot.t0)] };
      }
      // A root has one double, whoever else is asked for.
      if (first === OPEN) near.t = slot.t0;
      if (second === OPEN) far.t = slot.t1;
      return { verdict: 'two', hits: [at(0, first, near), at(1, second, far)] };
    },
  };
}

/** Finite, with d ≠ 0: of others the slow road says what is wrong. */
function isOrdered({ origin: E, direction: d }: Ray): boolean {
  const [x, y, z] = d;
  const zero = x - x + (y - y) + (z - z) + (E[0] - E[0]) + (E[1] - E[1]) + (E[2] - E[2]);
  return zero === 0 && (x !== 0 || y !== 0 || z !== 0);
}

/** For a shape of which nothing is quickly told. */
export function neverTold(): number {
  return OPEN;
}

/** Of a line that does not meet the shape. */
export const MISSED: Roots = { verdict: 'none', hits: [] };

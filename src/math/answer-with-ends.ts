import { float64 } from './arithmetic/float64.ts';
import { quadricOf } from './batch/quadric.ts';
import { type Ending, exactEnding, roundedEnding, withEnds } from './ends.ts';
import { evaluate } from './formula/evaluate.ts';
import type { Intersection } from './intersection.ts';
import { type ExactLine, exactLine } from './methods/exact-line.ts';
import type { Ray } from './ray.ts';
import type { Cut } from './shapes/checked.ts';
import type { Shape } from './shapes/index.ts';
import { definitionOf } from './shapes/lookup.ts';
import type { Vec3 } from './vec3.ts';

/** Whether a method's roots and points are the exact ones, or one of the doubles around them. */
export const isFaithful = (method: string): boolean => method === 'certified' || method === 'exact';

/** By exact signs where the method is faithful, else by its own rounded numbers. */
export function endingBy(method: string, surface: Shape, ray: Ray, whole: () => ExactLine): Ending {
  if (isFaithful(method)) return exactEnding(ray, quadricOf(surface), whole);
  const entry = definitionOf(surface);
  const formula = entry.formula(surface);
  const { scalars, vectors } = entry.values(surface);
  // f at a point is C of a ray from there.
  const side = (E: Vec3): number =>
    formula.family === 'curved'
      ? evaluate(formula.C, float64, { scalars, vectors: { ...vectors, E } })
      : Number.NaN;
  return roundedEnding(ray, side);
}

/** The answer about the whole surface, with each root's fate and the ways through the caps. */
export function answerWithEnds(
  found: Intersection,
  surface: Shape,
  cut: Cut,
  ray: Ray,
): Intersection {
  let line: ExactLine | null = null;
  function whole(): ExactLine {
    line ??= exactLine(definitionOf(surface), surface, ray);
    return line;
  }
  const { class: verdict, hits, method, decidedBy } = found;
  return {
    class: verdict,
    hits: withEnds(hits, verdict, cut, ray, endingBy(method, surface, ray, whole)),
    method,
    decidedBy,
    get details() {
      return found.details;
    },
  };
}

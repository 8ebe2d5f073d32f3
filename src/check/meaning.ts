import { alongRay, definitionOf } from '../math/shapes.ts';
import { display, displayTriple } from '../text/format.ts';
import { courseOf } from './course.ts';
import type { Answers, Input } from './types.ts';

/** Largest |f| at a t rounded to four digits, relative to the sum of the sizes of f's terms. */
const NEARLY = 2e-3;

/**
 * A sentence on the point R(t) of the first of these fields that has a t: where it is, and on which
 * side of the surface. '' if none has.
 */
export function meaningOf(input: Input, answers: Answers, fields: readonly string[]): string {
  const t = fields
    .filter((id) => /^t[12]?$/.test(id))
    .map((id) => answers[id])
    .find((x) => typeof x === 'number');
  if (typeof t !== 'number' || !Number.isFinite(t)) return '';
  const { point, f } = alongRay(input.shape, input.ray, t);
  const { title } = definitionOf(input.shape);
  const at = `At t = ${display(t)} the ray is at ${displayTriple(point, 4)}`;
  const curved = courseOf(input.shape).family === 'curved';
  const size = Math.abs(alongRay(input.shape, input.ray, 0).f) + Math.abs(f);
  if (Math.abs(f) <= NEARLY * size) return `${at}, on the ${curved ? title : 'plane'}.`;
  const value = curved ? `f(t) = ${display(f, 4)}` : `N·(X − P) = ${display(f, 4)}`;
  const side = curved ? (f < 0 ? `inside the ${title}` : `outside the ${title}`) : 'off the plane';
  return `${at}. There ${value}, not 0: that is ${side}.`;
}

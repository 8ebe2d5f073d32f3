import { decimalDigits, type Surd } from '../math/exact.ts';
import type { Question } from '../math/families.ts';
import { evaluateTriple, exact, type Triple, valuesOf, withPoint } from '../math/formula.ts';
import { definitionOf } from '../math/shapes.ts';
import { referenceOf } from './reference.ts';

/*
 * Hard cases with their exact answers, for programs in any language:
 *
 *   { "graze": "hard-cases", "version": 1, "seed": 7, "digits": 40,
 *     "cases": [ { "id", "family", "shape", "ray", "class",
 *                  "hits": [ { "t", "point", "normal" }, … ] }, … ] }
 *
 * One case a line. Numbers of shape and ray are doubles in the digits that restore them. Those of
 * the answer are texts with as many significant digits as "digits" says, rounded to the nearest: of
 * the exact hits, ascending in t, over the whole line, a tangent once.
 */

export const DIGITS = 40;

export interface HardCase extends Question {
  readonly id: string;
  /** Where it is from. */
  readonly family: string;
}

/** The file's text; `float32` says that all numbers of shapes and rays are 32-bit ones. */
export function hardCases(cases: readonly HardCase[], seed: number, float32 = false): string {
  const lines = cases.map(({ id, family, shape, ray }) =>
    JSON.stringify({ id, family, ...answer({ shape, ray }) }),
  );
  return (
    `{ "graze": "hard-cases", "version": 1, "seed": ${seed}, "digits": ${DIGITS}, ` +
    `${float32 ? '"float32": true, ' : ''}"cases": [\n${lines.join(',\n')}\n] }\n`
  );
}

function answer({ shape, ray }: Question): object {
  const { found, hits } = referenceOf(shape, ray);
  const texts = hits.map(({ t, point }) => ({
    t: text(t),
    point: point.map(text),
    normal: normalAt({ shape, ray }, point).map(text),
  }));
  return { shape, ray, class: found.class, hits: texts };
}

function normalAt({ shape, ray }: Question, point: Triple<Surd>): Triple<Surd> {
  const formula = definitionOf(shape).formula(shape);
  const values = valuesOf(shape, ray, exact);
  if (formula.family === 'flat') return values.vectors.N as Triple<Surd>;
  return evaluateTriple(formula.normal, exact, withPoint(values, point));
}

/** 0.125 as 1.25e-1, zeros at the end left out. */
function text(x: Surd): string {
  const { negative, digits, exponent } = decimalDigits(x, DIGITS);
  const [first = '0', ...rest] = digits.replace(/0+$/, '') || '0';
  return `${negative ? '-' : ''}${first}${rest.length > 0 ? `.${rest.join('')}` : ''}e${exponent}`;
}

import { shortest } from '../../../text/format.ts';
import { axisIndex } from '../../vec3.ts';
import type { CodeSyntax } from './code-notation.ts';

/** Points are arrays or tuples of three doubles. */
export const TYPESCRIPT: CodeSyntax = {
  number: shortest,
  component: (vector, axis) => `${vector}[${axisIndex(axis)}]`,
  sqrt: (of) => `Math.sqrt(${of})`,
  vectors: null,
};

/** Points are tuples or lists of three doubles; needs `import math`. */
export const PYTHON: CodeSyntax = {
  number: withPoint,
  component: (vector, axis) => `${vector}[${axisIndex(axis)}]`,
  sqrt: (of) => `math.sqrt(${of})`,
  vectors: null,
};

/**
 * Points are vec3; their dot products and lengths are the language's own, whose order of adding it
 * does not tell.
 */
export const GLSL: CodeSyntax = {
  number: withPoint,
  component: (vector, axis) => `${vector}.${axis}`,
  sqrt: (of) => `sqrt(${of})`,
  vectors: {
    dot: (left, right) => `dot(${left}, ${right})`,
    norm: (of) => `length(${of})`,
  },
};

/**
 * Never a whole number's literal: in Python those are whole numbers of any length, in GLSL they do
 * not mix with floats.
 */
function withPoint(x: number): string {
  const text = shortest(x);
  if (!Number.isFinite(x)) throw new RangeError(`no literal for ${text}`);
  return /[.e]/.test(text) ? text : `${text}.0`;
}

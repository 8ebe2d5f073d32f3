import type { ShapeKind } from '../../math/shapes/index.ts';
import { findShape } from '../../math/shapes/lookup.ts';
import type { Param } from '../../math/shapes/params.ts';
import { programOf } from './source.ts';

const typeOf = (param: Param): string => {
  if (param.type === 'vector') return '[x, y, z]';
  return param.type === 'number' ? 'number' : "'x', 'y' or 'z'";
};

/** { kind: 'cylinder', center: [x, y, z], radius: number } */
function typeOfShape(kind: ShapeKind): string {
  const params = (findShape(kind)?.params ?? []).map((p) => `${p.key}: ${typeOf(p)}`);
  return `{ kind: '${kind}', ${params.join(', ')} }`;
}

/** What a program gets and has to return, as a comment above an empty function. */
export function template(kinds: readonly ShapeKind[]): string {
  return [
    '// ray: { origin: [x, y, z], direction: [x, y, z] }, E and d',
    ...kinds.map((kind, i) => `// ${i === 0 ? 'shape: ' : '    or '}${typeOfShape(kind)}`),
    '// Return every t at which the line E + t d meets the shape,',
    '// also t < 0, ascending, a tangent once. No t for a miss, or',
    '// where the whole line lies in the shape. normal, one for each',
    '// t, is optional. Wrong input: throw, or return no t.',
    'function intersect(shape, ray) {',
    '  const [ex, ey, ez] = ray.origin;',
    '  const [dx, dy, dz] = ray.direction;',
    '',
    '  return { t: [] };',
    '}',
    '',
  ].join('\n');
}

/** The textbook program for one shape. */
export const example = (kind: ShapeKind): string => programOf(kind) ?? '';

/** The textbook method for several shapes, as one function of this name. */
export function textbookFor(kinds: readonly ShapeKind[], name: string): string {
  const [only, ...others] = kinds;
  if (only && others.length === 0) return programOf(only, (course) => course, name) ?? '';
  const parts = kinds.map((kind) => programOf(kind, (course) => course, `${name}_${kind}`) ?? '');
  const choose = kinds.map((kind) => `    case '${kind}': return ${name}_${kind}(shape, ray);`);
  return [
    ...parts,
    `function ${name}(shape, ray) {`,
    '  switch (shape.kind) {',
    ...choose,
    '    default: return { t: [] };',
    '  }',
    '}',
    '',
  ].join('\n');
}

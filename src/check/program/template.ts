import { findShape, type Param, type ShapeKind } from '../../math/shapes.ts';
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

/** An empty function, with a comment on what it gets and has to return. */
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

/** The textbook program for these shapes, which also refuses invalid input. */
export const example = (kinds: readonly ShapeKind[]): string =>
  textbookFor(kinds, 'intersect', refusals);

/** Statements that throw if a number is not finite or out of its range. */
function refusals(kind: ShapeKind): string[] {
  const params = findShape(kind)?.params ?? [];
  const vectors = params.filter(({ type }) => type === 'vector').map((p) => `...shape.${p.key}`);
  const numbers = params.filter(({ type }) => type === 'number').map((p) => `shape.${p.key}`);
  const all = ['...ray.origin', '...ray.direction', ...vectors, ...numbers].join(', ');
  const isZero = (v: string): string => `${v}.every((x) => x === 0)`;
  const wrong = [
    isZero('ray.direction'),
    ...params.flatMap((param) => {
      if (param.type === 'vector' && param.nonZero) return [isZero(`shape.${param.key}`)];
      const bounded = param.type === 'number' && param.least !== undefined;
      return bounded ? [`shape.${param.key} < ${param.least}`] : [];
    }),
  ];
  return [
    `if (![${all}].every(Number.isFinite)) throw new Error('not a number');`,
    `if (${wrong.join(' || ')}) throw new Error('out of range');`,
  ];
}

/** The textbook method for several shapes as one function; `before` adds lines for each shape. */
export function textbookFor(
  kinds: readonly ShapeKind[],
  name: string,
  before: (kind: ShapeKind) => readonly string[] = () => [],
): string {
  const part = (kind: ShapeKind, as: string): string =>
    programOf(kind, (course) => course, as, before(kind)) ?? '';
  const [only, ...others] = kinds;
  if (only && others.length === 0) return part(only, name);
  const parts = kinds.map((kind) => part(kind, `${name}_${kind}`));
  const choose = kinds.map((kind) => `    case '${kind}': return ${name}_${kind}(shape, ray);`);
  return [
    ...parts,
    `function ${name}(shape, ray) {`,
    '  switch (shape.kind) {',
    ...choose,
    "    default: throw new Error('no such shape');",
    '  }',
    '}',
    '',
  ].join('\n');
}

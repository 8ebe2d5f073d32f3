import { AXES, definitionOf } from '../../math/shapes.ts';
import { shortest } from '../../text/format.ts';
import type { ExploreModel } from '../derive.ts';
import type { Export } from './define.ts';

/** A test that the math module gives what the page shows, bit by bit. */
export const vitest: Export = {
  id: 'vitest',
  title: 'the ray as a test case',
  extension: 'test.ts',
  mime: 'text/typescript',
  text: (model) => vitestCase(model),
};

/** @param mathModule import path of the math module, relative to the test's file. */
export function vitestCase(model: ExploreModel, mathModule = './src/math/index.ts'): string {
  const { shape, ray, found, title, verdict, ended } = model;
  const fate = ended ? ', fate' : '';
  const kind: [key: string, value: string] = ['kind', quoted(shape.kind)];
  const fields = [kind, ...paramsOf(model), ...endsOf(model)];
  return `import { expect, test } from 'vitest';
import { intersect } from ${quoted(mathModule)};

test(${quoted(`${title}: ${verdict.text}`)}, () => {
  const shape = ${object(fields)} as const;
  const ray = ${object([
    ['origin', literal(ray.origin)],
    ['direction', literal(ray.direction)],
  ])} as const;
  const found = intersect(shape, ray, ${quoted(found.method)});
  expect(found.class).toBe(${quoted(found.class)});
  const hits = found.hits.map(({ ${FIELDS}${fate} }) => ({ ${FIELDS}${fate} }));
  // toEqual compares numbers by Object.is: every bit counts, and −0 is not 0.
  expect(hits).toEqual(${hitList(model)});
});
`;
}

const FIELDS = 't, point, normal, singular';

function endsOf({ ended }: ExploreModel): [key: string, value: string][] {
  if (!ended) return [];
  const { between, caps } = ended;
  return [
    ['between', `[${between.map(shortest).join(', ')}]`],
    ['caps', String(caps)],
  ];
}

function hitList({ found, ended }: ExploreModel): string {
  const hits = ended?.hits ?? found.hits;
  if (hits.length === 0) return '[]';
  const lines = hits.map(({ t, point, normal, singular, fate }) =>
    object([
      ['t', literal(t)],
      ['point', literal(point)],
      ['normal', literal(normal)],
      ['singular', String(singular)],
      ...(fate ? [['fate', quoted(fate)] as const] : []),
    ]),
  );
  return `[\n${lines.map((line) => `    ${line},\n`).join('')}  ]`;
}

function paramsOf({ shape }: ExploreModel): [key: string, value: string][] {
  const given = shape as unknown as Readonly<Record<string, unknown>>;
  return definitionOf(shape).params.map(({ key }) => [key, literal(given[key])]);
}

function object(entries: readonly (readonly [key: string, value: string])[]): string {
  return `{ ${entries.map(([key, value]) => `${key}: ${value}`).join(', ')} }`;
}

function literal(value: unknown): string {
  if (typeof value === 'number') return shortest(value);
  if (Array.isArray(value)) return `[${AXES.map((_, i) => literal(value[i])).join(', ')}]`;
  return quoted(String(value));
}

function quoted(text: string): string {
  return `'${text.replace(/[\\']/g, '\\$&')}'`;
}

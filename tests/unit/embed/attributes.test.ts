import { readFileSync } from 'node:fs';
import { dirname, join } from 'node:path';
import { parseSync } from 'vite';
import { expect, test } from 'vitest';
import { ATTRIBUTES, withAttributes } from '../../../src/embed/attributes.ts';
import { SHAPES } from '../../../src/math/index.ts';
import { elementLine, frameLine } from '../../../src/pages/embed/lines.ts';
import { shapeOf } from '../../../src/state/state.ts';
import { decode, encode } from '../../../src/state/url.ts';

const START = decode('#/explore?shape=cone');
const put = (given: Readonly<Record<string, string | null>>, state = START) =>
  withAttributes(state, new Map(Object.entries(given)));

test.each(SHAPES.map((shape) => [shape.kind, shape] as const))(
  'every number of a %s has an attribute of its own',
  (kind, { params }) => {
    const names = ['e', 'd', ...params.map(({ symbol }) => symbol.toLowerCase())];
    expect(new Set(names).size).toBe(names.length);
    expect(names.filter((name) => !ATTRIBUTES.includes(name))).toEqual([]);
    const link = encode(decode(`#/explore?shape=${kind}&E=1,2,3&unit=1`));
    expect(encode(put({ shape: kind, e: '1,2,3', unit: '1' }))).toBe(link);
  },
);

test('attributes are keys of links: those of another shape go with it', () => {
  const cone = put({ c: '2', v: '1,2,3', show: 'graph', lock: 'c' });
  expect(shapeOf(cone)).toMatchObject({ kind: 'cone', slope: 2, vertex: [1, 2, 3] });
  expect(cone.embed).toEqual(['graph']);
  const sphere = put({ shape: 'sphere', lock: null, c: '0,0,1' }, cone);
  expect(shapeOf(sphere)).toMatchObject({ kind: 'sphere', center: [0, 0, 1] });
  expect(sphere.problems).toEqual([]);
  expect(put({ c: null }, cone).shapes.cone).toMatchObject({ slope: 0.5 });
});

test('hide alone hides, and what cannot be read is said', () => {
  expect(put({ hide: '' }).revealed).toBe(0);
  expect(put({ c: 'two' }).problems).toHaveLength(1);
  expect(put({ c: 'two' }).problems[0]).toContain("'two'");
});

test('the lines for a page bring the state back, and nothing that could end them', () => {
  const link = '#/explore?shape=cone&E=1,2,3&c=1%2f3&embed=scene,graph&lock=c';
  const state = decode(link);
  const frame = frameLine(`https://x.example/g/${encode(state)}`);
  expect(/src="([^"]*)"/.exec(frame)?.[1]?.replaceAll('&amp;', '&')).toBe(
    `https://x.example/g/${encode(state)}`,
  );
  const line = elementLine(state, 'https://x.example/g/index.html');
  expect(line).toContain('src="https://x.example/g/embed/graze.js"');
  const [, own = ''] = /<graze-ray([^>]*)>/.exec(line) ?? [];
  const given = Object.fromEntries(
    [...own.matchAll(/ (\w+)="([^"]*)"/g)].map(([, key = '', value = '']) => [
      key.toLowerCase(),
      value,
    ]),
  );
  expect(encode(put(given))).toBe(encode(state));
  expect(frameLine('x"><script>')).not.toContain('"><script>');
});

/** Style sheets that a module and what it imports ask for, in no order. */
function stylesBehind(file: string, seen = new Set<string>()): string[] {
  if (seen.has(file)) return [];
  seen.add(file);
  if (file.endsWith('.css')) return [file];
  const { module } = parseSync(file, readFileSync(file, 'utf8'));
  const names = [
    ...module.staticImports
      .filter(({ entries }) => entries.length === 0 || entries.some(({ isType }) => !isType))
      .map(({ moduleRequest }) => moduleRequest.value),
    ...module.dynamicImports.map(({ moduleRequest: { start, end } }) =>
      readFileSync(file, 'utf8').slice(start + 1, end - 1),
    ),
  ].filter((name) => name.startsWith('.'));
  return names.flatMap((name) => stylesBehind(join(dirname(file), name.replace(/\?.*/, '')), seen));
}

test('the element has every style sheet of its parts', () => {
  const needed = stylesBehind('src/pages/embed/embed-view.ts');
  const listed = stylesBehind('src/embed/styles.ts');
  expect(needed.filter((one) => !listed.includes(one))).toEqual([]);
});

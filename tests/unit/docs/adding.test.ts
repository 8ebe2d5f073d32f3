import { existsSync } from 'node:fs';
import { describe, expect, test } from 'vitest';
import { codeSpans, ROOT, read, section } from './documents.ts';

const adding = read('docs/ADDING.md');
const there = (path: string): boolean => existsSync(new URL(path, ROOT));

/** A registry's heading, and a value that is in its list. */
const LISTS: readonly (readonly [heading: string, id: string])[] = [
  ['## A shape', 'sphere'],
  ['## A method', 'stable'],
  ['## An effect', 'shadow'],
  ['## A scene', 'mirror'],
  ['## An exercise', 'roots'],
  ['## An example of the gallery', 'sphere'],
];

test('every path that docs/ADDING.md names is there', () => {
  const paths = codeSpans(adding).filter((span) => /^(src|tests|docs)\//.test(span));
  const named = paths.filter((path) => !path.includes('<'));
  expect(named.filter((path) => !there(path))).toEqual([]);
  expect(named.length).toBeGreaterThan(10);
});

describe.each(LISTS)('%s', (heading, id) => {
  const paths = codeSpans(section(adding, heading));

  test(`its files are those of ${id}`, () => {
    const files = paths.filter((path) => path.includes('<'));
    expect(files).not.toEqual([]);
    for (const path of files)
      expect([path, there(path.replace(/<\w+>/, id))]).toEqual([path, true]);
  });

  test('the index that it names imports that file', () => {
    const index = paths.find((path) => path.endsWith('/index.ts')) ?? '';
    expect(read(index)).toContain(`./${id}.ts`);
  });
});

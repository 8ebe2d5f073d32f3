import { posix } from 'node:path';
import { describe, expect, test } from 'vitest';
import { ROOT, read } from './documents.ts';
import { runExample } from './examples.ts';

/** What other rooms and other programs import of the math module, and seeds for its families. */
const DOORS = [
  'src/math/index.ts',
  'src/math/batch/batch.ts',
  'src/math/batch/kernels.ts',
  'src/math/families.ts',
  'src/math/accelerate.ts',
  'src/math/rng.ts',
];

interface Docstring {
  /** Without the stars. */
  readonly text: string;
  readonly name: string;
}

/** Exported things of a file with what stands before them, '' where nothing does. */
function docstringsIn(path: string): readonly Docstring[] {
  const source = read(path);
  const found = source.matchAll(
    /(?:^\/\*\*((?:(?!\*\/)[\s\S])*)\*\/\n)?^export (?:async )?\w+ (\w+)/gm,
  );
  return [...found].map(([, text = '', name = '']) => ({
    text: text.replace(/^ ?\*? ?/gm, ''),
    name,
  }));
}

/** What a door declares itself, and what it hands on from other files. */
function docstringsOf(door: string): readonly Docstring[] {
  const handedOn = [...read(door).matchAll(/^export (?:type )?\{([^}]*)\} from '([^']+)'/gm)];
  return [
    ...docstringsIn(door),
    ...handedOn.flatMap(([, list = '', from = '']) => {
      const names = [...list.matchAll(/(\w+)(?:,|\s*$)/g)].map((m) => m[1]);
      const target = posix.join(posix.dirname(door), from);
      return docstringsIn(target).filter(({ name }) => names.includes(name));
    }),
  ];
}

/** The code of an `@example`, which is a docstring's last part. */
const exampleIn = (text: string): string => text.split('@example\n')[1] ?? '';

const modules: Readonly<Record<string, Readonly<Record<string, unknown>>>> = Object.fromEntries(
  await Promise.all(
    DOORS.map(async (door) => [door, await import(new URL(door, ROOT).pathname)] as const),
  ),
);
const names = Object.assign({}, ...Object.values(modules));

describe.each(DOORS.slice(0, -1))('%s', (door) => {
  const docstrings = docstringsOf(door);
  const works = docstrings.filter(
    ({ name }) => typeof modules[door]?.[name] === 'function' || exampleOf(name) !== '',
  );
  function exampleOf(name: string): string {
    return exampleIn(docstrings.find((one) => one.name === name)?.text ?? '');
  }

  test('all that it exports is found, and every type and function has words', () => {
    const found = docstrings.map(({ name }) => name);
    expect(Object.keys(modules[door] ?? {}).filter((name) => !found.includes(name))).toEqual([]);
    const isNumber = (name: string): boolean => typeof modules[door]?.[name] === 'number';
    expect(docstrings.filter(({ text, name }) => text === '' && !isNumber(name))).toEqual([]);
  });

  test.each(works.map(({ name }) => name))('the example of %s', async (name) => {
    await runExample(exampleOf(name), names);
  });
});

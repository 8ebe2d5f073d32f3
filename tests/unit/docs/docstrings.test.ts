import { posix } from 'node:path';
import { describe, expect, test } from 'vitest';
import { codeSpans, filesIn, ROOT, read, section } from './documents.ts';
import { runExample } from './examples.ts';

/** The doors of the math module: all that other rooms and other programs import of it. */
const DOORS = filesIn('src/math/').filter((path) => path.endsWith('.ts') && isDoor(path));

/** docs/ARCHITECTURE.md lists them. */
function isDoor(path: string): boolean {
  const doors = section(read('docs/ARCHITECTURE.md'), '## Doors of the math module');
  return codeSpans(doors).includes(posix.basename(path));
}

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

/** What a file declares itself, and what it hands on from others, under its name there. */
function docstringsOf(path: string): readonly Docstring[] {
  const handedOn = [...read(path).matchAll(/^export (?:type )?\{([^}]*)\} from '([^']+)'/gm)];
  return [
    ...docstringsIn(path),
    ...handedOn.flatMap(([, list = '', from = '']) => {
      const known = docstringsOf(posix.join(posix.dirname(path), from));
      return [...list.matchAll(/(\w+)(?: as (\w+))?(?=,|\s*$)/g)].flatMap(
        ([, name = '', alias = name]) =>
          known.filter((one) => one.name === name).map(({ text }) => ({ text, name: alias })),
      );
    }),
  ];
}

/** The parameters' names, of those that have one. */
function parametersOf(work: unknown): readonly string[] {
  const [, list = ''] = /^(?:async )?(?:function )?\w*\(([^)]*)\)/.exec(String(work)) ?? [];
  return list
    .replace(/\{[^}]*\}|\[[^\]]*\]/g, '')
    .split(',')
    .flatMap((one) => /^\s*(?:\.\.\.)?(\w+)/.exec(one)?.[1] ?? []);
}

/** What is said of the parameters, one by one or together. */
const parametersIn = (text: string): string =>
  /@param[\s\S]*?(?=@throws|@example|$)/.exec(text)?.[0] ?? '';

/**
 * Names of the functions of the math module that refuse something, by a throw of their own or of
 * what they call.
 */
function refusing(): ReadonlySet<string> {
  const works = filesIn('src/math/')
    .filter((path) => path.endsWith('.ts') && !path.includes('/generated/'))
    .flatMap((path) => [
      ...read(path).matchAll(
        /^(?:export )?(?:(?:async )?function (\w+)[\s\S]*?^\}|const (\w+)[^=\n]*=[\s\S]*?;$)/gm,
      ),
    ])
    .map(([work, declared, assigned]) => ({ name: declared ?? assigned ?? '', work }));
  const found = new Set<string>();
  for (let before = -1; before < found.size; ) {
    before = found.size;
    const calls = [...found].map((name) => `\\b${name}\\(`);
    const throws = new RegExp(['throw new (?:InvalidInput|RangeError)', ...calls].join('|'));
    for (const { name, work } of works) {
      if (throws.test(work.slice(work.indexOf('(') + 1))) found.add(name);
    }
  }
  return found;
}

/** The code of an `@example`, which is a docstring's last part. */
const exampleIn = (text: string): string => text.split('@example\n')[1] ?? '';

const modules: Readonly<Record<string, Readonly<Record<string, unknown>>>> = Object.fromEntries(
  await Promise.all(
    DOORS.map(async (door) => [door, await import(new URL(door, ROOT).pathname)] as const),
  ),
);
const REFUSING = refusing();
const names = Object.assign({}, ...Object.values(modules));

describe.each(DOORS)('%s', (door) => {
  const docstrings = docstringsOf(door);
  const isFunction = (name: string): boolean => typeof modules[door]?.[name] === 'function';
  const exampleOf = (name: string): string =>
    exampleIn(docstrings.find((one) => one.name === name)?.text ?? '');
  const works = docstrings.filter(({ name }) => isFunction(name) || exampleOf(name) !== '');

  test('all that it exports is found, and has words', () => {
    const found = docstrings.map(({ name }) => name);
    expect(Object.keys(modules[door] ?? {}).filter((name) => !found.includes(name))).toEqual([]);
    expect(docstrings.filter(({ text }) => text.trim() === '')).toEqual([]);
  });

  test('the docstring of every function says what its parameters are', () => {
    const untold = docstrings.flatMap(({ text, name }) =>
      isFunction(name)
        ? parametersOf(modules[door]?.[name])
            .filter((parameter) => !new RegExp(`\\b${parameter}\\b`).test(parametersIn(text)))
            .map((parameter) => `${name}: ${parameter}`)
        : [],
    );
    expect(untold).toEqual([]);
  });

  test('and what it throws, if it refuses anything', () => {
    const untold = docstrings.filter(
      ({ text, name }) => isFunction(name) && REFUSING.has(name) && !/@throws/.test(text),
    );
    expect(untold.map(({ name }) => name)).toEqual([]);
  });

  test.each(works.map(({ name }) => name))('the example of %s', async (name) => {
    await runExample(exampleOf(name), names);
  });
});

test('functions that refuse something are found', () => {
  expect([...REFUSING]).toEqual(expect.arrayContaining(['intersect', 'prepare', 'coefficients']));
});

describe('the stages of certified', () => {
  /** A line of exported constants under another one shares its docstring: slots, bounds. */
  const isInGroup = (line: string): boolean => /^export const \w+ = .*;$/.test(line);

  test.each(filesIn('src/math/methods/certified/').filter((path) => path.endsWith('.ts')))(
    '%s: each export has a docstring, or is one of a group that has',
    (path) => {
      const lines = read(path)
        .replace(/^\/\*\*[\s\S]*?\*\/$/gm, '/** */')
        .split('\n');
      const bare = lines.filter(
        (line, i) =>
          /^export (?!\{|\*)/.test(line) &&
          lines[i - 1] !== '/** */' &&
          !isInGroup(lines[i - 1] ?? ''),
      );
      expect(bare).toEqual([]);
    },
  );
});

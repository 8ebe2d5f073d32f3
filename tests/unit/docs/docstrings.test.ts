import { posix } from 'node:path';
import { parseSync } from 'vite';
import { describe, expect, test } from 'vitest';
import { codeSpans, filesIn, flowing, ROOT, read, section } from './documents.ts';
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
  readonly signature: Signature;
}

/** The types of a function as they are written: of its parameters, by name, and of its result. */
interface Signature {
  readonly parameters: ReadonlyMap<string, string>;
  readonly result: string;
}

/** Exported things of a file with what stands before them, '' where nothing does. */
function docstringsIn(path: string): readonly Docstring[] {
  const source = read(path);
  const found = source.matchAll(
    /(?:^\/\*\*((?:(?!\*\/)[\s\S])*)\*\/\n)?^export (?:async )?\w+ (\w+)/gm,
  );
  const signatures = signaturesIn(path, source);
  return [...found].map(([, text = '', name = '']) => ({
    text: text.replace(/^ ?\*? ?/gm, ''),
    name,
    signature: signatures.get(name) ?? { parameters: new Map(), result: '' },
  }));
}

/** Of the functions that a file exports, by name. */
function signaturesIn(path: string, source: string): ReadonlyMap<string, Signature> {
  const typed = (node: Node | null | undefined): string =>
    node ? source.slice(node.start + 1, node.end).trim() : '';
  const { body } = parseSync(path, source).program as unknown as { readonly body: readonly Node[] };
  return new Map(
    body
      .flatMap(({ declaration }) => declaration?.declarations ?? declaration ?? [])
      .flatMap((declared) => {
        const work = declared.init ?? declared;
        if (!declared.id || !work.params) return [];
        const parameters = work.params
          .map((one) => one.left ?? one)
          .map((one): [string, string] => [one.name ?? '', typed(one.typeAnnotation)]);
        const result = typed(work.returnType);
        return [[declared.id.name ?? '', { parameters: new Map(parameters), result }] as const];
      }),
  );
}

/** What is looked at of a syntax tree. */
interface Node {
  readonly start: number;
  readonly end: number;
  readonly name?: string;
  readonly id?: Node;
  readonly declaration?: Node | null;
  readonly declarations?: readonly Node[];
  readonly init?: Node | null;
  readonly params?: readonly Node[];
  readonly left?: Node;
  readonly typeAnnotation?: Node | null;
  readonly returnType?: Node | null;
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
          known.filter((one) => one.name === name).map((one) => ({ ...one, name: alias })),
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

/** The tags of one kind in a docstring, each with its text. */
const tagsIn = (text: string, tag: string): readonly string[] =>
  [...text.matchAll(new RegExp(`^@${tag}\\b([\\s\\S]*?)(?=^@|(?![\\s\\S]))`, 'gm'))].map(
    ([, said = '']) => flowing(said),
  );

/** What is said of a parameter, by itself or together with others; by its place without a name. */
function saidOf(parameter: string, text: string, place = 0): string {
  const tags = tagsIn(text, 'param');
  const named = tags.find((said) => new RegExp(`\\b${parameter}\\b`).test(said));
  return (parameter === '' ? tags[place] : named) ?? '';
}

/** Types of numbers, and of vectors and lists of them. */
const NUMBERS = /\b(?:number|Vec3|Triple|Heights|Surd|Ratio|Sign)\b/;

/** Types of answers that are computed by a formula; what their fields are stands there. */
const ANSWERS =
  /\b(?:Coefficients|QuadraticAnswer|Intersection|Prepared|Kernel|Closest|Span|Level)\b/;

/** A unit, that there is none, a range, or the function whose words hold for it too. */
const UNIT = /\bunits?\b|\blengths of d\b|\bwhole number\b|\bfrom \d|[<≤≥]|as for `/;

/** Where a formula comes from: a section of NUMERICS.md, or an entry of its list of sources. */
const NUMERICS = read('docs/NUMERICS.md');
const SOURCES = flowing(section(NUMERICS, '## Sources')).split(/[;.] (?=[A-Z])/);

function isSource(said: string): boolean {
  const [, number] = /^NUMERICS\.md, section (\d)/.exec(said) ?? [];
  if (number !== undefined) return NUMERICS.includes(`\n## ${number}. `);
  return SOURCES.some((source) => said.startsWith(source.replace(/\.$/, '')));
}

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
  const functions = docstrings.filter(({ name }) => isFunction(name));
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
            .filter((parameter) => saidOf(parameter, text) === '')
            .map((parameter) => `${name}: ${parameter}`)
        : [],
    );
    expect(untold).toEqual([]);
  });

  test('in which unit or range they and the result are, where these are numbers', () => {
    const untold = functions.flatMap(({ text, name, signature: { parameters, result } }) => [
      ...[...parameters].flatMap(([parameter, type], place) =>
        NUMBERS.test(type) && !UNIT.test(saidOf(parameter, text, place))
          ? [`${name}: ${parameter}`]
          : [],
      ),
      ...(NUMBERS.test(result) && !UNIT.test(tagsIn(text, 'returns').join()) ? [name] : []),
    ]);
    expect(untold).toEqual([]);
  });

  test('and where its formula comes from, where the result is numbers', () => {
    const untold = functions.filter(
      ({ text, signature: { result } }) =>
        (NUMBERS.test(result) || ANSWERS.test(result)) && !tagsIn(text, 'see').some(isSource),
    );
    expect(untold.map(({ name }) => name)).toEqual([]);
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

import { spawnSync } from 'node:child_process';
import { transformWithOxc } from 'vite';
import { beforeAll, describe, expect, test } from 'vitest';
import { rayPython } from '../../../src/state/exports/python.ts';
import { rayTypeScript } from '../../../src/state/exports/typescript.ts';
import {
  EXPORT_CASES,
  type ExportCase,
  HARD_CASES,
  modelOf,
  textbookAnswer,
} from './exports-cases.ts';

/*
 * The exported programs are run, and what they print is compared with the textbook method, bit by
 * bit.
 */

const ALL: readonly ExportCase[] = [...EXPORT_CASES, ...HARD_CASES];
/** For a machine that has other things to do; unloaded it is two seconds. */
const PATIENCE = 60_000;

/** JSON as the programs write it; in ours −0 and the infinities are strings. */
const read = (text: string): unknown =>
  JSON.parse(text, (_, x) => (/^-?(Infinity|0)$/.test(x) ? Number(x) : x));

async function runTypeScript(text: string): Promise<unknown> {
  const { code } = await transformWithOxc(text, 'ray.ts');
  const printed: string[] = [];
  new Function('console', code)({ log: (line: string) => printed.push(line) });
  expect(printed).toHaveLength(1);
  return read(printed[0] ?? '');
}

const python = spawnSync('python3', ['--version']).status === 0;

/** All programs in one Python, each for itself. */
const RUNNER = `
import contextlib, io, json, sys
for text in json.load(sys.stdin):
    out = io.StringIO()
    with contextlib.redirect_stdout(out):
        exec(compile(text, "ray.py", "exec"), {"__name__": "__main__"})
    print(out.getvalue().strip())
`;

function runPython(texts: readonly string[]): unknown[] {
  const { stdout, stderr, status } = spawnSync('python3', ['-c', RUNNER], {
    input: JSON.stringify(texts),
    encoding: 'utf8',
    maxBuffer: 1e8,
  });
  if (status !== 0) throw new Error(stderr);
  // Python's JSON has words for the infinities, and −0.0 with its sign.
  return stdout
    .trim()
    .split('\n')
    .map((line) => read(line.replace(/-?Infinity/g, '"$&"')));
}

test('the cases by hand cover every shape, every class, an infinity and −0', () => {
  const seen = EXPORT_CASES.map((c) => ({ c, answer: textbookAnswer(c) }));
  const classes = (kind: string) =>
    [...new Set(seen.filter(({ c }) => c.shape.kind === kind).map(({ answer }) => answer.class))]
      .sort()
      .join(' ');
  expect(classes('cylinder')).toBe('contained none one tangent two undecided');
  expect(classes('cone')).toBe('contained none one tangent two undecided');
  expect(classes('hyperboloid')).toBe('contained none one tangent two undecided');
  expect(classes('plane')).toBe('contained none one undecided');
  expect(classes('circle')).toBe('contained none one undecided');
  expect(classes('square')).toBe('contained none one');
  const numbers = seen.flatMap(({ answer }) => answer.hits.flatMap((h) => [h.t, ...h.point]));
  expect(numbers).toContain(Number.POSITIVE_INFINITY);
  expect(seen.flatMap(({ answer }) => answer.hits.map(({ t }) => t))).toContain(-0);
  expect(seen.some(({ answer }) => answer.hits.some(({ singular }) => singular))).toBe(true);
});

test('reading keeps −0 and the infinities', () => {
  expect(read('[0, "-0", -0.0, "Infinity", "-Infinity", "none"]')).toEqual([
    0,
    -0,
    -0,
    Infinity,
    -Infinity,
    'none',
  ]);
});

describe('TypeScript prints what the textbook method finds', () => {
  test.each(EXPORT_CASES)('$name', async (c) => {
    expect(await runTypeScript(rayTypeScript(modelOf(c)))).toEqual(textbookAnswer(c));
  });

  test(`and on ${HARD_CASES.length} hard rays`, { timeout: PATIENCE }, async () => {
    for (const c of HARD_CASES) {
      expect(await runTypeScript(rayTypeScript(modelOf(c))), c.name).toEqual(textbookAnswer(c));
    }
  });
});

describe.skipIf(!python)('Python (skipped where there is no python3)', () => {
  let printed: unknown[] = [];
  beforeAll(() => {
    printed = runPython(ALL.map((c) => rayPython(modelOf(c))));
  }, PATIENCE);

  test.each(EXPORT_CASES)('$name', (c) => {
    expect(printed[ALL.indexOf(c)]).toEqual(textbookAnswer(c));
  });

  test(`and on ${HARD_CASES.length} hard rays`, () => {
    expect(printed).toHaveLength(ALL.length);
    ALL.forEach((c, i) => {
      expect(printed[i], c.name).toEqual(textbookAnswer(c));
    });
  });
});

test('the comment says what is expected, and where the page says otherwise', () => {
  const rounding = EXPORT_CASES.find(({ name }) => name === 'cylinder, tangent in doubles only');
  if (!rounding) throw new Error('no such case');
  const text = rayTypeScript(modelOf(rounding));
  expect(text).toContain('// Expected in doubles: tangent, t = 1000000000.\n');
  expect(text).toContain("// (The page's method, exact: two.)\n");
  expect(rayTypeScript(modelOf(rounding, 'textbook'))).not.toContain("The page's method");
});

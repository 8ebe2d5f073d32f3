import { spawnSync } from 'node:child_process';
import { mkdirSync, mkdtempSync, readFileSync, rmSync, symlinkSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { fileURLToPath } from 'node:url';
import { afterAll, beforeAll, expect, test } from 'vitest';
import { METHODS } from '../../../src/math/index.ts';
import { rayTypeScript } from '../../../src/state/exports/typescript.ts';
import { vitestCase } from '../../../src/state/exports/vitest.ts';
import { EXPORT_CASES, modelOf } from './exports-cases.ts';

/*
 * The exported tests are run by vitest and checked by tsc, in a project of their own that borrows
 * our src and node_modules.
 */

const root = fileURLToPath(new URL('../../..', import.meta.url));
/** Exact always, and the other methods in turn. */
const methodsFor = (i: number): string[] => ['exact', METHODS[i % METHODS.length]?.id ?? 'exact'];
let dir = '';

/** One wrong value each; every one of them has to be noticed. */
const ALTERED: readonly [what: string, of: string, from: string | RegExp, to: string][] = [
  ['class', 'cylinder, two', "toBe('two')", "toBe('one')"],
  ['last bit of t', 'cone, two', '2.2691800292096387', '2.269180029209638'],
  ['sign of zero in t', 'cylinder, t = −0 at E', /t: -?0, point: \[2/, 't: ZERO, point: [2'],
  ['point', 'square, inside', /point: \[[^,]*/, 'point: [7'],
  ['normal', 'plane, one', /normal: \[1, 1, 0.5\], sing/, 'normal: [1, 1, -0.5], sing'],
  ['a hit left out', 'cylinder, two', / {4}\{ t: .*\n/, ''],
  ['singular', 'cone, through the vertex', 'singular: true', 'singular: false'],
];

/** 0 becomes −0 and −0 becomes 0. */
const altered = (text: string, from: string | RegExp, to: string): string =>
  text.replace(from, (match) => to.replace('ZERO', match.includes('-0') ? '0' : '-0'));

const outcomes = new Map<string, string>();

beforeAll(() => {
  dir = mkdtempSync(join(tmpdir(), 'graze-exports-'));
  for (const name of ['src', 'node_modules']) symlinkSync(join(root, name), join(dir, name));
  writeFileSync(join(dir, 'package.json'), '{ "type": "module" }');
  EXPORT_CASES.forEach((c, i) => {
    for (const id of methodsFor(i)) {
      writeFileSync(join(dir, `right-${i}-${id}.test.ts`), vitestCase(modelOf(c, id)));
    }
  });
  ALTERED.forEach(([, of, from, to], i) => {
    const c = EXPORT_CASES.find(({ name }) => name === of);
    if (!c) throw new Error(`no case ${of}`);
    const right = vitestCase(modelOf(c));
    const wrong = altered(right, from, to);
    if (wrong === right) throw new Error(`nothing to alter in ${of}:\n${right}`);
    writeFileSync(join(dir, `wrong-${i}.test.ts`), wrong);
  });
  const env = Object.fromEntries(Object.entries(process.env).filter(([k]) => !/VITEST/.test(k)));
  const run = spawnSync(
    process.execPath,
    [
      join(root, 'node_modules/vitest/vitest.mjs'),
      'run',
      ...['--root', dir, '--no-isolate', '--pool=threads', '--no-cache'],
      ...['--reporter=json', '--outputFile', join(dir, 'report.json')],
    ],
    { cwd: dir, env, encoding: 'utf8' },
  );
  const report = JSON.parse(readReport(run.stderr));
  for (const file of report.testResults) {
    outcomes.set(file.name.replace(/.*\//, '').replace('.test.ts', ''), file.status);
  }
}, 60_000);

function readReport(stderr: string): string {
  try {
    return readFileSync(join(dir, 'report.json'), 'utf8');
  } catch {
    throw new Error(stderr);
  }
}

afterAll(() => rmSync(dir, { recursive: true, force: true }));

test.each(EXPORT_CASES.map(({ name }, i) => [name, i] as const))('%s passes', (_, i) => {
  for (const id of methodsFor(i)) expect(outcomes.get(`right-${i}-${id}`), id).toBe('passed');
});

test.each(ALTERED.map(([what], i) => [what, i] as const))('%s altered: it fails', (_, i) => {
  expect(outcomes.get(`wrong-${i}`)).toBe('failed');
});

test('the module it imports can be named', () => {
  const [c] = EXPORT_CASES;
  if (!c) throw new Error('no case');
  expect(vitestCase(modelOf(c), "../o'hara/math.ts")).toContain("from '../o\\'hara/math.ts';\n");
});

test('tests and programs are right by tsc, strictly', { timeout: 60_000 }, () => {
  const types = join(dir, 'types');
  mkdirSync(types);
  symlinkSync(join(root, 'src'), join(types, 'src'));
  symlinkSync(join(root, 'node_modules'), join(types, 'node_modules'));
  EXPORT_CASES.forEach((c, i) => {
    // A module each: the programs' names are the same.
    writeFileSync(join(types, `program-${i}.ts`), `${rayTypeScript(modelOf(c))}export {};\n`);
    writeFileSync(join(types, `case-${i}.test.ts`), vitestCase(modelOf(c)));
  });
  const base = JSON.parse(readFileSync(join(root, 'tsconfig.json'), 'utf8'));
  const tsconfig = { compilerOptions: base.compilerOptions, include: ['*.ts'] };
  writeFileSync(join(types, 'tsconfig.json'), JSON.stringify(tsconfig));
  const tsc = join(root, 'node_modules/typescript/bin/tsc');
  const run = spawnSync(process.execPath, [tsc, '-p', types], { cwd: types, encoding: 'utf8' });
  const ours = run.stdout.split('\n').filter((line) => /^(program|case)-/.test(line));
  expect(ours).toEqual([]);
});

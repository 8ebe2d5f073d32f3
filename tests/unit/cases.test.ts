import { execFileSync, spawnSync } from 'node:child_process';
import { mkdtempSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { afterAll, describe, expect, test } from 'vitest';
import { casesText, DIGITS, familiesFrom } from '../../scripts/cases/cases.ts';
import { FAMILIES } from '../../src/math/families.ts';
import { nextDown, nextUp } from '../../src/math/float/ulp.ts';
import { intersect, type Ray, type Shape } from '../../src/math/index.ts';
import { ROOT } from './docs/documents.ts';

/* Hard cases for programs in other languages, and the runner that judges one in Python. */

interface Hit {
  readonly t: string;
  readonly point: readonly string[];
  readonly normal: readonly string[];
}
interface Case {
  readonly id: string;
  readonly shape: Shape;
  readonly ray: Ray;
  readonly class: string;
  readonly hits: readonly Hit[];
}

const SEED = 7;
const casesOf = (ids: string, count: number): readonly Case[] =>
  JSON.parse(casesText({ families: familiesFrom(ids), seed: SEED, count })).cases;

describe('cases', () => {
  test.each(FAMILIES().map(({ id }) => id))(
    `of %s are answered as exactly (seed ${SEED})`,
    (id) => {
      for (const { shape, ray, class: verdict, hits } of casesOf(id, 5)) {
        const exact = intersect(shape, ray, 'exact');
        expect(verdict).toBe(exact.class);
        expect(hits.map(({ t }) => Number(t))).toEqual(exact.hits.map(({ t }) => t + 0));
        expect(hits.map(({ point }) => point.map(Number))).toEqual(
          exact.hits.map(({ point }) => point.map((x) => x + 0)),
        );
        expect(hits.map(({ normal }) => normal.map(Number))).toEqual(
          exact.hits.map(({ normal }) => normal.map((x) => x + 0)),
        );
      }
    },
  );

  test('have more digits than a double, and no more than they say', () => {
    const digits = casesOf('typical', 40).flatMap(({ hits }) =>
      hits.map(({ t }) => t.replace(/^-|\.|e.*$/g, '').length),
    );
    expect(Math.max(...digits)).toBe(DIGITS);
  });

  test('are the same beside other families, and one a line', () => {
    const alone = casesText({ families: familiesFrom('vertex'), seed: SEED, count: 3 });
    const both = casesText({ families: familiesFrom('typical,vertex'), seed: SEED, count: 3 });
    const lines = alone.split('\n').slice(1, -2);
    expect(lines).toHaveLength(3);
    expect(both.endsWith(alone.split('\n').slice(1).join('\n'))).toBe(true);
  });

  test('of a family that there is not are refused', () => {
    expect(() => familiesFrom('typical,newton')).toThrow(
      "unknown family 'newton': there are all, ",
    );
  });
});

/*
 * Each runner is given a program that says what stands in a file: a line a case, its roots; '?' for
 * a kind that it does not know, '!' for what goes wrong inside.
 */

interface Language {
  readonly name: string;
  /** What has to be there. */
  readonly tool: string;
  readonly file: string;
  readonly program: string;
  /** Compiles it, where it is to be. */
  readonly build: readonly string[];
  readonly run: readonly string[];
}

const here = (name: string): string => new URL(`scripts/cases/${name}`, ROOT).pathname;

const LANGUAGES: readonly Language[] = [
  {
    name: 'Python',
    tool: 'python3',
    file: 'program.py',
    program: `
lines = iter(open('answers.txt').read().split('\\n'))
def intersect(shape, origin, direction):
    line = next(lines)
    if line == '?':
        raise NotImplementedError()
    if line == '!':
        raise ValueError('<&"')
    return [float(t) for t in line.split()]
`,
    build: [],
    run: ['python3', here('run_cases.py'), 'cases.json', 'program:intersect'],
  },
  {
    name: 'C++',
    tool: 'g++',
    file: 'program.cpp',
    program: `
#include "${here('graze_cases.hpp')}"
#include <sstream>
std::vector<double> intersect(const graze::Shape& shape, const graze::Vec3&, const graze::Vec3&) {
  static std::ifstream in("answers.txt");
  std::string line;
  std::getline(in, line);
  if (line == "?" || shape.kind.empty()) throw graze::Unknown{};
  if (line == "!") throw std::runtime_error("<&\\"");
  std::istringstream words(line);
  std::vector<double> found;
  for (double t; words >> t;) found.push_back(t);
  return found;
}
int main(int argc, char** argv) { return graze::run(argc, argv, intersect); }
`,
    build: ['g++', '-std=c++17', '-Wall', '-Wextra', '-Werror', '-o', 'cpp', 'program.cpp'],
    run: ['./cpp', 'cases.json'],
  },
  {
    name: 'Rust',
    tool: 'rustc',
    file: 'program.rs',
    program: `
#[path = "${here('graze_cases.rs')}"]
mod graze_cases;
use std::sync::atomic::{AtomicUsize, Ordering};
static NEXT: AtomicUsize = AtomicUsize::new(0);
fn intersect(shape: &graze_cases::Shape, _: [f64; 3], _: [f64; 3]) -> Option<Vec<f64>> {
    let text = std::fs::read_to_string("answers.txt").unwrap();
    let line = text.split('\\n').nth(NEXT.fetch_add(1, Ordering::SeqCst)).unwrap();
    if line == "?" || shape.kind.is_empty() {
        return None;
    }
    Some(line.split_whitespace().map(|t| t.parse().unwrap_or(f64::NAN)).collect())
}
fn main() {
    std::process::exit(graze_cases::run(intersect))
}
`,
    build: ['rustc', '--edition', '2021', '-D', 'warnings', '-o', 'rust', 'program.rs'],
    run: ['./rust', 'cases.json'],
  },
];

const isThere = ({ tool }: Language): boolean => spawnSync(tool, ['--version']).status === 0;

describe.each(LANGUAGES.map((one) => [one.name, one] as const))('the runner in %s', (_, one) => {
  const folder = mkdtempSync(join(tmpdir(), 'graze-cases-'));
  afterAll(() => rmSync(folder, { recursive: true, force: true }));
  const started = ([file = '', ...argv]: readonly string[]) =>
    spawnSync(file, argv, { cwd: folder, encoding: 'utf8' });
  const made = (name: string): string => readFileSync(join(folder, name), 'utf8');

  const cases = casesOf('near-tangent,sphere-far', 20);
  const right = cases.map(({ hits }) => hits.map(({ t }) => Number(t)));
  const listed = (list: readonly (readonly number[])[]): string =>
    list.map((ts) => ts.join(' ')).join('\n');

  function judged(answers: string, more: readonly string[] = []) {
    writeFileSync(join(folder, 'answers.txt'), answers);
    const reports = ['--junit', 'junit.xml', '--report', 'report.markdown'];
    const { stdout, stderr, status } = started([...one.run, ...reports, ...more]);
    return { said: stdout.trim() || stderr, status };
  }

  test.runIf(isThere(one))('judges as it says', () => {
    const file = { graze: 'hard-cases', version: 1, cases };
    writeFileSync(join(folder, 'cases.json'), JSON.stringify(file));
    writeFileSync(join(folder, one.file), one.program);
    if (one.build.length > 0) expect(started(one.build).stderr).toBe('');

    const all = cases.length;
    // What is right.
    const passed = { said: `${all} passed, 0 failed, 0 skipped`, status: 0 };
    expect(judged(listed(right), ['--ulps', '0.5'])).toEqual(passed);
    // A root is missing.
    const k = right.findIndex((ts) => ts.length === 2);
    const wrong = right.map((ts, i) => (i === k ? ts.slice(1) : ts));
    expect(judged(listed(wrong))).toMatchObject({
      said: `${all - 1} passed, 1 failed, 0 skipped`,
      status: 1,
    });
    expect(made('junit.xml')).toContain('failures="1"');
    expect(made('report.markdown')).toContain(`${cases[k]?.id}: 1 roots, exactly 2 (two)`);
    // Roots are off by one or two doubles.
    const off = right.map((ts, i) => (i === k ? ts.map((t) => nextUp(nextUp(t))) : ts));
    expect(judged(listed(off), ['--ulps', '1']).status).toBe(1);
    const near = right.map((ts) => ts.map(nextDown));
    expect(judged(listed(near), ['--ulps', '2']).status).toBe(0);
    // No kind is known; everything goes wrong.
    const each = (word: string): string => cases.map(() => word).join('\n');
    expect(judged(each('?')).said).toBe(`0 passed, 0 failed, ${all} skipped`);
    expect(judged(each('!')).said).toBe(`0 passed, ${all} failed, 0 skipped`);
    // The report is XML, whatever the words in it.
    const script = 'import sys, xml.dom.minidom as m; m.parse(sys.argv[1])';
    if (spawnSync('python3', ['--version']).status === 0) {
      execFileSync('python3', ['-c', script, join(folder, 'junit.xml')]);
    }
    // A file that is none of hard cases.
    writeFileSync(join(folder, 'cases.json'), '{ "graze": "check-cases", "version": 1 }');
    expect(judged('').said).toContain('has no hard cases of version 1');
  });
});

import { execFileSync, spawnSync } from 'node:child_process';
import { mkdirSync, mkdtempSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { afterAll, describe, expect, test } from 'vitest';
import { gradeOne, kindsIn, submissionsIn } from '../../scripts/grade/grade.ts';
import { LIMITS, runProgram } from '../../scripts/grade/program.ts';
import { CASES_SEED, casesFor, gradedCases } from '../../src/check/program/cases.ts';
import { casesCsv, casesJson } from '../../src/check/program/exchange.ts';
import {
  type Graded,
  gradesCsv,
  gradescope,
  gradesMarkdown,
  junit,
  readWeights,
  scoreOf,
  WEIGHTS,
} from '../../src/check/program/marks.ts';
import { reportOf } from '../../src/check/program/report.ts';
import { readResults } from '../../src/check/program/results.ts';
import { example } from '../../src/check/program/template.ts';
import { ROOT } from './docs/documents.ts';

const folder = mkdtempSync(join(tmpdir(), 'graze-grade-'));
afterAll(() => rmSync(folder, { recursive: true, force: true }));

const SEED = 2718;
const CASES = gradedCases(['sphere'], SEED);

/** The sphere in the statements that C++, Java and Rust share, and in Python. */
const put = (name: string, text: string): string => {
  const file = join(folder, name);
  writeFileSync(file, text);
  return file;
};

const graded = async (name: string, text: string): Promise<Graded> => {
  const [one] = submissionsIn([put(name, text)]);
  if (!one) throw new RangeError(name);
  return gradeOne(one, CASES, { ...LIMITS, each: 300, total: 20_000 });
};

describe('the cases of a lecturer’s seed', () => {
  test('are others than the common ones, and their ids and order tell nothing', () => {
    const common = gradedCases(['sphere'], CASES_SEED);
    expect(common).toEqual(casesFor(['sphere'], CASES_SEED));
    const known = new Set(common.map(({ shape, ray }) => JSON.stringify([shape, ray])));
    const valid = CASES.filter(({ expected }) => expected);
    expect(valid.filter(({ shape, ray }) => known.has(JSON.stringify([shape, ray])))).toEqual([]);
    expect(CASES.every(({ id }) => /^case\/\d+$/.test(id))).toBe(true);
    const groups = CASES.map(({ group }) => group).join(' ');
    expect(groups).not.toBe([...CASES.map(({ group }) => group)].sort().join(' '));
  });

  test('a table of the common answers scores nothing on them', async () => {
    const table = casesFor(['sphere'], CASES_SEED).flatMap(({ shape, ray, expected }) =>
      expected ? [[JSON.stringify([shape, ray]), expected.t]] : [],
    );
    const source =
      `const table = new Map(${JSON.stringify(table)});\n` +
      'function intersect(shape, ray) {\n' +
      '  return { t: table.get(JSON.stringify([shape, ray])) ?? [] };\n}\n';
    expect(scoreOf(await graded('table.js', source), WEIGHTS)).toBe(0);
  });
});

describe('programs', () => {
  test('the example gets what it gets on the page, in every way of writing it', async () => {
    const source = example(['sphere']);
    const scores = await Promise.all(
      [
        ['plain.js', source],
        ['module.mjs', source.replace('function intersect', 'export function intersect')],
        ['default.mjs', source.replace('function intersect', 'export default function')],
        ['common.cjs', `${source}\nmodule.exports = { intersect };`],
        [
          'typed.ts',
          source.replace('(shape, ray)', '(shape: any, ray: { origin: number[] } & any)'),
        ],
      ].map(async ([name = '', text = '']) => scoreOf(await graded(name, text), WEIGHTS)),
    );
    expect(new Set(scores).size).toBe(1);
    expect(scores[0]).toBeGreaterThan(70);
  });

  test.each([
    ['endless.js', 'function intersect() { for (;;); }', 'took more than 0.3 s'],
    ['start.js', 'for (;;);', 'does not get to its end'],
    ['promise.js', 'function intersect() { const f = () => Promise.resolve().then(f); f(); }', ''],
    ['memory.js', 'function intersect() { const a = []; for (;;) a.push([...Array(99)]); }', 's'],
    ['syntax.js', 'function intersect( {', 'syntax error'],
    ['nothing.js', 'const a = 1;', 'there is no function intersect'],
    ['typed.ts', 'const a: number = ;', 'line 1: syntax error'],
    ['three.js', 'import * as THREE from "three"; const intersect = () => THREE;', 'stands alone'],
    ['fs.js', 'require("fs"); function intersect() {}', 'cannot be required'],
  ])('%s ends, and it is said how', async (name, text, words) => {
    const { problems } = await graded(name, text);
    expect(problems.join()).toContain(words);
  });

  test('reach nothing outside of their worker', async () => {
    const names = ['process', 'fetch', 'global', 'setTimeout', 'queueMicrotask', 'structuredClone'];
    const tries = [
      ...names.map((name) => `typeof ${name}`),
      'typeof this?.constructor?.constructor("return process")()',
      'typeof console.log.constructor("return process")()',
      'typeof shape.constructor.constructor("return process")()',
      'typeof (() => {}).constructor("return process")()',
    ];
    const source =
      `function intersect(shape, ray) {\n  const found = [${tries
        .map((text) => `(() => { try { return ${text}; } catch { return 'refused'; } })()`)
        .join(', ')}];\n` +
      "  throw new Error(found.filter((x) => !['undefined', 'refused'].includes(x)).join());\n}\n";
    const { outputs } = await runProgram(source, CASES.slice(0, 1));
    const [first] = outputs;
    expect(first).toEqual({ type: 'threw', message: '', line: 3 });
  });
});

describe('what comes out', () => {
  const right = casesJson(CASES, SEED);
  const results = CASES.map(({ id, expected }) =>
    expected ? { id, t: expected.t } : { id, error: 'invalid' },
  );

  test('missing results count as not right, and so do programs that cannot run', async () => {
    const all = await graded('all.json', JSON.stringify(results));
    const half = await graded('half.json', JSON.stringify(results.slice(0, CASES.length >> 1)));
    const none = await graded('none.json', '{');
    expect(scoreOf(all, WEIGHTS)).toBe(100);
    expect(scoreOf(half, WEIGHTS)).toBeGreaterThan(20);
    expect(scoreOf(half, WEIGHTS)).toBeLessThan(80);
    expect(half.report?.left).toBe(CASES.length - (CASES.length >> 1));
    expect(scoreOf(none, WEIGHTS)).toBe(0);
    expect(right).toContain('"case/1"');
    const only = readWeights('hard=1');
    const { groups } = half.report ?? { groups: [] };
    const hard = groups.find(({ id }) => id === 'hard');
    expect(scoreOf(half, only)).toBe(
      Math.round((1e4 * (hard?.passed ?? 0)) / (hard?.total ?? 1)) / 100,
    );
    for (const text of ['easy=1', 'hard=-1', 'hard=', 'hard=0']) {
      expect(() => readWeights(text)).toThrow(RangeError);
    }
  });

  test('is read by independent readers: CSV, results.json, JUnit XML, Markdown', async () => {
    const who = 'O’Neil & <Söhne> "x", =1+1 |';
    const all = [
      { ...(await graded('a.json', JSON.stringify(results.slice(0, 20)))), who },
      { who: 'b', report: null, problems: ['it has a \u0001 in it & <more>'] },
    ];
    put('class.csv', gradesCsv(all, WEIGHTS));
    put('junit.xml', junit(all));
    const python = [
      'import csv, json, sys, xml.etree.ElementTree as E',
      `rows = list(csv.DictReader(open(${JSON.stringify(join(folder, 'class.csv'))})))`,
      `root = E.parse(${JSON.stringify(join(folder, 'junit.xml'))}).getroot()`,
      'print(json.dumps([[r["who"] for r in rows], [s.get("name") for s in root],',
      '  [len(s) == int(s.get("tests")) for s in root], len(root.findall(".//failure"))]))',
    ].join('\n');
    const [names, suites, counted, failures] = JSON.parse(
      execFileSync('python3', ['-c', python], { encoding: 'utf8' }),
    );
    expect(names).toEqual([who, 'b']);
    expect(suites).toEqual([who, 'b']);
    expect(counted).toEqual([true, true]);
    expect(failures).toBeGreaterThan(0);
    const [first] = all;
    if (!first) throw new RangeError('nothing graded');
    const scope = JSON.parse(gradescope(first, WEIGHTS));
    const sum = scope.tests.reduce((s: number, one: { score: number }) => s + one.score, 0);
    expect(sum).toBeCloseTo(scope.score, 1);
    const most = scope.tests.reduce(
      (s: number, one: { max_score: number }) => s + one.max_score,
      0,
    );
    expect(most).toBeCloseTo(100, 1);
    const table = gradesMarkdown(all, WEIGHTS, 'x')
      .split('\n')
      .filter((line) => /^\|/.test(line));
    const bars = table.slice(0, 4).map((line) => line.replaceAll('\\|', '').split('|').length);
    expect(new Set(bars).size).toBe(1);
  });

  test('a folder is a submission by its name; what is in no file is said', () => {
    mkdirSync(join(folder, 'ada'));
    put('ada/intersect.js', '');
    put('ada/notes.js', '');
    expect(submissionsIn([join(folder, 'ada'), join(folder, 'nobody')])).toEqual([
      { who: 'ada', file: join(folder, 'ada', 'intersect.js'), problem: '' },
      { who: 'nobody', file: null, problem: `there is no ${join(folder, 'nobody')}` },
    ]);
    expect(kindsIn('cone,sphere')).toEqual(['cone', 'sphere']);
    expect(kindsIn('roots*3;shapes=cone')).toEqual(['cone']);
    expect(() => kindsIn('cube')).toThrow('neither shapes nor a set');
  });
});

/** The sphere, in each starter in place of its empty answer. */
const STARTERS = [
  {
    file: 'graze_results.py',
    empty: '    return []\n',
    full:
      '    all_numbers = [*origin, *direction, shape["radius"]]\n' +
      '    if shape["radius"] <= 0 or not all(map(math.isfinite, all_numbers)) \\\n' +
      '            or not any(direction):\n        raise ValueError("invalid, input")\n' +
      '    o = [e - c for e, c in zip(origin, shape["center"])]\n' +
      '    a = sum(x * x for x in direction)\n' +
      '    b = 2 * sum(x * y for x, y in zip(o, direction))\n' +
      '    c = sum(x * x for x in o) - shape["radius"] ** 2\n    d = b * b - 4 * a * c\n' +
      '    if d < 0:\n        return []\n    q = math.sqrt(d)\n' +
      '    return sorted({(-b - q) / (2 * a), (-b + q) / (2 * a)})\n',
    build: null,
    run: ['python3', 'graze_results.py'],
    cases: 'json',
  },
  {
    file: 'graze_results.cpp',
    empty: '    (void)shape, (void)E, (void)d;\n    return {};\n',
    full:
      '    const double r = shape.numbers.at("r"), x = E.x - shape.numbers.at("Cx"),\n' +
      '        y = E.y - shape.numbers.at("Cy"), z = E.z - shape.numbers.at("Cz");\n' +
      '    const double a = d.x * d.x + d.y * d.y + d.z * d.z;\n' +
      '    if (!(r > 0) || !(a > 0) || !(x * x + y * y + z * z < 1e300))\n' +
      '        throw std::runtime_error("no");\n' +
      '    const double b = 2 * (x * d.x + y * d.y + z * d.z),\n' +
      '        c = x * x + y * y + z * z - r * r;\n' +
      '    const double D = b * b - 4 * a * c;\n    if (D < 0) return {};\n' +
      '    if (D == 0) return {-b / (2 * a)};\n' +
      '    return {(-b - __builtin_sqrt(D)) / (2 * a), (-b + __builtin_sqrt(D)) / (2 * a)};\n',
    build: ['g++', '-std=c++17', 'graze_results.cpp', '-o', 'cpp_results'],
    run: ['./cpp_results'],
    cases: 'csv',
  },
  {
    file: 'GrazeResults.java',
    empty: '        return new double[] {};\n',
    full:
      '        double r = numbers.get("r"), a = d[0] * d[0] + d[1] * d[1] + d[2] * d[2];\n' +
      '        double x = E[0] - numbers.get("Cx"), y = E[1] - numbers.get("Cy"), ' +
      'z = E[2] - numbers.get("Cz");\n' +
      '        if (!(r > 0) || !(a > 0) || !(x * x + y * y + z * z < 1e300))\n' +
      '            throw new IllegalArgumentException("no, not this");\n' +
      '        double b = 2 * (x * d[0] + y * d[1] + z * d[2]),\n' +
      '            c = x * x + y * y + z * z - r * r;\n' +
      '        double D = b * b - 4 * a * c, q = Math.sqrt(D);\n' +
      '        if (D < 0) return new double[] {};\n' +
      '        if (D == 0) return new double[] {-b / (2 * a)};\n' +
      '        return new double[] {(-b - q) / (2 * a), (-b + q) / (2 * a)};\n',
    build: null,
    run: ['java', 'GrazeResults.java'],
    cases: 'csv',
  },
  {
    file: 'graze_results.rs',
    empty: '    Ok(vec![])\n',
    full:
      '    let n = |name: &str| shape.numbers.get(name).copied().unwrap_or(f64::NAN);\n' +
      '    let o = [origin[0] - n("Cx"), origin[1] - n("Cy"), origin[2] - n("Cz")];\n' +
      '    let dot = |u: [f64; 3], v: [f64; 3]| u[0] * v[0] + u[1] * v[1] + u[2] * v[2];\n' +
      '    let (r, a, b) = (n("r"), dot(direction, direction), 2.0 * dot(o, direction));\n' +
      '    if !(r > 0.0) || !(a > 0.0) || !(dot(o, o) < 1e300) {\n' +
      '        return Err("no, not".into()); }\n' +
      '    let disc = b * b - 4.0 * a * (dot(o, o) - r * r);\n' +
      '    if disc < 0.0 { return Ok(vec![]); }\n' +
      '    if disc == 0.0 { return Ok(vec![-b / (2.0 * a)]); }\n    let q = disc.sqrt();\n' +
      '    Ok(vec![(-b - q) / (2.0 * a), (-b + q) / (2.0 * a)])\n',
    build: ['rustc', '-O', 'graze_results.rs', '-o', 'rs_results'],
    run: ['./rs_results'],
    cases: 'csv',
  },
] as const;

const isThere = (command: string): boolean =>
  command.startsWith('./') || spawnSync(command, ['--version']).status === 0;

describe('starters', () => {
  const files = { json: casesJson(CASES, SEED), csv: casesCsv(CASES) };
  const there = STARTERS.filter(({ build, run }) => isThere(build?.[0] ?? run[0]));

  test('of one language at least can be run here', () => expect(there.length).toBeGreaterThan(0));

  test.each(there)('$file answers every case, empty and filled in', (starter) => {
    const { file, empty, full, build, run, cases } = starter;
    const source = readFileSync(new URL(`scripts/grade/starters/${file}`, ROOT), 'utf8');
    expect(source).toContain(empty);
    put(`cases.${cases}`, files[cases]);
    const scores = [source, source.replace(empty, full)].map((text) => {
      put(file, text);
      const at = { cwd: folder, stdio: 'pipe' as const };
      if (build) execFileSync(build[0], build.slice(1), at);
      execFileSync(run[0], [...run.slice(1), `cases.${cases}`, `results.${cases}`], at);
      const read = readResults(readFileSync(join(folder, `results.${cases}`), 'utf8'), CASES);
      expect(read).toMatchObject({ ok: true, problems: [] });
      return read.ok ? gradeOf(read.outputs) : 0;
    });
    expect(scores[0]).toBe(0);
    expect(scores[1]).toBeGreaterThan(70);
  });
});

function gradeOf(outputs: Parameters<typeof reportOf>[1]): number {
  return scoreOf({ who: 'x', report: reportOf(CASES, outputs), problems: [] }, WEIGHTS);
}

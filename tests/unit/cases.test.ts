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
  test.each(FAMILIES.map(({ id }) => id))(`of %s are answered as exactly (seed ${SEED})`, (id) => {
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
  });

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

const python = ['python3', 'python'].find((name) => spawnSync(name, ['--version']).status === 0);

describe.runIf(python)('the runner in Python', () => {
  const folder = mkdtempSync(join(tmpdir(), 'graze-cases-'));
  afterAll(() => rmSync(folder, { recursive: true, force: true }));
  const runner = new URL('scripts/cases/run_cases.py', ROOT).pathname;

  function judged(program: string, cases: readonly Case[], more: readonly string[] = []) {
    writeFileSync(join(folder, 'program.py'), program);
    const file = { graze: 'hard-cases', version: 1, cases };
    writeFileSync(join(folder, 'cases.json'), JSON.stringify(file));
    const argv = [runner, 'cases.json', 'program:intersect', '--junit', 'junit.xml'];
    const options = { cwd: folder, encoding: 'utf8' as const };
    const ran = spawnSync(python ?? '', [...argv, '--report', 'report.markdown', ...more], options);
    return { said: ran.stdout.trim() || ran.stderr, status: ran.status };
  }
  const made = (name: string): string => readFileSync(join(folder, name), 'utf8');

  /** Answers by a list of its own. */
  const answering = (ts: readonly (readonly number[])[]): string =>
    `answers = iter(${JSON.stringify(ts)})\ndef intersect(shape, origin, direction):\n` +
    '    return next(answers)\n';
  const cases = casesOf('near-tangent,sphere-far', 20);
  const right = cases.map(({ hits }) => hits.map(({ t }) => Number(t)));

  test('passes what is right', () => {
    expect(judged(answering(right), cases, ['--ulps', '0.5'])).toEqual({
      said: `${cases.length} passed, 0 failed, 0 skipped`,
      status: 0,
    });
  });

  test('fails a missing root, and one that is off, and says where', () => {
    const k = right.findIndex((ts) => ts.length === 2);
    const wrong = right.map((ts, i) => (i === k ? ts.slice(1) : ts));
    expect(judged(answering(wrong), cases).status).toBe(1);
    expect(made('junit.xml')).toContain('failures="1"');
    expect(made('report.markdown')).toContain(`${cases[k]?.id}: 1 roots, exactly 2 (two)`);
    const off = right.map((ts, i) => (i === k ? ts.map((t) => nextUp(nextUp(t))) : ts));
    expect(judged(answering(off), cases, ['--ulps', '1']).status).toBe(1);
    const near = right.map((ts) => ts.map(nextDown));
    expect(judged(answering(near), cases, ['--ulps', '2']).status).toBe(0);
  });

  test('skips what is not known, and takes an exception for an answer', () => {
    const unknown = 'def intersect(*_):\n    raise NotImplementedError()\n';
    expect(judged(unknown, cases).said).toBe(`0 passed, 0 failed, ${cases.length} skipped`);
    const broken = 'def intersect(*_):\n    return 1 / 0\n';
    expect(judged(broken, cases).said).toBe(`0 passed, ${cases.length} failed, 0 skipped`);
    expect(made('report.markdown')).toContain('ZeroDivisionError');
  });

  test('its JUnit file is XML that a parser takes', () => {
    const script = 'import sys, xml.dom.minidom as m; m.parse(sys.argv[1])';
    const broken = 'def intersect(*_):\n    raise ValueError("<&\\"")\n';
    judged(broken, cases);
    execFileSync(python ?? '', ['-c', script, join(folder, 'junit.xml')]);
  });
});

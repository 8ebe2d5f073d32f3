import { describe, expect, test } from 'vitest';
import { casesFor, GROUPS } from '../../../src/check/program/cases.ts';
import type { Output } from '../../../src/check/program/judge.ts';
import { readReply, readValue } from '../../../src/check/program/protocol.ts';
import { reportOf } from '../../../src/check/program/report.ts';
import {
  adviceFor,
  asScript,
  LONGEST_PROGRAM,
  looksTyped,
  tooLong,
} from '../../../src/check/program/script.ts';
import { stripTypes } from '../../../src/check/program/strip.ts';
import { example, template, textbookFor } from '../../../src/check/program/template.ts';
import { FIRST_SET, setOf } from '../../../src/check/sets.ts';
import { intersect } from '../../../src/math/index.ts';
import { curved, exactly, run } from './students.ts';

const KINDS = setOf(FIRST_SET).shapes;
const SEED = 41;

describe('cases', () => {
  test.each(KINDS)('%s has all four groups, each id once', (kind) => {
    const cases = casesFor([kind], SEED);
    expect(new Set(cases.map(({ group }) => group)).size).toBe(GROUPS.length);
    expect(new Set(cases.map(({ id }) => id)).size).toBe(cases.length);
    expect(cases.length).toBeGreaterThan(30);
    expect(cases.every(({ shape }) => Object.is(shape.kind, kind))).toBe(true);
  });

  test('are the same for the same seed and differ for another', () => {
    const text = (seed: number) => JSON.stringify(casesFor(['cone'], seed));
    expect(text(1)).toBe(text(1));
    expect(text(1)).not.toBe(text(2));
  });

  test('every invalid case is refused by our own intersect', () => {
    for (const { group, shape, ray } of casesFor(KINDS, SEED)) {
      if (group === 'invalid') expect(() => intersect(shape, ray)).toThrow();
    }
  });
});

describe('a report', () => {
  test('the exact method passes every case, and shows no misconception', () => {
    const cases = casesFor(KINDS, SEED);
    const report = reportOf(cases, exactly(cases));
    const failed = report.families.filter(({ passed, total }) => passed < total);
    expect(failed.map(({ family, says }) => [family, says])).toEqual([]);
    expect(report.findings).toEqual([]);
    expect(report.left).toBe(0);
  });

  test.each(KINDS)('the textbook program of %s passes what is ordinary or special', (kind) => {
    const cases = casesFor([kind], SEED);
    const report = reportOf(cases, run(example([kind]), cases));
    const failed = report.families.filter(
      ({ group, passed, total }) => (group === 'ordinary' || group === 'special') && passed < total,
    );
    expect(failed.map(({ family, says, first }) => [family, says, first?.case.id])).toEqual([]);
    expect(report.findings).toEqual([]);
  });

  test('the textbook program loses hard cases of a cylinder, and says digits', () => {
    const cases = casesFor(['cylinder'], SEED);
    const { families } = reportOf(cases, run(example(['cylinder']), cases));
    const hard = families.filter(({ group }) => group === 'hard');
    expect(hard.some(({ passed, total }) => passed < total)).toBe(true);
    expect(hard.map(({ says }) => says).join()).toContain('fewer than nine digits right');
  });

  test.each(KINDS)(
    'the example for %s keeps the contract on ordinary and invalid input',
    (kind) => {
      const cases = casesFor([kind], SEED);
      const { groups } = reportOf(cases, run(example([kind]), cases));
      for (const { id, passed, total } of groups)
        if (id !== 'hard') expect([id, passed]).toEqual([id, total]);
    },
  );

  test('the example for all shapes is one for all shapes', () => {
    const cases = casesFor(KINDS, SEED);
    const { groups } = reportOf(cases, run(example(KINDS), cases));
    for (const { id, passed, total } of groups)
      if (id !== 'hard') expect([id, passed]).toEqual([id, total]);
  });

  test('a branch says for which of several shapes it fails', () => {
    const cases = casesFor(['cone', 'cylinder'], SEED);
    const right = exactly(cases);
    const outputs = cases.map(({ shape }, i): Output | undefined =>
      shape.kind === 'cone' ? { type: 'value', t: [7], normal: null } : right[i],
    );
    const two = reportOf(cases, outputs).branches.find(({ id }) => id === 'two');
    expect(two?.says).toMatch(/ \(cone\)$/);
    const one = casesFor(['cone'], SEED);
    const alone = reportOf(one, outputs.slice(0, one.length)).branches.find(
      ({ id }) => id === 'two',
    );
    expect(alone?.says).not.toContain('cone');
  });

  test.each([
    ['the template', template(KINDS)],
    ['always no t', 'const intersect = () => ({ t: [] })'],
    ['always an error', 'const intersect = () => { throw new Error("no") }'],
    ['always null', 'const intersect = () => null'],
  ])('%s is right nowhere', (_, source) => {
    const cases = casesFor(KINDS, SEED);
    const { groups, silent, findings } = reportOf(cases, run(source, cases));
    expect(silent).toBe(true);
    expect(groups.map(({ passed }) => passed)).toEqual([0, 0, 0, 0]);
    expect(findings).toEqual([]);
  });

  test('hard cases stand beside what the methods get there', () => {
    const cases = casesFor(KINDS, SEED);
    for (const method of ['textbook', 'certified']) {
      const outputs = cases.map(({ shape, ray }): Output => {
        try {
          const { hits } = intersect(shape, ray, method);
          const normal = hits.map((hit) => hit.normal);
          return { type: 'value', t: hits.map(({ t }) => t), normal };
        } catch (error) {
          return { type: 'threw', message: String(error), line: null };
        }
      });
      const { groups } = reportOf(cases, outputs);
      const hard = groups.find(({ id }) => id === 'hard');
      expect(hard?.others.find((one) => one.method === method)?.passed).toBe(hard?.passed);
      // Elsewhere nothing stands beside the score, as both get all.
      for (const { id, passed, total } of groups) if (id !== 'hard') expect(passed).toBe(total);
    }
  });

  test('one reason for all is written once', () => {
    const cases = casesFor(['cone'], SEED);
    const { common } = reportOf(cases, run('const intersect = () => ["1", 2]', cases));
    expect(common).toBe('returned an array: return { t: [ … ] }');
    expect(reportOf(cases, exactly(cases)).common).toBe('');
  });

  test('what is left of a run that was stopped is not right', () => {
    const cases = casesFor(['plane'], SEED);
    const report = reportOf(cases, [...exactly(cases).slice(0, 3), { type: 'stopped' }]);
    const passed = report.groups.reduce((sum, group) => sum + group.passed, 0);
    const total = report.groups.reduce((sum, group) => sum + group.total, 0);
    expect({ passed, total, left: report.left }).toEqual({
      ...{ passed: 3, total: cases.length, left: cases.length - 4 },
    });
    expect(report.families[0]?.first?.verdict.says).toBe('did not end within a second');
  });

  test('textbook for several shapes is one program', () => {
    const cases = casesFor(KINDS, SEED).filter(({ group }) => group === 'ordinary');
    const source = textbookFor(KINDS, 'textbook');
    const outputs = run(`${source}; const intersect = textbook`, cases);
    const { groups } = reportOf(cases, outputs);
    expect(groups[0]).toMatchObject({ id: 'ordinary', passed: cases.length });
  });
});

describe('results', () => {
  test.each([
    [[1, 2], [1, 2], 'an array'],
    [[], [], 'an array'],
    [null, [], 'nothing'],
    [undefined, [], 'nothing'],
  ])('%j is understood, and that is said', (value, t, loose) => {
    expect(readValue(value)).toEqual({ type: 'value', t, normal: null, loose });
  });

  test.each([
    [['1'], 'array'],
    [7, '7'],
    [{}, 't is nothing'],
    [{ t: 3 }, 't is 3'],
    [{ t: [1, 'two'] }, "'two'"],
    [{ t: [1], normal: [[1, 2]] }, 'triples'],
    [{ t: Array.from({ length: 100 }, () => 1) }, '100 entries'],
  ])('%j is named', (value, words) => {
    const read = readValue(value);
    expect(read.type).toBe('shape');
    expect(read).toMatchObject({ message: expect.stringContaining(words) });
  });

  test.each([
    null,
    3,
    'x',
    [],
    {},
    { type: 'case' },
    { type: 'case', id: 1, index: 0.5, output: {} },
    { type: 'run', id: 1 },
  ])('the message %j is none', (data) => expect(readReply(data)).toBeNull());
});

describe('one line on all results', () => {
  const cases = casesFor(['cylinder'], SEED);
  const remarksOf = (source: string): string => reportOf(cases, run(source, cases)).remarks.join();
  test.each([
    [
      'float32 on the way',
      curved({ c: 'Math.fround(px * px + pz * pz - k * py * py - rr)' }),
      'digits of t are right',
    ],
    ['float32 results', curved({ out: 'ts = ts.map(Math.fround)' }), 'single precision'],
    [
      'toFixed(3)',
      curved({ out: 'ts = ts.map((t) => Number(t.toFixed(3)))' }),
      'rounded to 3 decimals',
    ],
    [
      'toPrecision(5)',
      curved({ out: 'ts = ts.map((t) => Number(t.toPrecision(5)))' }),
      'rounded to 5 digits',
    ],
    [
      'null for a miss',
      curved({ out: 'if (ts.length === 0) return null' }),
      'an empty array, not null',
    ],
    ['arrays', curved({ out: 'if (ts) return ts' }), 'returned a plain array'],
    [
      'the larger root first',
      curved({ pair: '[Math.max(t1, t2), Math.min(t1, t2)]' }),
      'not in ascending order: sort them',
    ],
    ['no roots at D > 0', curved({ miss: 'if (disc > 0) return out([]);' }), 'look at D'],
  ])('%s', (_, source, words) => expect(remarksOf(source)).toContain(words));

  test.each([
    ['right', curved({})],
    ['wrong', curved({ rr: 'shape.radius' })],
    ['nothing', 'const intersect = () => ({ t: [] })'],
  ])('nothing on a program that is %s', (_, source) => expect(remarksOf(source)).toBe(''));
});

describe('the text of a program', () => {
  test.each([
    ['export function intersect() {}', 'function intersect() {}'],
    ['export default function intersect() {}', 'function intersect() {}'],
    ['export default (shape, ray) => 1;', 'graze_default = (shape, ray) => 1;'],
    ['const hit = 1;\nexport default hit;', 'const hit = 1;\ngraze_default = hit;'],
    ['export const a = 1;\nexport { a };', 'const a = 1;\n'],
  ])('%j loses its exports, and no line', (source, script) =>
    expect(asScript(source)).toBe(script),
  );

  test.each([
    ['import * as THREE from "three";', 'syntax error: x', 'stands alone'],
    ['function intersect( {', 'syntax error: x', ''],
    ['const a = { t: 1 ? 2 : 3 };', 'syntax error: x', ''],
  ])('%j is told what to do', (source, message, words) =>
    words === ''
      ? expect(adviceFor(source, message)).toBe('')
      : expect(adviceFor(source, message)).toContain(words),
  );

  /** Each answers 7 and 8, as the sandbox's harness finds it. */
  test.each([
    'function intersect() { return { t: [7, 8] }; }',
    'const intersect = () => ({ t: [7, 8] });',
    'export const intersect = () => ({ t: [7, 8] });',
    'export default () => ({ t: [7, 8] });',
    'module.exports = () => ({ t: [7, 8] });',
    'module.exports = { intersect: () => ({ t: [7, 8] }) };',
    'exports.intersect = () => ({ t: [7, 8] });',
    'class Cone { intersect() { return { t: this.ts }; } ts = [7, 8]; }',
    'class Cone { static intersect() { return { t: [7, 8] }; } }',
    'export default class { intersect() { return { t: [7, 8] }; } }',
    'export class Cone { intersect() { return { t: [7, 8] }; } }',
    'const module = 1; const exports = 2; function intersect() { return { t: [7, 8] }; }',
    'class P {} const solver = { intersect() { return { t: [7, 8] }; } }; ' +
      'module.exports = solver;',
    'interface A { t: number[] } ' +
      'export function intersect(a: unknown): A { return { t: [7, 8] }; }',
    'enum Side { In, Out = 7 } const intersect = (): { t: number[] } => ({ t: [Side.Out, 8] });',
    'class C { constructor(private a = 7) {} intersect(): any { return { t: [this.a, 8]! }; } }',
  ])('%j is called', (source) => {
    const stripped = looksTyped(source) ? stripTypes(source) : { ok: true, text: source };
    const text = asScript('text' in stripped ? stripped.text : '');
    const found = new Function(
      'graze_default',
      `${text}\n; return typeof intersect === 'function' ? intersect : graze_default;`,
    )();
    expect(found({}, {})).toEqual({ t: [7, 8] });
  });

  test('what is required is refused in words', () => {
    const call = new Function('graze_default', asScript("const fs = require('fs');"));
    expect(() => call()).toThrow('fs cannot be required: a program stands alone here');
  });

  test('types go, and lines stay where they were', () => {
    const source = 'interface A {\n  t: number;\n}\n\nfunction f(a: A): number {\n  return a.t;\n}';
    const stripped = stripTypes(source);
    expect(stripped).toMatchObject({ ok: true });
    if (stripped.ok) expect(stripped.text.split('\n')[5]).toContain('return a.t;');
    expect(stripTypes('const a: number = ;\n')).toMatchObject({ ok: false, line: 1 });
  });

  test('may be so long, and no longer', () => {
    expect(tooLong('x'.repeat(LONGEST_PROGRAM))).toBe('');
    expect(tooLong('x'.repeat(LONGEST_PROGRAM + 1))).toContain(String(LONGEST_PROGRAM));
  });
});

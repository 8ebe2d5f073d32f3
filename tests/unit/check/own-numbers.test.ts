import { describe, expect, test } from 'vitest';
import { checkOwn, ownFields } from '../../../src/check/own-numbers.ts';
import {
  askedAt,
  hinted,
  readProgress,
  readSessions,
  solutionShown,
  started,
  tried,
  typed,
  withSession,
} from '../../../src/check/progress.ts';
import { plan, question } from '../../../src/check/session.ts';
import { LATEST_SET } from '../../../src/check/sets.ts';
import { summary, summaryJson } from '../../../src/check/summary.ts';
import type { Input } from '../../../src/check/types.ts';
import { intersect } from '../../../src/math/index.ts';

const CYLINDER: Input = {
  shape: { kind: 'cylinder', center: [1, 0, -1], radius: 2 },
  ray: { origin: [6, 1, 2], direction: [-1, 0.5, -0.5] },
};
const marks = (input: Input, texts: Record<string, string>) => {
  const report = checkOwn(input, texts);
  return {
    ...report,
    verdicts: Object.fromEntries(report.lines.map(({ field, verdict }) => [field.id, verdict])),
  };
};

describe('own numbers', () => {
  const A = 1.25;
  const B = -13;
  const C = 30;
  const D = B * B - 4 * A * C;
  const t = (sign: number, b = B, d = D) => String((-b + sign * Math.sqrt(d)) / (2 * A));

  test('all right, as far as the student got', () => {
    const report = marks(CYLINDER, { A: '5/4', B: '-13', C: '30', D: '19', t1: t(-1) });
    expect(report.verdicts).toEqual({
      A: 'correct',
      B: 'correct',
      C: 'correct',
      D: 'correct',
      t1: 'correct',
    });
    expect(report.firstWrong).toBeNull();
    expect(report.says).toBe('All that you typed is right.');
  });

  test('later steps are judged on the own earlier value', () => {
    const b = -12;
    const d = b * b - 4 * A * C + 40;
    const report = marks(CYLINDER, {
      ...{ A: '1.25', B: String(b), C: '30', D: String(b * b - 4 * A * C) },
      t1: t(-1, b, d),
    });
    expect(report.verdicts).toMatchObject({ A: 'correct', B: 'wrong', D: 'follows', t1: 'wrong' });
    expect(report.firstWrong?.id).toBe('B');
    expect(report.says).toContain('the first wrong step is B');
    expect(report.says).toContain('D is right for your B');
  });

  test('roots that are right for the own B are said to be', () => {
    const b = -14;
    const d = b * b - 4 * A * C;
    const report = marks(CYLINDER, {
      A: '1.25',
      B: '-14',
      C: '30',
      t1: t(-1, b, d),
      t2: t(1, b, d),
    });
    expect(report.verdicts).toMatchObject({ B: 'wrong', t1: 'follows', t2: 'follows' });
    expect(report.says).toBe(
      'B is wrong; the first wrong step is B. Your t₁ and t₂ are right for your B.',
    );
    expect(report.causes).toEqual([]);
  });

  test('a known cause is named, with all that follows from it', () => {
    const c = 32;
    const d = B * B - 4 * A * c;
    const report = marks(CYLINDER, { A: '1.25', B: '-13', C: '32', D: String(d), t1: t(-1, B, d) });
    expect(report.causes.map(({ id }) => id)).toEqual(['r-for-r2']);
    expect(report.verdicts).toMatchObject({ C: 'wrong', D: 'follows', t1: 'follows' });
  });

  test('a quantity that does not exist can be said not to', () => {
    const past = { ...CYLINDER, ray: { ...CYLINDER.ray, origin: [6, 1, 20] as const } };
    expect(intersect(past.shape, past.ray).class).toBe('none');
    expect(marks(past, { t1: 'none', t2: '-' }).verdicts).toEqual({ t1: 'absent', t2: 'absent' });
    const claimed = marks(past, { t1: '3' });
    expect(claimed.lines[0]).toMatchObject({ verdict: 'wrong', note: 'it does not exist' });
    expect(marks(CYLINDER, { t1: 'none' }).lines[0]).toMatchObject({
      verdict: 'wrong',
      note: 'it exists',
    });
  });

  test('what cannot be read is not blamed', () => {
    const report = marks(CYLINDER, { A: 'abc', B: '-13' });
    expect(report.verdicts).toEqual({ A: 'invalid', B: 'correct' });
    expect(report.firstWrong).toBeNull();
    expect(report.says).toContain('A could not be read');
    expect(marks(CYLINDER, {}).says).toContain('Nothing typed yet');
  });

  test('a figure asks for inside, a plane does not', () => {
    const ray = { origin: [0, 3, 0], direction: [0, -1, 0.5] } as const;
    const plane: Input = { shape: { kind: 'plane', normal: [0, 1, 0], point: [0, 1, 0] }, ray };
    const circle: Input = {
      shape: { kind: 'circle', normal: [0, 1, 0], center: [0, 1, 0], radius: 2 },
      ray,
    };
    const ids = (input: Input) => ownFields(input).map(({ id }) => id);
    expect(ids(plane)).toEqual(['N.(E-P)', 'N.d', 't1', 'P1']);
    expect(ids(circle)).toEqual(['N.(E-P)', 'N.d', 't1', 'P1', 'inside']);
    const report = marks(circle, {
      'N.(E-P)': '2',
      'N.d': '1',
      t1: '-2',
      P1: '0, 5, -1',
      inside: 'outside',
    });
    expect(report.verdicts).toEqual({
      'N.(E-P)': 'correct',
      'N.d': 'wrong',
      t1: 'follows',
      P1: 'follows',
      inside: 'follows',
    });
  });
});

describe('progress', () => {
  const posed = question(41, 0);
  const right = { verdict: 'correct', causes: [], marks: {}, follow: {}, way: null } as const;
  const wrong = {
    ...right,
    verdict: 'wrong',
    causes: posed.suspects.slice(0, 1).map(({ misconception }) => misconception),
  } as const;

  test('counts tries, hints and causes, and stops at the right answer', () => {
    let progress = typed(started(41), 0, 't', '1/3');
    progress = tried(progress, 0, { ...right, verdict: 'invalid' });
    expect(askedAt(progress, 0).tries).toBe(0);
    progress = tried(tried(progress, 0, wrong), 0, wrong);
    progress = hinted(hinted(hinted(progress, 0, 2), 0, 2), 0, 2);
    progress = tried(tried(progress, 0, right), 0, wrong);
    expect(askedAt(progress, 0)).toMatchObject({
      tries: 3,
      solvedAt: 3,
      hints: 2,
      texts: { t: '1/3' },
    });
    expect(askedAt(progress, 0).causes).toHaveLength(1);
    expect(summary(progress).lines[0]?.says).toBe('right at try 3');
    expect(summary(progress)).toMatchObject({ right: 1, total: plan(41).length });
  });

  test('what comes after the solution does not count', () => {
    const progress = tried(solutionShown(started(41), 2), 2, right);
    expect(askedAt(progress, 2).solvedAt).toBeNull();
    expect(summary(progress).lines[2]?.says).toBe('solution read');
  });

  test('comes back from storage', () => {
    const progress = tried(typed(started(41), 3, 't1', '√2'), 3, wrong);
    expect(readProgress(JSON.stringify(progress))).toEqual(progress);
  });

  test('each set has sessions of its own; one kept before there were sets is of the first', () => {
    const first = typed(started(41), 0, 't1', '1');
    const second = typed(started(41, LATEST_SET), 0, 't1', '2');
    const kept = withSession(withSession([], first), second);
    expect(readSessions(JSON.stringify(kept))).toEqual([first, second]);
    const { set: _, ...before } = first;
    expect(readProgress(JSON.stringify(before))).toEqual(first);
    expect(summary(second)).toMatchObject({
      set: LATEST_SET,
      total: plan(41, LATEST_SET).length,
    });
  });

  test.each([
    null,
    '',
    '{"seed":1,"set":"77","asked":{}}',
    '{',
    '[]',
    '{"seed":"1","asked":{}}',
    '{"seed":1}',
    '{"seed":1.5,"asked":{}}',
  ])('a stored %j is nothing', (text) => expect(readProgress(text)).toBeNull());

  test('strange entries of a store are dropped', () => {
    const text =
      '{"seed":1,"asked":{"0":{"tries":-1,"hints":0},"x":{"tries":1,"hints":0},"1":{"trie' +
      's":2,"hints":1,"texts":{"a":3,"b":"4"},"causes":[1,"c"]}}}';
    expect(readProgress(text)?.asked).toEqual({
      1: {
        texts: { b: '4' },
        tries: 2,
        solvedAt: null,
        hints: 1,
        solutionShown: false,
        causes: ['c'],
      },
    });
  });

  test('the summary as JSON says what it is', () => {
    const data = JSON.parse(summaryJson(tried(started(7), 1, wrong))) as { lines: unknown[] };
    expect(data).toMatchObject({ graze: 'check-summary', version: 1, seed: 7, right: 0 });
    expect(data.lines).toHaveLength(plan(7).length);
  });
});

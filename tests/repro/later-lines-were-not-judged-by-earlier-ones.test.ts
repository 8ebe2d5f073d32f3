import { expect, test } from 'vitest';
import { derivationFor } from '../../src/check/compose.ts';
import { judge } from '../../src/check/judge.ts';
import { meaningOf } from '../../src/check/meaning.ts';
import { checkOwn } from '../../src/check/own-numbers.ts';
import { readSessions } from '../../src/check/progress.ts';
import { question } from '../../src/check/session.ts';
import type { Input } from '../../src/check/types.ts';

const CYLINDER: Input = {
  shape: { kind: 'cylinder', center: [1, 0, 2], radius: 2 },
  ray: { origin: [-4, 1, 3], direction: [2, 0.5, -0.3] },
};
const followed = (seed: number, number: number, texts: Record<string, string>): string[] =>
  Object.keys(judge(derivationFor(question(seed, number - 1)), texts).follow);

test('a flat question: inside or outside is judged at the student’s own t', () => {
  expect(followed(55, 3, { 'N.d': '99', t1: '99', inside: 'inside' })).toEqual([]);
  expect(followed(123, 3, { 'N.d': '-2', t1: '2.5', inside: 'inside' })).toEqual(['inside']);
});

test('no root follows from a negative D, and sentences go forward only', () => {
  const report = checkOwn(CYLINDER, {
    ...{ A: '4.09', B: '-10.3', C: '22', D: '-253.83' },
    ...{ t1: '-', t2: 'none', P1: '-' },
  });
  const verdicts = report.lines.map(({ verdict }) => verdict);
  expect(verdicts).toEqual([
    ...['correct', 'wrong', 'correct'],
    ...['follows', 'follows', 'follows', 'follows'],
  ]);
  expect(report.says).toBe(
    'B is wrong; the first wrong step is B. Your D, t₁, t₂ and P₁ are right for your B.',
  );
});

test('without a point there is no normal, and with an own root there is an own point', () => {
  const { lines } = checkOwn(CYLINDER, { t1: 'none', P1: 'none', N1: '-' });
  expect(lines.map(({ verdict }) => verdict)).toEqual(['wrong', 'follows', 'follows']);
  const past: Input = { ...CYLINDER, ray: { ...CYLINDER.ray, origin: [-4, 1, 30] } };
  const claimed = checkOwn(past, { t1: '2', P1: '0, 2, 29.4' });
  expect(claimed.lines.map(({ verdict }) => verdict)).toEqual(['wrong', 'follows']);
  const alone = checkOwn(CYLINDER, { P1: 'none', N1: 'none' });
  expect(alone.lines.map(({ verdict }) => verdict)).toEqual(['wrong', 'follows']);
});

test('three digits, and what follows from them, are no mistakes', () => {
  const report = checkOwn(CYLINDER, {
    ...{ A: '4.09', B: '-20.6', C: '22', D: '64.4' },
    ...{ t1: '1.54', t2: '3.50', P1: '-0.926, 1.77, 2.54' },
  });
  expect(report.firstWrong).toBeNull();
  expect(report.lines[3]).toMatchObject({
    verdict: 'rounded',
    note: 'right to 3 digits, give one more',
  });
  expect(report.says).not.toContain('wrong step');
});

test('two digits are said to be two', () => {
  const input: Input = {
    shape: { kind: 'cylinder', center: [0, 0, 0], radius: 1 },
    ray: { origin: [2, 2, 2], direction: [3, 3, 3] },
  };
  const { lines, firstWrong } = checkOwn(input, { t1: '-0.90', t2: '-0.43' });
  expect(firstWrong).toBeNull();
  expect(lines.map(({ note }) => note)).toEqual([
    'right to 2 digits, give two more',
    'right to 2 digits, give two more',
  ]);
});

test.each([
  [6, '-4.50', '-3.83'],
  [17, '-6', '2.67'],
])('seed %i: rounded roots are no try', (seed, t1, t2) => {
  const judged = judge(derivationFor(question(seed, 5)), { t1, t2 });
  expect(judged.verdict).toBe('rounded');
  expect(judged.marks.t2).toMatchObject({ verdict: 'rounded', digits: 3 });
});

test('what an answer means is said of the field that is wrong', () => {
  expect(meaningOf(CYLINDER, { t1: 1.537, t2: 2 }, ['t2'])).toContain('At t = 2 ');
});

test('what was typed for t of a flat question is kept under its new name', () => {
  const stored = [
    { seed: 55, asked: { 2: { texts: { 'N.d': '-2', t: '1.5' }, tries: 1, hints: 0 } } },
  ];
  expect(readSessions(JSON.stringify(stored))[0]?.asked[2]?.texts).toEqual({
    'N.d': '-2',
    t1: '1.5',
  });
});

test('“the point is …” is wrong, said once', () => {
  const circle: Input = {
    shape: { kind: 'circle', normal: [0, 0, 1], center: [0, 0, 0], radius: 1 },
    ray: { origin: [3, 0, 2], direction: [0, 0, -1] },
  };
  const { says } = checkOwn(circle, { t1: '2', inside: 'inside' });
  expect(says).toBe('“the point is …” is wrong; the first wrong step is “the point is …”.');
});

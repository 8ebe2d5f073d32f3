import { describe, expect, test } from 'vitest';
import { caseBranch } from '../../../src/check/program/branches.ts';
import { CASES_SEED, type Case, casesFor } from '../../../src/check/program/cases.ts';
import { type BranchReport, reasonOf, reportOf } from '../../../src/check/program/report.ts';
import { shrunk } from '../../../src/check/program/shrink.ts';
import { curved, flat, run } from './students.ts';

const CASES = casesFor(['cylinder', 'cone', 'square'], CASES_SEED);
const of = (kind: string): readonly Case[] => CASES.filter(({ shape }) => shape.kind === kind);

/** The branches of a program's report, before and after, and how often it was started again. */
async function smaller(source: string, cases: readonly Case[]) {
  const { branches } = reportOf(cases, run(source, cases));
  let rounds = 0;
  const found = await shrunk(
    branches,
    async (more) => run(source, more),
    (round) => {
      rounds = round;
    },
  );
  return { before: branches, after: found, rounds };
}

const textOf = ({ first }: BranchReport): string =>
  first ? JSON.stringify([first.case.shape, first.case.ray]) : '';

const MISTAKES: readonly (readonly [string, string, string, string])[] = [
  ['the tangent lost', 'tangent', 'cylinder', curved({ miss: 'if (disc <= 0) return out([]);' })],
  ['A = 0 not handled', 'linear', 'cone', curved({ linear: '' })],
  [
    'roots behind E left out',
    'behind',
    'cylinder',
    curved({ out: 'ts = ts.filter((t) => t > 0)' }),
  ],
  [
    'the second nappe forgotten',
    'nappe',
    'cone',
    curved({ out: 'ts = ts.filter((t) => py + t * dy >= 0)' }),
  ],
  ['B halved', 'two', 'cylinder', curved({ b: 'px * dx + pz * dz - k * py * dy' })],
  [
    '< for ≤ at the edge',
    'border',
    'square',
    flat({ square: 'x[i] <= p[i] || x[i] > p[i] + shape.side' }),
  ],
];

describe('the smallest failing case', () => {
  test.each(MISTAKES)('%s: it fails in the same branch for the same reason', async (...all) => {
    const [, branch, kind, source] = all;
    const { before, after, rounds } = await smaller(source, of(kind));
    expect(rounds).toBeLessThanOrEqual(12);
    const at = after.findIndex(({ id }) => id === branch);
    const [first, found] = [before[at]?.first, after[at]?.first];
    if (!first || !found) throw new RangeError(`${branch} does not fail`);
    expect(reasonOf(found.verdict.says)).toBe(reasonOf(first.verdict.says));
    expect(caseBranch(found.case, found.case.group)).toBe(branch);
    // It really fails: with the program itself, and not as it was remembered.
    const again = reportOf([found.case], run(source, [found.case]));
    expect(again.branches[0]).toMatchObject({ id: branch, passed: 0 });
    // Whole numbers of one digit suffice for all of these.
    const { shape, ray } = found.case;
    const numbers = [...Object.values(shape), ray.origin, ray.direction].flat();
    for (const x of numbers) if (typeof x === 'number') expect(Math.abs(x * 2) % 1).toBe(0);
    expect(JSON.stringify([shape, ray]).length).toBeLessThanOrEqual(
      textOf(before[at] as never).length,
    );
  });

  test('is the same each time', async () => {
    const [, , , source = ''] = MISTAKES[1] ?? [];
    const texts = async (): Promise<string[]> =>
      (await smaller(source, of('cone'))).after.map(textOf);
    expect(await texts()).toEqual(await texts());
  });

  test('a right program is not started again, and one that ends early keeps its case', async () => {
    const right = await smaller(
      curved({}),
      of('cylinder').filter(({ group }) => group !== 'hard'),
    );
    expect(right.after.filter(({ id, first }) => first && id !== 'invalid')).toEqual([]);
    expect(right.rounds).toBe(0);
    const [, , , source = ''] = MISTAKES[0] ?? [];
    const { branches } = reportOf(of('cylinder'), run(source, of('cylinder')));
    expect(await shrunk(branches, async () => [])).toEqual(branches);
  });
});

test('every case is in one branch, and the ordinary ones come first', () => {
  const report = reportOf(CASES, []);
  expect(report.branches.reduce((sum, { total }) => sum + total, 0)).toBe(CASES.length);
  expect(report.branches.map(({ id }) => id).slice(0, 2)).toEqual(['two', 'meets']);
});

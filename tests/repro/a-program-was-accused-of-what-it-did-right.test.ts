import { expect, test } from 'vitest';
import { casesFor } from '../../src/check/program/cases.ts';
import { findings } from '../../src/check/program/suspects.ts';
import { curved, run } from '../unit/check/students.ts';

/*
 * Only the cases that an edit changes were counted for it. A program that loses nearly every hit
 * was told that it had D > 0 in place of D ≥ 0, since it lost the tangents, too; and one with a
 * second flaw, or with branches of its own, was told nothing.
 */

const named = (kind: 'cylinder' | 'cone', source: string): string[] => {
  const cases = casesFor([kind], 41);
  return findings(cases, run(source, cases)).map(({ flaw }) => flaw.id);
};

const twice = { tangent: '' };
const precedence = { t1: '(-b - s) / 2 * a', t2: '(-b + s) / 2 * a' };

test.each([
  ['cylinder', 'D = −(B*B) − 4AC', curved({ disc: '-(b * b) - 4 * a * c' }), ['minus-b2']],
  [
    'cylinder',
    'the same without a branch for D = 0',
    curved({ disc: '-(b * b) - 4 * a * c', ...twice }),
    ['minus-b2'],
  ],
  [
    'cone',
    'second nappe dropped, but not at A = 0 and D = 0',
    curved({ pair: '[Math.min(t1, t2), Math.max(t1, t2)].filter((t) => ey + t * dy >= cy)' }),
    ['one-nappe'],
  ],
  ['cone', 'roots unsorted where A < 0', curved({ pair: '[t1, t2]' }), ['unsorted']],
  [
    'cylinder',
    '/2*A with D <= 0',
    curved({ ...precedence, tangent: '', miss: 'if (disc <= 0) return out([]);' }),
    ['half-times-a', 'strict'],
  ],
] as const)('%s: %s', (kind, _, source, ids) => expect(named(kind, source)).toEqual(ids));

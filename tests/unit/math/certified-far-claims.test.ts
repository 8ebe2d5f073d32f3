import { describe, expect, test } from 'vitest';
import {
  any,
  asymptotic,
  central,
  closedForm,
  far,
  ofA,
  ofB,
  ofClosed,
  ofD,
  ofF,
  ofResidual,
  recentred,
  rootByRoot,
  shareOfD,
  shareOfRecentredRoots,
  worst,
} from './far-stages.ts';
import { KINDS, type Kind } from './in-a-row.ts';

/** The worst share, where the constant is multiplied by `by`. */
type Worst = (kind: Kind, by: number) => number;

const CHARGES: readonly [string, number, Worst][] = [
  ['b', 128, (kind, by) => worst(recentred, kind, far, (a) => ofB(a, by), 211)],
  ['f', 512, (kind, by) => worst(recentred, kind, far, (a) => ofF(a, by), 211)],
  ['A', 8, (kind, by) => worst(recentred, kind, any, (a) => ofA(a, by), 211)],
  ['A f in D', 4, (kind, by) => worst(recentred, kind, any, (a) => ofD(a, by), 211)],
  ['the closed form', 2, (kind, by) => worst(closedForm, kind, any, (a) => ofClosed(a, by), 211)],
  [
    'f of root by root',
    128,
    (kind, by) => worst(rootByRoot, kind, any, (a) => ofResidual(a, by), 211),
  ],
];

describe.each(KINDS)('%s (seed 211)', (kind) => {
  test.each(CHARGES)(
    '%s: what is charged covers all roundings, and one part in %i of it would not',
    (_, part, share) => {
      expect(share(kind, 1)).toBeLessThan(1);
      expect(share(kind, 1 / part)).toBeGreaterThan(1);
    },
  );

  test('f of a ray through the centre, where its leading parts are 0', () => {
    const share = worst(recentred, kind, central, (a) => ofF(a, 1), 223);
    expect(share).toBeLessThan(1);
    expect(share).toBeGreaterThan(1 / 512);
  });

  test('D near an asymptote, where t is of no use', () => {
    expect(worst(recentred, kind, asymptotic, shareOfD, 219)).toBeLessThan(1);
  });

  test('D and the roots are known as well as their bounds say', () => {
    const found = [
      worst(recentred, kind, any, shareOfD, 212),
      worst(rootByRoot, kind, any, shareOfD, 213),
      worst(recentred, kind, any, shareOfRecentredRoots, 214),
    ];
    for (const share of found) {
      expect(share).toBeLessThan(1);
      expect(share).toBeGreaterThan(1 / 12);
    }
  });
});

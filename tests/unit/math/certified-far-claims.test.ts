import { describe, expect, test } from 'vitest';
import {
  any,
  asymptotic,
  type Charge,
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
  type Stage,
  type Start,
  shareOfD,
  shareOfRecentredRoots,
  worst,
} from './far-stages.ts';
import { KINDS } from './in-a-row.ts';

const CHARGES: readonly [string, number, Stage, Start, Charge][] = [
  ['b', 128, recentred, far, ofB],
  ['f', 512, recentred, far, ofF],
  ['A', 8, recentred, any, ofA],
  ['A f in D', 4, recentred, any, ofD],
  ['the closed form', 2, closedForm, any, ofClosed],
  ['f of root by root', 128, rootByRoot, any, ofResidual],
];

describe.each(KINDS)('%s (seed 211)', (kind) => {
  test.each(CHARGES)(
    '%s: what is charged covers all roundings, and one part in %i of it would not',
    (_, part, stage, start, charge) => {
      const whole = worst(stage, kind, start, (a) => charge(a, 1), 211);
      expect(whole).toBeLessThan(1);
      expect(worst(stage, kind, start, (a) => charge(a, 1 / part), 211)).toBeGreaterThan(1);
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

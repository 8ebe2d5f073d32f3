import { ofCurved } from '../../src/check/misconceptions/define.ts';
import { isScalar, rewrite } from '../../src/check/rewrite.ts';

/** A misconception that is not Graze's own, as a newcomer would add it. */
export const aForgottenInD = ofCurved(
  {
    id: 'b2-4c',
    says: 'B² − 4C in place of B² − 4AC',
    line: 'D',
    remedy: 'In the discriminant C stands with A: only where A = 1 it seems to stand alone.',
  },
  ({ D }) => ({
    D: rewrite(D, (e) =>
      e.op === 'product' && e.factors.some((factor) => isScalar(factor, 'A'))
        ? { ...e, factors: e.factors.filter((factor) => !isScalar(factor, 'A')) }
        : null,
    ),
  }),
);

import type { Dyadic, Sign } from '../../../../src/math/exact/dyadic.ts';
import * as dy from '../../../../src/math/exact/dyadic.ts';
import type { Surd } from '../../../../src/math/exact/surd.ts';
import { ratio, toNumber } from '../../../../src/math/exact/surd.ts';

type QuadraticClass = 'two' | 'tangent' | 'one' | 'none' | 'contained';

export interface ExactSolution {
  readonly class: QuadraticClass;
  readonly degree: 0 | 1 | 2;
  readonly discriminantSign: Sign;
  readonly discriminant: Dyadic;
  /** Ascending. 'two' has two, 'tangent' and 'one' one, the others none. */
  readonly roots: readonly Surd[];
}

/** A t² + B t + C = 0 over the reals, as in the course: D = B² − 4AC, t = (−B ± √D) / (2A). */
export function solveExact(A: Dyadic, B: Dyadic, C: Dyadic): ExactSolution {
  if (A.m === 0n) return solveLinear(B, C);
  const D = dy.sub(dy.sqr(B), dy.shift(dy.mul(A, C), 2));
  const discriminantSign = dy.sign(D);
  const common = { degree: 2, discriminantSign, discriminant: D } as const;
  if (discriminantSign < 0) return { class: 'none', ...common, roots: [] };
  const u = dy.neg(B);
  const w = dy.shift(A, 1);
  if (discriminantSign === 0) return { class: 'tangent', ...common, roots: [ratio(u, w)] };
  // A < 0 turns the two around.
  const first = A.m > 0n ? MINUS_ONE : dy.ONE;
  const second = A.m > 0n ? dy.ONE : MINUS_ONE;
  return {
    class: 'two',
    ...common,
    roots: [
      { u, v: first, w, D },
      { u, v: second, w, D },
    ],
  };
}

const MINUS_ONE = dy.neg(dy.ONE);

/** A = 0: D is B², and its sign still tells the one root from the rest. */
function solveLinear(B: Dyadic, C: Dyadic): ExactSolution {
  if (B.m !== 0n) {
    const common = { degree: 1, discriminantSign: 1, discriminant: dy.sqr(B) } as const;
    return { class: 'one', ...common, roots: [ratio(dy.neg(C), B)] };
  }
  const common = { degree: 0, discriminantSign: 0, discriminant: dy.ZERO } as const;
  return { class: C.m === 0n ? 'contained' : 'none', ...common, roots: [] };
}

/**
 * The roots as doubles, each rounded once, ascending. 'two' keeps both, even when they round to
 * the same double.
 */
export const roundedRoots = (solution: ExactSolution): number[] => solution.roots.map(toNumber);

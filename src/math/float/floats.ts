/**
 * The operations of one floating-point format, on numbers or on what stands for them: a formula
 * that is written over these is both run, on `doubles`, and recorded, for kernels to be made of it.
 * M is what a comparison gives.
 */
export interface Floats<F, M> {
  of(x: number): F;
  add(a: F, b: F): F;
  sub(a: F, b: F): F;
  mul(a: F, b: F): F;
  div(a: F, b: F): F;
  neg(a: F): F;
  abs(a: F): F;
  sqrt(a: F): F;
  min(a: F, b: F): F;
  max(a: F, b: F): F;
  /** a < b, and a ≤ b; false where one of them is NaN. */
  less(a: F, b: F): M;
  atMost(a: F, b: F): M;
  and(a: M, b: M): M;
  or(a: M, b: M): M;
  /** Both values are worked out. */
  select(where: M, then: F, otherwise: F): F;
  /** `a` where the condition holds, else 0. */
  keep(where: M, a: F): F;
  /**
   * Whether a case is at hand that hardly ever is. A recording leaves such a ray to the trees, and
   * goes on as if it were not.
   */
  rarely(m: M): boolean;
}

export const doubles: Floats<number, boolean> = {
  of: (x) => x,
  add: (a, b) => a + b,
  sub: (a, b) => a - b,
  mul: (a, b) => a * b,
  div: (a, b) => a / b,
  neg: (a) => -a,
  abs: Math.abs,
  sqrt: Math.sqrt,
  min: (a, b) => Math.min(a, b),
  max: (a, b) => Math.max(a, b),
  less: (a, b) => a < b,
  atMost: (a, b) => a <= b,
  and: (a, b) => a && b,
  or: (a, b) => a || b,
  select: (where, then, otherwise) => (where ? then : otherwise),
  keep: (where, a) => (where ? a : 0),
  rarely: (m) => m,
};

/**
 * The errors of eft.ts, over any such format of 53 bits; there are their proofs and ranges.
 */
export function errorsOver<F, M>(f: Floats<F, M>) {
  const splitter = f.of(134217729);
  const high = (a: F): F => {
    const big = f.mul(splitter, a);
    return f.sub(big, f.sub(big, a));
  };
  return {
    sumError(a: F, b: F, s: F): F {
      const part = f.sub(s, a);
      return f.add(f.sub(a, f.sub(s, part)), f.sub(b, part));
    },
    fastSumError: (a: F, b: F, s: F): F => f.sub(b, f.sub(s, a)),
    productError(a: F, b: F, p: F): F {
      const [aHigh, bHigh] = [high(a), high(b)];
      const [aLow, bLow] = [f.sub(a, aHigh), f.sub(b, bHigh)];
      const rest = f.sub(f.sub(p, f.mul(aHigh, bHigh)), f.mul(aLow, bHigh));
      return f.sub(f.mul(aLow, bLow), f.sub(rest, f.mul(aHigh, bLow)));
    },
    squareError(a: F, p: F): F {
      const aHigh = high(a);
      const low = f.sub(a, aHigh);
      const rest = f.sub(p, f.mul(aHigh, aHigh));
      return f.sub(f.mul(low, low), f.sub(rest, f.mul(f.of(2), f.mul(aHigh, low))));
    },
  };
}

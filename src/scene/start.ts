import type { Answers } from '../math/batch.ts';

/**
 * The rule of math/leave.ts for the answers of `both`: the root nearest to 0 is where the ray
 * starts, and goes. Of two equally near ones the positive one goes. The methods' rounded roots
 * decide; what is left is in t0 or t1, NaN in the other.
 */
export function dropStart({ t0, t1 }: Answers, count: number): void {
  for (let i = 0; i < count; i++) {
    const near = t0[i] as number;
    const far = t1[i] as number;
    // One root only, or none: far is NaN.
    if (Math.abs(far) <= Math.abs(near)) t1[i] = Number.NaN;
    else t0[i] = Number.NaN;
  }
}

import type { Answers } from '../math/batch.ts';

/**
 * Replaces by NaN the root at which a ray starts, among the answers of `both`: the root nearest to
 * 0, of two equally near ones the positive one, by the method's rounded roots. The same rule as in
 * math/leaving-ray.ts.
 */
export function dropStart({ t0, t1 }: Answers, count: number): void {
  for (let i = 0; i < count; i++) {
    const near = t0[i] as number;
    const far = t1[i] as number;
    // With one root or none, `far` is NaN.
    if (Math.abs(far) <= Math.abs(near)) t1[i] = Number.NaN;
    else t0[i] = Number.NaN;
  }
}

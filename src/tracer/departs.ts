import type { Rays } from '../math/batch/batch.ts';
import type { Quadric } from '../math/batch/quadric.ts';

/*
 * A ray that leaves a curved surface on its convex side does not come back, and mostly that can be seen without a root. With half coefficients
 * f(t) = A t² + 2b t + C and E (nearly) on the surface, C is nearly 0. Where 4|A||C| < b²:
 *
 *   D/4 = b² − AC > ¾ b², so the roots are s = C / (−b ∓ √(D/4)), |s| < |C| / 1.86|b|, and l = (−b ∓ √(D/4)) / A, |l| > 1.86|b| / |A|;
 *   |s / l| < |AC| / 3.4b² < 0.08: s is the root nearest to 0, which the start rule drops, and l has the sign of −b / A.
 *
 * So where b and A have the same sign nothing is left ahead. In doubles, u = 2^-53: p = E − C is off by u; b's products by 4u, two sums: |δb| < 10u·bm;
 * likewise |δA| < 10u·Am and |δC| < 12u·Cm, with the sums of the terms' sizes. ERROR has room for evaluating these, SMALLEST for underflow. It is the answer
 * of exact arithmetic, so it may stand in for the rungs that give that, and only for those.
 */
const ERROR = 16 * 2 ** -53;
const SMALLEST = 2 ** -900;

/** The rungs whose class and signs are those of exact arithmetic. */
export const PROVEN: ReadonlySet<string> = new Set(['certified', 'exact']);

/** Whether ray i, which starts on the surface, certainly does not meet it again at t > 0. False: it may. */
export function departs(q: Quadric, a: number, rays: Rays, i: number): boolean {
  const x = rays.dx[i] as number;
  const y = q.hasY ? (rays.dy[i] as number) : 0;
  const z = rays.dz[i] as number;
  const px = (rays.Ex[i] as number) - q.Cx;
  const py = q.hasY ? (rays.Ey[i] as number) - q.Cy : 0;
  const pz = (rays.Ez[i] as number) - q.Cz;
  const rho = q.r * q.r;
  const ay = a * y;
  const apy = a * py;
  const b = x * px + z * pz - ay * py;
  const A = x * x + z * z - ay * y;
  const C = px * px + pz * pz - apy * py - rho;
  const bm = Math.abs(x * px) + Math.abs(z * pz) + Math.abs(ay * py);
  const Am = x * x + z * z + Math.abs(ay * y);
  const Cm = px * px + pz * pz + Math.abs(apy * py) + rho;
  const least = Math.abs(b) - ERROR * bm;
  return (
    b * A > 0 &&
    least > 0 &&
    Math.abs(A) > ERROR * Am &&
    4 * (Math.abs(A) + ERROR * Am) * (Math.abs(C) + ERROR * Cm) + SMALLEST < least * least
  );
}

import type { Quadric, Rays } from '../math/batch.ts';

/*
 * A test without roots for rays that leave a curved surface on its convex side and do not meet it
 * again. With half coefficients f(t) = A t² + 2b t + C the sum of the roots is −2b/A. If b and A
 * have the same sign, the sum is negative: then both roots are negative, or the positive one is the
 * nearer to 0, which the start rule drops. So no root is left at t > 0, whatever C is.
 *
 * In doubles, u = 2^-53: p = E − C is off by u, and so is a. b's products 2u, that with a 4u, and
 * two sums: |δb| ≤ 5u·bm, where bm is the sum of the terms' sizes; likewise |δA| ≤ 4u·Am. ERROR
 * includes the errors of evaluating these, SMALLEST those of products that underflow, 2^-1075 each;
 * a·dy must not underflow, as it is multiplied once more. The answer is that of exact arithmetic,
 * so the test is used only for methods that give the exact class.
 */
export const ERROR = 6 * 2 ** -53;
export const SMALLEST = 2 ** -1072;
const LEAST_NORMAL = 2 ** -1022;

/** Whether ray i, which starts on the surface, provably does not meet it again at t > 0. */
export function departs(q: Quadric, a: number, rays: Rays, i: number): boolean {
  const x = rays.dx[i] as number;
  const y = q.hasY ? (rays.dy[i] as number) : 0;
  const z = rays.dz[i] as number;
  const px = (rays.Ex[i] as number) - q.Cx;
  const py = q.hasY ? (rays.Ey[i] as number) - q.Cy : 0;
  const pz = (rays.Ez[i] as number) - q.Cz;
  const ay = a * y;
  const b = x * px + z * pz - ay * py;
  const A = x * x + z * z - ay * y;
  const bm = Math.abs(x * px) + Math.abs(z * pz) + Math.abs(ay * py);
  const Am = x * x + z * z + Math.abs(ay * y);
  const known = Math.abs(b) > ERROR * bm + SMALLEST && Math.abs(A) > ERROR * Am + SMALLEST;
  const whole = Math.abs(ay) >= LEAST_NORMAL || a === 0 || y === 0;
  return known && whole && b > 0 === A > 0;
}

import type { Planar } from '../../batch/planar.ts';
import type { Quadric } from '../../batch/quadric.ts';
import { productError, squareError, sumError } from '../../float/eft.ts';
import type { Hit } from '../../intersection.ts';
import type { Ray } from '../../ray.ts';
import type { Vec3 } from '../../vec3.ts';

/*
 * Points and normals from the exact root t*, of which a faithful t is known: δ = t* − t, |δ| ≤ 2u|t|, is one Newton step on a residual in twice
 * the digits. u = 2^-53; i runs over x, y, z.
 *
 *   g = E − C + t d: the sums and the product are split without loss (eft.ts), g = s + low, low = three rests added up. With
 *   Li = |pi| + |t di| and Wi = u Li:  |lowi| ≤ 2Wi,  |δgi| ≤ 4u Wi.
 *
 * Curved, F = gx² + gz² − a gy² − ρ with weights ai = 1, |a|, 1; a and ρ are exact as two doubles each. In units of u ai Wi(|si| + Wi):
 *   the lower half of gi², 2s·low + low² + the square's own rest: its roundings 20, gi being off 16; times a: 20 more;
 *   adding up seven lower halves, together ≤ 8 Wi(|si| + Wi) + 4uρ: 48 (and 24u²ρ).              |δF| ≤ u (128 Σ ai Wi(|si| + Wi) + 32uρ + |F|)
 *   h = F'/2 = gx dx + gz dz − a gy dy, from s alone:                                           |δh| ≤ 8 Σ ai|di|Wi
 *   F + 2hδ + Aδ² = 0, so δ = −F/(2h + Aδ), where |Aδ| ≤ 2 Σ ai|di|Wi:  2h is off by η = 10 Σ ai|di|Wi / |h| of itself.
 * Flat, F = N·g, h = N·d: |δF| ≤ u (64 Σ|Ni|Wi + |F|), |δh| ≤ 4u Σ|Ni di|, δ = −F/h.
 *
 * Either way δ is off by Δ ≤ 2|δF|/|F'| + 2η·2u|t| + 5u|δ| for η ≤ 1/4. Then Ei + t di + δ di is off by Δ|di| + SHORT(|Ei + t di| + |t di|) before it
 * is rounded: faithful, if that is below u/4 of it. gi + δ di is off by Δ|di| + 32u Wi.
 *
 * A t below the normal doubles is off by 2^-1074 more, and so may δ be: that is TINY, and counts where d is huge.
 * Underflow: with |p|₁, |t||d|₁, r, √|a| < WIDE and a lost product ≤ 2^-1073, what is lost in F and h is below SMALLEST.
 */
const U = 2 ** -53;
const SHORT = 32 * 2 ** -106;
const FAITHFUL = 2 ** -55;
/** Of the normal’s longest component: its direction is promised within 2^-50. */
const STRAIGHT = 2 ** -52;
const WIDE = 2 ** 120;
const SMALLEST = 2 ** -600;
const LOST = 2 ** -1070;
const TINY = 2 ** -1072;

/** The hit at the faithful root t, or null where a component stays open, or all of the normal's are zero. In one piece: a call would box its doubles. */
export function placeOnQuadric(
  q: Quadric,
  { origin: E, direction: d }: Ray,
  t: number,
): Hit | null {
  const ex = E[0];
  const ey = E[1];
  const ez = E[2];
  const dx = d[0];
  const dy = d[1];
  const dz = d[2];
  // A cylinder does not look at y: from E's own height nothing is subtracted.
  const cy = q.hasY ? q.Cy : ey;
  const px = ex - q.Cx;
  const py = ey - cy;
  const pz = ez - q.Cz;
  const mx = t * dx;
  const my = t * dy;
  const mz = t * dz;
  const restX = productError(t, dx, mx);
  const restY = productError(t, dy, my);
  const restZ = productError(t, dz, mz);
  const x = px + mx;
  const y = py + my;
  const z = pz + mz;
  const lowX = sumError(px, mx, x) + restX + sumError(ex, -q.Cx, px);
  const lowY = sumError(py, my, y) + restY + sumError(ey, -cy, py);
  const lowZ = sumError(pz, mz, z) + restZ + sumError(ez, -q.Cz, pz);
  const wx = U * (Math.abs(px) + Math.abs(mx));
  const wy = U * (Math.abs(py) + Math.abs(my));
  const wz = U * (Math.abs(pz) + Math.abs(mz));

  const a = q.squared ? q.flare * q.flare : q.flare;
  const aLow = q.squared ? squareError(q.flare, a) : 0;
  const size = Math.abs(a);
  const rho = q.r * q.r;
  const xx = x * x;
  const yy = y * y;
  const zz = z * z;
  const ayy = a * yy;
  const round = xx + zz;
  const less = round - ayy;
  const high = less - rho;
  const F =
    high +
    (squareError(x, xx) +
      lowX * (2 * x + lowX) +
      (squareError(z, zz) + lowZ * (2 * z + lowZ)) -
      (productError(a, yy, ayy) + (a * (squareError(y, yy) + lowY * (2 * y + lowY)) + aLow * yy)) -
      squareError(q.r, rho) +
      (sumError(xx, zz, round) + sumError(round, -ayy, less) + sumError(less, -rho, high)));
  const offF =
    128 *
      U *
      (wx * (Math.abs(x) + wx) + wz * (Math.abs(z) + wz) + size * (wy * (Math.abs(y) + wy))) +
    U * (32 * U * rho + Math.abs(F)) +
    SMALLEST;
  const inverse = 0.5 / (x * dx + z * dz - a * (y * dy));
  const steep = Math.abs(inverse);
  const eta =
    steep *
    (20 * (wx * Math.abs(dx) + wz * Math.abs(dz) + size * (wy * Math.abs(dy))) +
      TINY * (dx * dx + dz * dz + size * (dy * dy)) +
      SMALLEST);
  const delta = -F * inverse;
  const off = 2 * offF * steep + U * (4 * eta * Math.abs(t) + 5 * Math.abs(delta)) + TINY;
  const sure = eta <= 0.25 && wx + wy + wz < U * WIDE && size < WIDE * WIDE && q.r < WIDE;

  if (!sure) return null;

  const stepX = delta * dx;
  const stepY = delta * dy;
  const stepZ = delta * dz;
  const X = ex + mx;
  const Y = ey + my;
  const Z = ez + mz;
  const pointX = X + (sumError(ex, mx, X) + restX + stepX);
  const pointY = Y + (sumError(ey, my, Y) + restY + stepY);
  const pointZ = Z + (sumError(ez, mz, Z) + restZ + stepZ);
  const offX = dx === 0 ? 0 : off * Math.abs(dx) + SHORT * (Math.abs(X) + Math.abs(mx)) + LOST;
  const offY = dy === 0 ? 0 : off * Math.abs(dy) + SHORT * (Math.abs(Y) + Math.abs(my)) + LOST;
  const offZ = dz === 0 ? 0 : off * Math.abs(dz) + SHORT * (Math.abs(Z) + Math.abs(mz)) + LOST;
  const faithful =
    offX <= FAITHFUL * Math.abs(pointX) &&
    offY <= FAITHFUL * Math.abs(pointY) &&
    offZ <= FAITHFUL * Math.abs(pointZ);
  if (!faithful) return null;

  const alongX = x + (lowX + stepX);
  const restN = lowY + stepY;
  const alongY = y + restN;
  const alongZ = z + (lowZ + stepZ);
  const down = a * alongY;
  const normalY = q.hasY
    ? -(down + (productError(a, alongY, down) + a * (restN - (alongY - y)) + aLow * alongY))
    : 0;
  const long = Math.max(Math.abs(alongX), Math.abs(normalY), Math.abs(alongZ));
  const offN = offX + offZ + size * offY + 32 * U * (wx + wz + size * wy) + SMALLEST;
  if (!(offN <= STRAIGHT * long)) return null;
  return {
    t,
    point: [pointX + 0, pointY + 0, pointZ + 0],
    normal: [alongX + 0, normalY + 0, alongZ + 0],
    singular: false,
  };
}

/** As `placeOnQuadric`; the normal is N itself. */
export function placeInPlane(
  { N, P }: Planar,
  { origin: E, direction: d }: Ray,
  t: number,
): Hit | null {
  let F = 0;
  let low = 0;
  let rate = 0;
  let sharp = 0;
  let steep = 0;
  let reach = 0;
  let size = 0;
  for (let i = 0; i < 3; i++) {
    const n = N[i] as number;
    const e = E[i] as number;
    const x = d[i] as number;
    const p = e - (P[i] as number);
    const m = t * x;
    const s = p + m;
    const w = U * (Math.abs(p) + Math.abs(m));
    const product = n * s;
    const sum = F + product;
    low +=
      productError(n, s, product) +
      n * (sumError(p, m, s) + productError(t, x, m) + sumError(e, -(P[i] as number), p)) +
      sumError(F, product, sum);
    F = sum;
    rate += n * x;
    sharp += Math.abs(n) * w;
    steep += Math.abs(n * x);
    reach += w;
    size += Math.abs(n);
  }
  const whole = F + low;
  const inverse = 1 / Math.abs(rate);
  const eta = (4 * U * steep + SMALLEST) * inverse;
  if (!(eta <= 0.25 && reach < U * WIDE && size < WIDE)) return null;
  const delta = -whole / rate;
  const offF = U * (64 * sharp + Math.abs(whole)) + SMALLEST;
  const off = 2 * offF * inverse + U * (4 * eta * Math.abs(t) + 5 * Math.abs(delta)) + TINY;
  const point = [0, 0, 0] satisfies Vec3 as [number, number, number];
  for (let i = 0; i < 3; i++) {
    const e = E[i] as number;
    const x = d[i] as number;
    const m = t * x;
    const s = e + m;
    const lo = sumError(e, m, s) + productError(t, x, m) + delta * x;
    const offX = x === 0 ? 0 : off * Math.abs(x) + SHORT * (Math.abs(s) + Math.abs(m)) + LOST;
    const at = s + lo;
    if (!(offX <= FAITHFUL * Math.abs(at))) return null;
    point[i] = at + 0;
  }
  return { t, point, normal: [N[0], N[1], N[2]], singular: false };
}

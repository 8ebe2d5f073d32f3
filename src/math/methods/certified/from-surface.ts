import type { Answers, Rays } from '../../batch/batch.ts';
import type { Quadric } from '../../batch/quadric.ts';
import { productError, SPLITTER, squareError, sumError } from '../../float/eft.ts';
import {
  AT_LATTICE,
  type CertifiedQuadric,
  cut,
  FAITHFUL_ONCE,
  type Lattice,
  ROUND,
} from './numbers.ts';

/*
 * Rays that start on a surface, or as near to it as rounding or an offset leaves them: C is far
 * below its terms, so 4AC is below B² and no square root is needed. With ε = AC/b² ≤ 2^-11,
 *
 *   √(b² − AC) = |b|(1 − η),  η = ε/2 + ε²/8 + ε³/16 + 5ε⁴/128 + …,  q = −b − b(1 − η),
 *   far = q/A,  near = C/q.
 *
 * What cancels is C, and so p = E − C, and K = k·py, are cut into four parts. Lengths are counted
 * in the lattice's units (numbers.ts), of which a size has 2^17 to 2^18; y is stretched as there,
 * so that k is from 1/2 to 1. u = 2^-53.
 *
 *   part                  grid    size            reason
 *   E, C: e0, c0          1                       cut; e − e0 etc. are exact
 *         e1, c1          2^-25   ≤ 1/2           cut
 *         e2, c2          2^-50   ≤ 2^-26         cut
 *         e3, c3                  ≤ 2^-51         what is left
 *   p0 = e0 − c0          1       < 2^23          P < 2^23 is tested; y, before k, < 2^24
 *   p1, p2                as e    ≤ 1, 2^-25      exact
 *   p3                            ≤ 2^-50         off by u of it
 *   k = k1 + k2 + k3 + k4 2^-26, 2^-52, 2^-77     cut; k4 is off by 2^-130
 *   k1p0                  2^-26   < 2^23          26 by 24 bits; K0 cut from it
 *   + k1p1 + k2p0         2^-52   ≤ 1.63          1/2 + 1 + 2^-3; K1 cut from it
 *   + k1p2 + k2p1 + k3p0  2^-77   < 2^-24         2^-26, 2^-25, 2^-27, 2^-29; K2 cut from it
 *   K3                            ≤ 2^-49         what is left 2^-51, k1p3 2^-50,
 *                                                 k2(p2 + p3) 2^-52, k3(p1 + p2) 2^-53,
 *                                                 k4(p0 + p1) 2^-54; off by 3.6u of 2^-49,
 *                                                 and by k3p3 and k4p2: 5u·2^-49
 *   C: Σp0² − ρ0          1       ≤ 2^48          exact, as are the next three
 *      2Σp0p1 − ρ1        2^-24   ≤ 2^25.4
 *      Σp1² + 2p0p2 − ρ2  2^-50   ≤ 2^2.8         1 + 1 + 2.7, and 2^24·2^-24 of p0p2
 *      2Σp1p2             2^-74   ≤ 2^-21.5
 *      2Σp·p3                     ≤ P·2^-48       below
 *      Σp2² − ρ3          2^-104  ≤ 2^-47.3       exact
 *
 * with P = Σ|p|. The first four are added up with what each sum loses: the upper one's grid is the
 * coarser (Dekker). All that is rounded is in the lower half Cl, |Cl| ≤ 2u|C| + 2^-48 P + 2^-47.3:
 *
 *   |δC| in u·2^-50 P     bound           reason, for P ≥ 32
 *   products p·p3         28              2(5 + 2)·2 of |p| along y, 6 across
 *   their sums            8
 *   + squares             4.5
 *   + what the sums lost  4.5
 *   p3²                   2               left out: 2^-97.4
 *   near's remainder      9               Cl is added to it
 *   C in all              56              |δC| ≤ OFF_C·P
 *
 * d is cut as in grids.ts, S = |dx| + |dz| + |k1·dy| and h = 2^-26:
 *
 *   quantity              size            error, and its reason
 *   A                     S²              37uh S², as in grids.ts
 *   b: Σ xh·p0            ≤ 2^23 S        exact: (2^26 + 4) by 2^23
 *      Σ xh·(p1 + p2)     ≤ 1.63 S        products and sums 8u; p3 left out: 2^-49
 *      Σ xl·p             ≤ 3h·2^23 S     xl 8uh, p and the product 2u·3h each: 2u
 *      in all                             26u S
 *   η                                     next term 7ε⁵/256 < 2^-60, half of it counts; ε off by
 *                                         20u of itself, if A, b and C pass the tests: 2^-61.7
 *   q = −b − b(1 − η)                     that of b, η's, remainders 2^-75: OWN
 *   far, near                             one remainder each, of 26 by 26 bits, exact; rounded
 *                                         once: faithful by FAITHFUL_ONCE
 *
 * OFF_A and OFF_B have some room. Where they pass, |A| and |b| are so large that what their sums
 * lose is found exactly, and with |b| ≤ S·P, P is 32 at least. The tests have the sums.
 */
const SPLIT_BITS = 25;
const MID = 2 ** -SPLIT_BITS;
const LOW = 2 ** (-2 * SPLIT_BITS);
const K_GRIDS = [2 ** -26, 2 ** -52, 2 ** -77] as const;
/** Of P, in units. */
export const LARGEST_P = 2 ** 23;
/** Of S: products of five stay far within the doubles. */
const LARGEST_S = 2 ** 60;
/** d is cut to 26 bits of S. */
const CUT_D = 2 ** 27;

/** Largest |AC|/b² that this stage takes. */
export const CLOSE = 2 ** -11;
/** Of S². */
export const OFF_A = 10 * 2 ** -77;
/** Of S and P, times a unit. */
export const OFF_B = 28 * 2 ** -53;
/** Bound on |δC| in units: of P. */
export const OFF_C = 2 ** -97;
/** Bound on q's own relative error. */
export const OWN = 2 ** -60;

/** What the loops take before they begin. */
export const AT_SURFACE_BOUND = {
  splitter: 0,
  grid: 1,
  close: 2,
  offOfA: 3,
  own: 4,
  faithful: 5,
  largestS: 6,
  eighth: 7,
  sixteenth: 8,
  fifth: 9,
} as const;
/** In the order of AT_SURFACE_BOUND. */
export const SURFACE_BOUNDS: readonly number[] = [
  SPLITTER,
  CUT_D,
  CLOSE,
  OFF_A,
  OWN,
  FAITHFUL_ONCE,
  LARGEST_S,
  1 / 8,
  1 / 16,
  5 / 128,
];

/**
 * A shape's numbers for this stage: `cut…` cut E and K to their grids; C, ρ and k in the parts told
 * above; kRest is k − k1; `largest` is P's limit; `offB` and `offC` have a unit in them.
 */
export type SurfaceNumbers = Float64Array;

/** Indices into `SurfaceNumbers`. */
export const AT_SURFACE = {
  cut0: 0,
  cut1: 1,
  cut2: 2,
  cutY0: 3,
  cutY1: 4,
  cutY2: 5,
  x0: 6,
  x1: 7,
  x2: 8,
  x3: 9,
  y0: 10,
  y1: 11,
  y2: 12,
  y3: 13,
  z0: 14,
  z1: 15,
  z2: 16,
  z3: 17,
  rho0: 18,
  rho1: 19,
  rho2: 20,
  rho3: 21,
  k1: 22,
  k2: 23,
  k3: 24,
  k4: 25,
  kRest: 26,
  sign: 27,
  largest: 28,
  offB: 29,
  offC: 30,
} as const;
/** Length of `SurfaceNumbers`. */
export const SURFACE_COUNT = 31;

/** Made when they are first asked for: few rays need them. Only of a shape that has a lattice. */
export function surfaceNumbers(q: Quadric, c: CertifiedQuadric): SurfaceNumbers {
  c.surface ??= prepared(q, c.lattice as Lattice);
  return c.surface;
}

function prepared(q: Quadric, lattice: Lattice): SurfaceNumbers {
  const unit = (lattice[AT_LATTICE.cutE] as number) / ROUND;
  const up = lattice[AT_LATTICE.up] as number;
  const parts = (x: number, grid: number): readonly number[] => {
    const first = cut(x, grid);
    const second = cut(x - first, grid * MID);
    const third = cut(x - first - second, grid * LOW);
    return [first, second, third, x - first - second - third];
  };
  return Float64Array.of(
    ...[ROUND * unit, ROUND * unit * MID, ROUND * unit * LOW],
    ...[(ROUND * unit) / up, (ROUND * unit * MID) / up, (ROUND * unit * LOW) / up],
    ...parts(q.Cx, unit),
    ...parts(q.Cy, unit / up),
    ...parts(q.Cz, unit),
    ...squareParts(q.r, unit * unit),
    ...rootParts(q, up),
    q.squared || q.flare > 0 ? 1 : -1,
    ...[LARGEST_P * unit, OFF_B * unit, OFF_C * unit],
  );
}

/** r² on 1, 2^-24 and 2^-50 of `square`, and the rest, which is a double. */
function squareParts(r: number, square: number): readonly number[] {
  const rho = r * r;
  const first = cut(rho, square);
  const second = cut(rho - first, square * 2 * MID);
  const left = rho - first - second;
  const lost = squareError(r, rho);
  const sum = left + lost;
  const third = cut(sum, square * LOW);
  return [first, second, third, left - third + lost];
}

/**
 * √|a| in four parts, and without the first. a − s² is a double, so is what is left of it after a
 * division: three doubles have the root to 2^-158.
 */
function rootParts({ squared, flare }: Quadric, up: number): readonly number[] {
  const size = Math.abs(flare);
  const s = squared ? size : Math.sqrt(size);
  let [t, v] = [0, 0];
  if (!squared && s > 0) {
    const p = s * s;
    const rest = size - p - squareError(s, p);
    t = rest / (2 * s);
    const double = 2 * s * t;
    v = (rest - double - productError(2 * s, t, double) - t * t) / (2 * s);
  }
  const k1 = cut(s, K_GRIDS[0] * up);
  const left = s - k1;
  const k2 = cut(left + t, K_GRIDS[1] * up);
  const hi = left - k2 + t;
  const lo = sumError(left - k2, t, hi);
  const k3 = cut(hi, K_GRIDS[2] * up);
  return [k1, k2, k3, hi - k3 + (lo + v), left + t];
}

/** As RecentredPass, by the numbers above. */
export type SurfacePass = (
  surface: SurfaceNumbers,
  rays: Rays,
  out: Answers,
  places: Int32Array,
  count: number,
) => number;

/** For cylinders, whose formula does not look at y. */
export const surfaceAroundAxis: SurfacePass = (
  surface,
  { Ex, Ez, dx, dz },
  { t0, t1 },
  places,
  count,
) => {
  const cut0 = surface[AT_SURFACE.cut0] as number;
  const cut1 = surface[AT_SURFACE.cut1] as number;
  const cut2 = surface[AT_SURFACE.cut2] as number;
  const x0 = surface[AT_SURFACE.x0] as number;
  const x1 = surface[AT_SURFACE.x1] as number;
  const x2 = surface[AT_SURFACE.x2] as number;
  const x3 = surface[AT_SURFACE.x3] as number;
  const z0 = surface[AT_SURFACE.z0] as number;
  const z1 = surface[AT_SURFACE.z1] as number;
  const z2 = surface[AT_SURFACE.z2] as number;
  const z3 = surface[AT_SURFACE.z3] as number;
  const rho0 = surface[AT_SURFACE.rho0] as number;
  const rho1 = surface[AT_SURFACE.rho1] as number;
  const rho2 = surface[AT_SURFACE.rho2] as number;
  const rho3 = surface[AT_SURFACE.rho3] as number;
  const largest = surface[AT_SURFACE.largest] as number;
  const offOfB = surface[AT_SURFACE.offB] as number;
  const offOfC = surface[AT_SURFACE.offC] as number;
  const splitter = SURFACE_BOUNDS[AT_SURFACE_BOUND.splitter] as number;
  const grid = SURFACE_BOUNDS[AT_SURFACE_BOUND.grid] as number;
  const close = SURFACE_BOUNDS[AT_SURFACE_BOUND.close] as number;
  const offOfA = SURFACE_BOUNDS[AT_SURFACE_BOUND.offOfA] as number;
  const own = SURFACE_BOUNDS[AT_SURFACE_BOUND.own] as number;
  const faithful = SURFACE_BOUNDS[AT_SURFACE_BOUND.faithful] as number;
  const largestS = SURFACE_BOUNDS[AT_SURFACE_BOUND.largestS] as number;
  const eighth = SURFACE_BOUNDS[AT_SURFACE_BOUND.eighth] as number;
  const sixteenth = SURFACE_BOUNDS[AT_SURFACE_BOUND.sixteenth] as number;
  const fifth = SURFACE_BOUNDS[AT_SURFACE_BOUND.fifth] as number;
  let left = 0;
  for (let j = 0; j < count; j++) {
    const i = places[j] as number;
    const x = dx[i] as number;
    const z = dz[i] as number;
    const ex = Ex[i] as number;
    const ez = Ez[i] as number;
    const ex0 = ex + cut0 - cut0;
    const exa = ex - ex0;
    const ex1 = exa + cut1 - cut1;
    const exb = exa - ex1;
    const ex2 = exb + cut2 - cut2;
    const px0 = ex0 - x0;
    const px1 = ex1 - x1;
    const px2 = ex2 - x2;
    const px3 = exb - ex2 - x3;
    const ez0 = ez + cut0 - cut0;
    const eza = ez - ez0;
    const ez1 = eza + cut1 - cut1;
    const ezb = eza - ez1;
    const ez2 = ezb + cut2 - cut2;
    const pz0 = ez0 - z0;
    const pz1 = ez1 - z1;
    const pz2 = ez2 - z2;
    const pz3 = ezb - ez2 - z3;
    const pxl = px1 + px2;
    const pzl = pz1 + pz2;
    const px = px0 + pxl;
    const pz = pz0 + pzl;

    const speed = Math.abs(x) + Math.abs(z);
    const gridD = grid * speed;
    const xh = x + gridD - gridD;
    const xl = x - xh;
    const zh = z + gridD - gridD;
    const zl = z - zh;
    const A0 = xh * xh + zh * zh;
    const A1 = xl * (x + xh) + zl * (z + zh);
    const A = A0 + A1;
    const Al = A1 - (A - A0);
    const b0 = xh * px0 + zh * pz0;
    const b1 = xh * pxl + xl * px + (zh * pzl + zl * pz);
    const b = b0 + b1;
    const bl = b1 - (b - b0);

    const heads = px0 * px0 + pz0 * pz0 - rho0;
    const cross = px0 * px1 + pz0 * pz1;
    const seconds = cross + cross - rho1;
    const third = px0 * px2 + pz0 * pz2;
    const thirds = px1 * px1 + pz1 * pz1 + (third + third) - rho2;
    const fourth = px1 * px2 + pz1 * pz2;
    const fourths = fourth + fourth;
    const fifths = px * px3 + pz * pz3;
    const C1 = heads + seconds;
    const C2 = C1 + thirds;
    const C3 = C2 + fourths;
    const Cl =
      seconds -
      (C1 - heads) +
      (thirds - (C2 - C1) + (fourths - (C3 - C2))) +
      (fifths + fifths + (px2 * px2 + pz2 * pz2 - rho3));
    const C = C3 + Cl;

    const over = 1 / (A * b);
    const overB = over * A;
    const overA = over * b;
    const ratio = A * C * overB;
    const epsilon = ratio * overB;
    const reach = Math.abs(px) + Math.abs(pz);
    const clear =
      Math.abs(epsilon) <= close && speed < largestS && speed * largestS > 1 && reach < largest;
    if (!clear) {
      places[left++] = i;
      continue;
    }
    const eta = epsilon * (0.5 + epsilon * (eighth + epsilon * (sixteenth + epsilon * fifth)));
    const q0 = -2 * b;
    const q1 = b * eta - (bl + bl);
    const q = q0 + q1;
    const ql = q1 - (q - q0);
    const half = 0.5 * eta;
    const overQ = -0.5 * overB * (1 + (half + half * half));
    const far0 = q * overA;
    const bigF = splitter * far0;
    const farH = bigF - (bigF - far0);
    const bigA = splitter * A;
    const Ah = bigA - (bigA - A);
    const far = farH + (q - farH * Ah - farH * (A - Ah + Al) + ql) * overA;
    const near0 = C * overQ;
    const bigN = splitter * near0;
    const nearH = bigN - (bigN - near0);
    const bigQ = splitter * q;
    const qh = bigQ - (bigQ - q);
    const near = nearH + (C3 - nearH * qh - nearH * (q - qh + ql) + Cl) * overQ;

    const share = own + offOfB * speed * Math.abs(overB);
    const sizeOf = Math.abs(near);
    const settled =
      share + offOfA * (speed * speed) * Math.abs(overA) <= faithful &&
      share * sizeOf + offOfC * reach * Math.abs(overQ) <= faithful * sizeOf;
    // 1 or 0, whether near is the lesser root: Math.min branches, and not even the processor knows
    // on which side of the surface a ray begins.
    const side = (0.5 * far) / Math.abs(far);
    const first = 0.5 + side;
    const second = 0.5 - side;
    if (settled) {
      t0[i] = first * near + second * far;
      t1[i] = second * near + first * far;
    } else places[left++] = i;
  }
  return left;
};

/** For shapes with a term in y. */
export const surfaceInSpace: SurfacePass = (
  surface,
  { Ex, Ey, Ez, dx, dy, dz },
  { t0, t1 },
  places,
  count,
) => {
  const cut0 = surface[AT_SURFACE.cut0] as number;
  const cut1 = surface[AT_SURFACE.cut1] as number;
  const cut2 = surface[AT_SURFACE.cut2] as number;
  const cutY0 = surface[AT_SURFACE.cutY0] as number;
  const cutY1 = surface[AT_SURFACE.cutY1] as number;
  const cutY2 = surface[AT_SURFACE.cutY2] as number;
  const x0 = surface[AT_SURFACE.x0] as number;
  const x1 = surface[AT_SURFACE.x1] as number;
  const x2 = surface[AT_SURFACE.x2] as number;
  const x3 = surface[AT_SURFACE.x3] as number;
  const y0 = surface[AT_SURFACE.y0] as number;
  const y1 = surface[AT_SURFACE.y1] as number;
  const y2 = surface[AT_SURFACE.y2] as number;
  const y3 = surface[AT_SURFACE.y3] as number;
  const z0 = surface[AT_SURFACE.z0] as number;
  const z1 = surface[AT_SURFACE.z1] as number;
  const z2 = surface[AT_SURFACE.z2] as number;
  const z3 = surface[AT_SURFACE.z3] as number;
  const rho0 = surface[AT_SURFACE.rho0] as number;
  const rho1 = surface[AT_SURFACE.rho1] as number;
  const rho2 = surface[AT_SURFACE.rho2] as number;
  const rho3 = surface[AT_SURFACE.rho3] as number;
  const k1 = surface[AT_SURFACE.k1] as number;
  const k2 = surface[AT_SURFACE.k2] as number;
  const k3 = surface[AT_SURFACE.k3] as number;
  const k4 = surface[AT_SURFACE.k4] as number;
  const kRest = surface[AT_SURFACE.kRest] as number;
  const sign = surface[AT_SURFACE.sign] as number;
  const largest = surface[AT_SURFACE.largest] as number;
  const offOfB = surface[AT_SURFACE.offB] as number;
  const offOfC = surface[AT_SURFACE.offC] as number;
  const splitter = SURFACE_BOUNDS[AT_SURFACE_BOUND.splitter] as number;
  const grid = SURFACE_BOUNDS[AT_SURFACE_BOUND.grid] as number;
  const close = SURFACE_BOUNDS[AT_SURFACE_BOUND.close] as number;
  const offOfA = SURFACE_BOUNDS[AT_SURFACE_BOUND.offOfA] as number;
  const own = SURFACE_BOUNDS[AT_SURFACE_BOUND.own] as number;
  const faithful = SURFACE_BOUNDS[AT_SURFACE_BOUND.faithful] as number;
  const largestS = SURFACE_BOUNDS[AT_SURFACE_BOUND.largestS] as number;
  const eighth = SURFACE_BOUNDS[AT_SURFACE_BOUND.eighth] as number;
  const sixteenth = SURFACE_BOUNDS[AT_SURFACE_BOUND.sixteenth] as number;
  const fifth = SURFACE_BOUNDS[AT_SURFACE_BOUND.fifth] as number;
  let left = 0;
  for (let j = 0; j < count; j++) {
    const i = places[j] as number;
    const x = dx[i] as number;
    const y = dy[i] as number;
    const z = dz[i] as number;
    const ex = Ex[i] as number;
    const ey = Ey[i] as number;
    const ez = Ez[i] as number;
    const ey0 = ey + cutY0 - cutY0;
    const eya = ey - ey0;
    const ey1 = eya + cutY1 - cutY1;
    const eyb = eya - ey1;
    const ey2 = eyb + cutY2 - cutY2;
    const py0 = ey0 - y0;
    const py1 = ey1 - y1;
    const py2 = ey2 - y2;
    const py3 = eyb - ey2 - y3;
    const lead = k1 * py0;
    const K0 = lead + cut0 - cut0;
    const above = lead - K0 + (k1 * py1 + k2 * py0);
    const K1 = above + cut1 - cut1;
    const high = above - K1 + (k1 * py2 + k2 * py1 + k3 * py0);
    const K2 = high + cut2 - cut2;
    const K3 = high - K2 + (k1 * py3 + (k2 * (py2 + py3) + (k3 * (py1 + py2) + k4 * (py0 + py1))));
    const Kl = K1 + K2;
    const K = K0 + Kl;
    const ex0 = ex + cut0 - cut0;
    const exa = ex - ex0;
    const ex1 = exa + cut1 - cut1;
    const exb = exa - ex1;
    const ex2 = exb + cut2 - cut2;
    const px0 = ex0 - x0;
    const px1 = ex1 - x1;
    const px2 = ex2 - x2;
    const px3 = exb - ex2 - x3;
    const ez0 = ez + cut0 - cut0;
    const eza = ez - ez0;
    const ez1 = eza + cut1 - cut1;
    const ezb = eza - ez1;
    const ez2 = ezb + cut2 - cut2;
    const pz0 = ez0 - z0;
    const pz1 = ez1 - z1;
    const pz2 = ez2 - z2;
    const pz3 = ezb - ez2 - z3;
    const pxl = px1 + px2;
    const pzl = pz1 + pz2;
    const px = px0 + pxl;
    const pz = pz0 + pzl;

    const heads = px0 * px0 + pz0 * pz0 - sign * (K0 * K0) - rho0;
    const cross = px0 * px1 + pz0 * pz1 - sign * (K0 * K1);
    const seconds = cross + cross - rho1;
    const third = px0 * px2 + pz0 * pz2 - sign * (K0 * K2);
    const thirds = px1 * px1 + pz1 * pz1 - sign * (K1 * K1) + (third + third) - rho2;
    const fourth = px1 * px2 + pz1 * pz2 - sign * (K1 * K2);
    const fourths = fourth + fourth;
    const fifths = px * px3 + pz * pz3 - sign * (K * K3);
    const C1 = heads + seconds;
    const C2 = C1 + thirds;
    const C3 = C2 + fourths;
    const Cl =
      seconds -
      (C1 - heads) +
      (thirds - (C2 - C1) + (fourths - (C3 - C2))) +
      (fifths + fifths + (px2 * px2 + pz2 * pz2 - sign * (K2 * K2) - rho3));
    const C = C3 + Cl;

    const bigY = splitter * y;
    const topY = bigY - (bigY - y);
    const rise = k1 * topY;
    const speed = Math.abs(x) + Math.abs(z) + Math.abs(rise);
    const gridD = grid * speed;
    const xh = x + gridD - gridD;
    const xl = x - xh;
    const zh = z + gridD - gridD;
    const zl = z - zh;
    const yh = rise + gridD - gridD;
    const yl = rise - yh + (k1 * (y - topY) + kRest * y);
    const sh = sign * yh;
    const sl = sign * yl;
    const A0 = xh * xh + zh * zh - sh * yh;
    const A1 = xl * (x + xh) + zl * (z + zh) - sl * (yh + yl + yh);
    const A = A0 + A1;
    const Al = A1 - (A - A0);
    const b0 = xh * px0 + zh * pz0 - sh * K0;
    const b1 = xh * pxl + xl * px + (zh * pzl + zl * pz) - (sh * Kl + sl * K);
    const b = b0 + b1;
    const bl = b1 - (b - b0);

    const over = 1 / (A * b);
    const overB = over * A;
    const overA = over * b;
    const ratio = A * C * overB;
    const epsilon = ratio * overB;
    const reach = Math.abs(px) + Math.abs(pz) + Math.abs(K);
    const clear =
      Math.abs(epsilon) <= close && speed < largestS && speed * largestS > 1 && reach < largest;
    if (!clear) {
      places[left++] = i;
      continue;
    }
    const eta = epsilon * (0.5 + epsilon * (eighth + epsilon * (sixteenth + epsilon * fifth)));
    const q0 = -2 * b;
    const q1 = b * eta - (bl + bl);
    const q = q0 + q1;
    const ql = q1 - (q - q0);
    const half = 0.5 * eta;
    const overQ = -0.5 * overB * (1 + (half + half * half));
    const far0 = q * overA;
    const bigF = splitter * far0;
    const farH = bigF - (bigF - far0);
    const bigA = splitter * A;
    const Ah = bigA - (bigA - A);
    const far = farH + (q - farH * Ah - farH * (A - Ah + Al) + ql) * overA;
    const near0 = C * overQ;
    const bigN = splitter * near0;
    const nearH = bigN - (bigN - near0);
    const bigQ = splitter * q;
    const qh = bigQ - (bigQ - q);
    const near = nearH + (C3 - nearH * qh - nearH * (q - qh + ql) + Cl) * overQ;

    const share = own + offOfB * speed * Math.abs(overB);
    const sizeOf = Math.abs(near);
    const settled =
      share + offOfA * (speed * speed) * Math.abs(overA) <= faithful &&
      share * sizeOf + offOfC * reach * Math.abs(overQ) <= faithful * sizeOf;
    // 1 or 0, whether near is the lesser root: Math.min branches, and not even the processor knows
    // on which side of the surface a ray begins.
    const side = (0.5 * far) / Math.abs(far);
    const first = 0.5 + side;
    const second = 0.5 - side;
    if (settled) {
      t0[i] = first * near + second * far;
      t1[i] = second * near + first * far;
    } else places[left++] = i;
  }
  return left;
};

import {
  type Answers,
  type Kernel,
  list,
  NONE,
  type Rays,
  selectFirst,
  TWO,
  UNDECIDED,
} from './batch.ts';
import type { Quadric } from './quadric.ts';
import {
  type CurvedSlot,
  curvedSlot,
  hasNormal,
  solveSlot,
  textbookCoefficients,
  vanishingFlare,
} from './textbook-scalar.ts';

/** |t| + |s| below this did not overflow on the way. */
const LARGE = 2 ** 1022;
const MAX = Number.MAX_VALUE;
/**
 * With |d|², |p|², |a| and ρ below 2^200: |B| ≤ 2(1 + |a|)|d||p| < 2^402 and |C| < 2^402; with |A|
 * and |D| above 2^-200 also |q| ≥ √D/2 > 2^-102, and so q/A and C/q stay below 2^604.
 */
const WIDE = 2 ** 200;
const TINY = 2 ** -200;

/**
 * The moment form over arrays, for curved shapes: D/4 = ρA + a(mx² + mz²) − my² and the stable
 * roots. D < 0 makes both roots NaN by itself; what needs a case distinction takes the scalar form.
 */
export function momentQuadric(q: Quadric): Kernel {
  const slot = curvedSlot();
  // With a = 0 a far hit can lack its normal, which only the scalar form sees.
  const careful = vanishingFlare(q);
  const both = (rays: Rays, out: Answers): void =>
    careful ? everyRay(q, rays, out, slot) : roots(q, rays, out, slot);
  const large = careful || !(Math.abs(flareOf(q)) < WIDE && q.r * q.r < WIDE);
  return {
    met: 'two',
    both,
    classes: (rays, out) => (large ? everyRay(q, rays, out, slot) : margins(q, rays, out, slot)),
    first(rays, tMin, tMax, out) {
      both(rays, out);
      selectFirst(out, rays.count, tMin, tMax);
    },
  };
}

function everyRay(q: Quadric, rays: Rays, out: Answers, slot: CurvedSlot): void {
  out.rareCount = 0;
  for (let i = 0; i < rays.count; i++) solveOne(q, rays, i, out, slot);
}

function solveOne(q: Quadric, rays: Rays, i: number, out: Answers, slot: CurvedSlot): void {
  const Ey = rays.Ey[i] as number;
  const dy = rays.dy[i] as number;
  const verdict = solve(q, rays, i, slot);
  const whole = hasNormal(q, Ey, dy, slot.t0) && hasNormal(q, Ey, dy, slot.t1);
  out.t0[i] = whole ? slot.t0 : Number.NaN;
  out.t1[i] = whole ? slot.t1 : Number.NaN;
  out.margin[i] = verdict === NONE ? -1 : 1;
  if (!whole) list(out, i, UNDECIDED);
  else if (verdict !== NONE && verdict !== TWO) list(out, i, verdict);
}

function solve(q: Quadric, rays: Rays, i: number, slot: CurvedSlot): number {
  const Ex = rays.Ex[i] as number;
  const Ey = rays.Ey[i] as number;
  const Ez = rays.Ez[i] as number;
  const dx = rays.dx[i] as number;
  const dy = rays.dy[i] as number;
  const dz = rays.dz[i] as number;
  textbookCoefficients(q, Ex, Ey, Ez, dx, dy, dz, slot);
  const px = Ex - q.Cx;
  const py = Ey - q.Cy;
  const pz = Ez - q.Cz;
  const my = dz * px - dx * pz;
  const lift = q.hasY ? flareOf(q) * (square(dy * pz - dz * py) + square(dx * py - dy * px)) : 0;
  const known = q.hasR ? q.r * q.r * slot.A : lift;
  const sum = q.hasR && q.hasY ? known + lift : known;
  slot.D = 4 * (sum - my * my);
  return solveSlot(slot, true);
}

const square = (x: number): number => x * x;
const flareOf = (q: Quadric): number => (q.squared ? q.flare * q.flare : q.flare);

function roots(q: Quadric, rays: Rays, out: Answers, slot: CurvedSlot): void {
  const { count, Ex, Ey, Ez, dx, dy, dz } = rays;
  const { t0, t1 } = out;
  const { Cx, Cy, Cz, hasY, hasR } = q;
  const a = flareOf(q);
  const rho = q.r * q.r;
  out.rareCount = 0;
  for (let i = 0; i < count; i++) {
    const x = dx[i] as number;
    const z = dz[i] as number;
    const px = (Ex[i] as number) - Cx;
    const pz = (Ez[i] as number) - Cz;
    const my = z * px - x * pz;
    let A = x * x + z * z;
    let B = 2 * x * px + 2 * z * pz;
    let C = px * px + pz * pz;
    let sum = 0;
    if (hasY) {
      const y = dy[i] as number;
      const py = (Ey[i] as number) - Cy;
      const mx = y * pz - z * py;
      const mz = x * py - y * px;
      A -= a * (y * y);
      B -= 2 * a * y * py;
      C -= a * (py * py);
      sum = a * (mx * mx + mz * mz);
      if (hasR) sum = rho * A + sum;
    } else sum = rho * A;
    if (hasR) C -= rho;
    const D = 4 * (sum - my * my);
    const s = Math.sqrt(D);
    const w = (B < 0 ? s - B : -(B + s)) / 2;
    const near = w / A;
    const far = C / w;
    const size = Math.abs(near) + Math.abs(far);
    if (A === 0 || D === 0 || !(Math.abs(A) <= MAX && Math.abs(D) <= MAX)) {
      solveOne(q, rays, i, out, slot);
    } else if (size >= LARGE || size === 0 || (D > 0 && Number.isNaN(size))) {
      solveOne(q, rays, i, out, slot);
    } else {
      t0[i] = Math.min(near, far);
      t1[i] = Math.max(near, far);
    }
  }
}

function margins(q: Quadric, rays: Rays, out: Answers, slot: CurvedSlot): void {
  const { count, Ex, Ey, Ez, dx, dy, dz } = rays;
  const { margin } = out;
  const { Cx, Cy, Cz, hasY, hasR } = q;
  const a = flareOf(q);
  const rho = q.r * q.r;
  out.rareCount = 0;
  for (let i = 0; i < count; i++) {
    const x = dx[i] as number;
    const z = dz[i] as number;
    const px = (Ex[i] as number) - Cx;
    const pz = (Ez[i] as number) - Cz;
    const my = z * px - x * pz;
    let A = x * x + z * z;
    let p = px * px + pz * pz;
    let d = A;
    let sum = 0;
    if (hasY) {
      const y = dy[i] as number;
      const py = (Ey[i] as number) - Cy;
      const mx = y * pz - z * py;
      const mz = x * py - y * px;
      p += py * py;
      d += y * y;
      A -= a * (y * y);
      sum = a * (mx * mx + mz * mz);
      if (hasR) sum = rho * A + sum;
    } else sum = rho * A;
    const D = 4 * (sum - my * my);
    if (Math.abs(D) > TINY && Math.abs(A) > TINY && p < WIDE && d < WIDE) margin[i] = D;
    else solveOne(q, rays, i, out, slot);
  }
}

import { type Answers, type Kernel, list, NONE, type Rays, selectFirst, TWO } from './batch.ts';
import type { Quadric } from './quadric.ts';
import { type CurvedSlot, curvedSlot, solveCurved, vanishingFlare } from './textbook-scalar.ts';

/**
 * A sum of two roots' sizes below this cannot have overflowed on the way; above, the scalar form
 * looks closer.
 */
const LARGE = 2 ** 1022;
const MAX = Number.MAX_VALUE;

/**
 * The course's formula over arrays, for curved shapes. D < 0 makes both roots NaN by itself;
 * whatever needs a case distinction (A = 0, D = 0, an overflow) takes the scalar form, which is
 * rare and hence a well-predicted branch.
 */
export function textbookQuadric(q: Quadric, stable = false): Kernel {
  const slot = curvedSlot();
  // With a = 0 a far hit can lack its normal, which only the scalar form sees.
  const roots = vanishingFlare(q) ? careful : q.hasY ? inSpace : aroundAxis;
  return {
    met: 'two',
    classes: (rays, out) =>
      (vanishingFlare(q) ? marginsCarefully : margins)(q, rays, out, slot, stable),
    both: (rays, out) => roots(q, rays, out, slot),
    first(rays, tMin, tMax, out) {
      roots(q, rays, out, slot);
      selectFirst(out, rays.count, tMin, tMax);
    },
  };
}

/** The scalar form for ray i; what is not the usual class is listed. */
export function solveOne(
  q: Quadric,
  rays: Rays,
  i: number,
  out: Answers,
  slot: CurvedSlot,
  stable: boolean,
): void {
  const { Ex, Ey, Ez, dx, dy, dz } = rays;
  const verdict = solveCurved(
    q,
    Ex[i] as number,
    Ey[i] as number,
    Ez[i] as number,
    dx[i] as number,
    dy[i] as number,
    dz[i] as number,
    slot,
    stable,
  );
  out.t0[i] = slot.t0;
  out.t1[i] = slot.t1;
  out.margin[i] = verdict === NONE ? -1 : 1;
  if (verdict !== NONE && verdict !== TWO) list(out, i, verdict);
}

function careful(q: Quadric, rays: Rays, out: Answers, slot: CurvedSlot): void {
  out.rareCount = 0;
  for (let i = 0; i < rays.count; i++) solveOne(q, rays, i, out, slot, false);
}

function aroundAxis({ Cx, Cz, r }: Quadric, rays: Rays, out: Answers, slot: CurvedSlot): void {
  const { count, Ex, Ez, dx, dz } = rays;
  const { t0, t1 } = out;
  const rho = r * r;
  const q = { Cx, Cy: 0, Cz, hasY: false, flare: 0, squared: false, r, hasR: true };
  out.rareCount = 0;
  for (let i = 0; i < count; i++) {
    const x = dx[i] as number;
    const z = dz[i] as number;
    const px = (Ex[i] as number) - Cx;
    const pz = (Ez[i] as number) - Cz;
    const A = x * x + z * z;
    const B = 2 * x * px + 2 * z * pz;
    const C = px * px + pz * pz - rho;
    const D = B * B - 4 * A * C;
    const s = Math.sqrt(D);
    const w = 2 * A;
    const near = (-B - s) / w;
    const far = (-B + s) / w;
    const size = Math.abs(near) + Math.abs(far);
    if (A === 0 || D === 0 || !(Math.abs(D) <= MAX) || size >= LARGE || size === 0) {
      solveOne(q, rays, i, out, slot, false);
    } else {
      t0[i] = Math.min(near, far);
      t1[i] = Math.max(near, far);
    }
  }
}

function inSpace(q: Quadric, rays: Rays, out: Answers, slot: CurvedSlot): void {
  const { count, Ex, Ey, Ez, dx, dy, dz } = rays;
  const { t0, t1 } = out;
  const { Cx, Cy, Cz } = q;
  const a = q.squared ? q.flare * q.flare : q.flare;
  const rho = q.r * q.r;
  out.rareCount = 0;
  for (let i = 0; i < count; i++) {
    const x = dx[i] as number;
    const y = dy[i] as number;
    const z = dz[i] as number;
    const px = (Ex[i] as number) - Cx;
    const py = (Ey[i] as number) - Cy;
    const pz = (Ez[i] as number) - Cz;
    const A = x * x + z * z - a * (y * y);
    const B = 2 * x * px + 2 * z * pz - 2 * a * y * py;
    const C = px * px + pz * pz - a * (py * py) - rho;
    const D = B * B - 4 * A * C;
    const s = Math.sqrt(D);
    const w = 2 * A;
    const near = (-B - s) / w;
    const far = (-B + s) / w;
    const size = Math.abs(near) + Math.abs(far);
    if (A === 0 || D === 0 || !(Math.abs(D) <= MAX) || size >= LARGE || size === 0) {
      solveOne(q, rays, i, out, slot, false);
    } else {
      t0[i] = Math.min(near, far);
      t1[i] = Math.max(near, far);
    }
  }
}

/**
 * D alone, for textbook and stable alike. Unlike the roots it does not tell whether these overflow:
 * then `intersect` answers 'undecided', and so must this. |t| ≤ (|B| + √D)/2|A| is below 2^1022
 * wherever |A| is not tiny beside |B| and √D, which is all that is tested.
 */
function margins(q: Quadric, rays: Rays, out: Answers, slot: CurvedSlot, stable: boolean): void {
  const { count, Ex, Ey, Ez, dx, dy, dz } = rays;
  const { margin } = out;
  const { Cx, Cy, Cz } = q;
  const a = q.squared ? q.flare * q.flare : q.flare;
  const rho = q.r * q.r;
  out.rareCount = 0;
  if (!q.hasY) {
    for (let i = 0; i < count; i++) {
      const x = dx[i] as number;
      const z = dz[i] as number;
      const px = (Ex[i] as number) - Cx;
      const pz = (Ez[i] as number) - Cz;
      const A = x * x + z * z;
      const B = 2 * x * px + 2 * z * pz;
      const C = px * px + pz * pz - rho;
      const D = B * B - 4 * A * C;
      if (D === 0 || !(Math.abs(D) < WIDE && Math.abs(B) < WIDE && Math.abs(A) > TINY)) {
        solveOne(q, rays, i, out, slot, stable);
      } else margin[i] = D;
    }
    return;
  }
  for (let i = 0; i < count; i++) {
    const x = dx[i] as number;
    const y = dy[i] as number;
    const z = dz[i] as number;
    const px = (Ex[i] as number) - Cx;
    const py = (Ey[i] as number) - Cy;
    const pz = (Ez[i] as number) - Cz;
    const A = x * x + z * z - a * (y * y);
    const B = 2 * x * px + 2 * z * pz - 2 * a * y * py;
    const C = px * px + pz * pz - a * (py * py) - rho;
    const D = B * B - 4 * A * C;
    if (D === 0 || !(Math.abs(D) < WIDE && Math.abs(B) < WIDE && Math.abs(A) > TINY)) {
      solveOne(q, rays, i, out, slot, stable);
    } else margin[i] = D;
  }
}

/** |B|, √D < 2^500 and |A| > 2^-500 keep every root below 2^1001. */
const WIDE = 2 ** 500;
const TINY = 2 ** -500;

function marginsCarefully(
  q: Quadric,
  rays: Rays,
  out: Answers,
  slot: CurvedSlot,
  stable: boolean,
): void {
  out.rareCount = 0;
  for (let i = 0; i < rays.count; i++) solveOne(q, rays, i, out, slot, stable);
}

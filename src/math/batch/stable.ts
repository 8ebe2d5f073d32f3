import { type Answers, type Kernel, type Rays, selectFirst } from './batch.ts';
import type { Quadric } from './quadric.ts';
import { solveOne, textbookQuadric } from './textbook.ts';
import { type CurvedSlot, curvedSlot, vanishingFlare } from './textbook-scalar.ts';

/** As in textbook.ts. */
const LARGE = 2 ** 1022;
const MAX = Number.MAX_VALUE;

/**
 * The course's A, B, C and D with the sign-stable roots: q = −(B ± √D)/2, t = q/A and t = C/q.
 * Where the roots are not asked for it is the textbook method, but for which roots overflow; those
 * rays take the scalar form.
 */
export function stableQuadric(q: Quadric): Kernel {
  const slot = curvedSlot();
  const roots = vanishingFlare(q) ? careful : q.hasY ? inSpace : aroundAxis;
  return {
    met: 'two',
    classes: textbookQuadric(q, true).classes,
    both: (rays, out) => roots(q, rays, out, slot),
    first(rays, tMin, tMax, out) {
      roots(q, rays, out, slot);
      selectFirst(out, rays.count, tMin, tMax);
    },
  };
}

function careful(q: Quadric, rays: Rays, out: Answers, slot: CurvedSlot): void {
  out.rareCount = 0;
  for (let i = 0; i < rays.count; i++) solveOne(q, rays, i, out, slot, true);
}

function aroundAxis(shape: Quadric, rays: Rays, out: Answers, slot: CurvedSlot): void {
  const { count, Ex, Ez, dx, dz } = rays;
  const { t0, t1 } = out;
  const { Cx, Cz, r } = shape;
  const rho = r * r;
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
    // q has the sign that adds; which root is the smaller one depends on A as well.
    const q = B < 0 ? (s - B) / 2 : -(B + s) / 2;
    const near = q / A;
    const far = C / q;
    const size = Math.abs(near) + Math.abs(far);
    if (A === 0 || D === 0 || !(Math.abs(D) <= MAX) || size >= LARGE || size === 0) {
      solveOne(shape, rays, i, out, slot, true);
    } else {
      t0[i] = Math.min(near, far);
      t1[i] = Math.max(near, far);
    }
  }
}

function inSpace(shape: Quadric, rays: Rays, out: Answers, slot: CurvedSlot): void {
  const { count, Ex, Ey, Ez, dx, dy, dz } = rays;
  const { t0, t1 } = out;
  const { Cx, Cy, Cz } = shape;
  const a = shape.squared ? shape.flare * shape.flare : shape.flare;
  const rho = shape.r * shape.r;
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
    // q has the sign that adds; which root is the smaller one depends on A as well.
    const q = B < 0 ? (s - B) / 2 : -(B + s) / 2;
    const near = q / A;
    const far = C / q;
    const size = Math.abs(near) + Math.abs(far);
    if (A === 0 || D === 0 || !(Math.abs(D) <= MAX) || size >= LARGE || size === 0) {
      solveOne(shape, rays, i, out, slot, true);
    } else {
      t0[i] = Math.min(near, far);
      t1[i] = Math.max(near, far);
    }
  }
}

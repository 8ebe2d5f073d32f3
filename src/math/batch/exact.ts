import { roundedRoots, UNKNOWN } from '../methods/certified/doubled.ts';
import type { Shape } from '../shapes/index.ts';
import {
  type Answers,
  checkRay,
  type Kernel,
  list,
  NONE,
  type Rays,
  selectFirst,
  TWO,
} from './batch.ts';
import { solvePlanarExactly } from './exact-planar.ts';
import { type RootSlot, solveExactly } from './exact-quadric.ts';
import { type Planar, planarOf } from './planar.ts';
import { type Quadric, quadricOf } from './quadric.ts';

/**
 * Null for a shape without a kernel. Curved shapes: twice the digits, where their bounds say which
 * double is the nearest; whole numbers for the rest, and for flat shapes.
 */
export function exactKernel(shape: Shape): Kernel | null {
  const q = quadricOf(shape);
  if (q) return exactQuadric(q);
  const s = planarOf(shape);
  return s ? exactPlanar(s) : null;
}

function exactQuadric(q: Quadric): Kernel {
  const slot: RootSlot = { t0: Number.NaN, t1: Number.NaN };
  const E: [number, number, number] = [0, 0, 0];
  const d: [number, number, number] = [0, 0, 0];
  const ray = { origin: E, direction: d };
  const both = (rays: Rays, out: Answers): void => {
    const { count, Ex, Ey, Ez, dx, dy, dz } = rays;
    out.rareCount = 0;
    for (let i = 0; i < count; i++) {
      checkRay(rays, i, q.hasY, out);
      E[0] = Ex[i] as number;
      E[1] = Ey[i] as number;
      E[2] = Ez[i] as number;
      d[0] = dx[i] as number;
      d[1] = dy[i] as number;
      d[2] = dz[i] as number;
      const quick = roundedRoots(q, ray, slot);
      const verdict =
        quick === UNKNOWN ? solveExactly(q, E[0], E[1], E[2], d[0], d[1], d[2], slot) : quick;
      out.t0[i] = slot.t0;
      out.t1[i] = slot.t1;
      out.margin[i] = verdict === NONE ? -1 : 1;
      if (verdict !== NONE && verdict !== TWO) list(out, i, verdict);
    }
  };
  return withFirst('two', both);
}

function exactPlanar(s: Planar): Kernel {
  const slot: RootSlot = { t0: Number.NaN, t1: Number.NaN };
  const both = (rays: Rays, out: Answers): void => {
    const { count, Ex, Ey, Ez, dx, dy, dz } = rays;
    out.rareCount = 0;
    for (let i = 0; i < count; i++) {
      checkRay(rays, i, true, out);
      const verdict = solvePlanarExactly(
        s,
        Ex[i] as number,
        Ey[i] as number,
        Ez[i] as number,
        dx[i] as number,
        dy[i] as number,
        dz[i] as number,
        slot,
      );
      out.t0[i] = slot.t0;
      out.t1[i] = slot.t1;
      out.margin[i] = Number.isNaN(slot.t0) ? -1 : 1;
      if (Number.isNaN(slot.t0) && verdict !== NONE) list(out, i, verdict);
    }
  };
  return withFirst('one', both);
}

function withFirst(met: 'two' | 'one', both: (rays: Rays, out: Answers) => void): Kernel {
  return {
    met,
    both,
    classes: both,
    first(rays, tMin, tMax, out) {
      both(rays, out);
      selectFirst(out, rays.count, tMin, tMax);
    },
  };
}

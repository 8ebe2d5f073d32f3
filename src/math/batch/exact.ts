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
import { type RootSlot, solveExactly, type Within } from './exact-quadric.ts';
import { type Planar, planarOf } from './planar.ts';
import { type Quadric, quadricOf } from './quadric.ts';

/**
 * Null for a shape without a kernel. By whole numbers throughout: nothing of `certified` is used,
 * so that what is counted against `exact` proves something.
 */
export function exactKernel(shape: Shape): Kernel | null {
  const q = quadricOf(shape);
  if (q) return exactQuadric(q);
  const s = planarOf(shape);
  return s ? exactPlanar(s) : null;
}

function exactQuadric(q: Quadric): Kernel {
  const slot: RootSlot = { t0: Number.NaN, t1: Number.NaN };
  const solve = (rays: Rays, out: Answers, within: Within | null): void => {
    const { count, Ex, Ey, Ez, dx, dy, dz } = rays;
    out.rareCount = 0;
    for (let i = 0; i < count; i++) {
      checkRay(rays, i, q.hasY, out);
      const verdict = solveExactly(
        q,
        Ex[i] as number,
        Ey[i] as number,
        Ez[i] as number,
        dx[i] as number,
        dy[i] as number,
        dz[i] as number,
        slot,
        within,
      );
      out.t0[i] = slot.t0;
      out.t1[i] = slot.t1;
      out.margin[i] = verdict === NONE ? -1 : 1;
      if (verdict !== NONE && verdict !== TWO) list(out, i, verdict);
    }
  };
  return withFirst('two', solve);
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

function withFirst(
  met: 'two' | 'one',
  solve: (rays: Rays, out: Answers, within: Within | null) => void,
): Kernel {
  const both = (rays: Rays, out: Answers): void => solve(rays, out, null);
  return {
    met,
    both,
    classes: both,
    first(rays, tMin, tMax, out) {
      solve(rays, out, { tMin, tMax });
      selectFirst(out, rays.count, tMin, tMax);
    },
  };
}

import {
  type Answers,
  checkRay,
  chooseFirst,
  type Kernel,
  keepUnsettled,
  list,
  NONE,
  type Rays,
  TWO,
} from '../../batch/batch.ts';
import type { Quadric } from '../../batch/quadric.ts';
import { bothRoots, fastFor, openClasses } from './blocks.ts';
import { solveSlowly } from './doubled.ts';
import { AT_RANGE, firstRoots } from './first.ts';
import { certifiedQuadric, certifiedSlot, type OpenRays } from './numbers.ts';

/** Fast stages over all rays, then what they left open, one by one. */
export function certifiedKernel(q: Quadric): Kernel {
  const c = certifiedQuadric(q);
  const slot = certifiedSlot();
  const E: [number, number, number] = [0, 0, 0];
  const d: [number, number, number] = [0, 0, 0];
  const ray = { origin: E, direction: d };
  const left: OpenRays = { count: 0, open: new Int32Array(0) };
  const range = new Float64Array(2);

  function leaveAllOpen(rays: Rays): void {
    left.count = rays.count;
    for (let i = 0; i < rays.count; i++) left.open[i] = i;
  }

  function finish(rays: Rays, out: Answers): void {
    const { Ex, Ey, Ez, dx, dy, dz } = rays;
    for (let k = 0; k < left.count; k++) {
      const i = left.open[k] as number;
      checkRay(rays, i, q.hasY, out);
      E[0] = Ex[i] as number;
      E[1] = Ey[i] as number;
      E[2] = Ez[i] as number;
      d[0] = dx[i] as number;
      d[1] = dy[i] as number;
      d[2] = dz[i] as number;
      const verdict = solveSlowly(q, ray, slot);
      out.t0[i] = verdict === NONE ? Number.NaN : slot.t0;
      out.t1[i] = verdict === NONE ? Number.NaN : slot.t1;
      out.margin[i] = verdict === NONE ? -1 : 1;
      if (verdict !== NONE && verdict !== TWO) list(out, i, verdict);
    }
  }

  function prepare(rays: Rays, out: Answers): void {
    out.rareCount = 0;
    if (left.open.length < rays.count) left.open = new Int32Array(rays.count);
  }

  function both(rays: Rays, out: Answers): void {
    prepare(rays, out);
    if (c.inBox) bothRoots(q, c, rays, out, left);
    else leaveAllOpen(rays);
    finish(rays, out);
  }

  function firstInTypeScript(rays: Rays, tMin: number, tMax: number, out: Answers): void {
    prepare(rays, out);
    range[AT_RANGE.tMin] = tMin;
    range[AT_RANGE.tMax] = tMax;
    if (c.inBox) firstRoots(range, q, c, rays, out, left);
    else leaveAllOpen(rays);
    finish(rays, out);
    for (let k = 0; k < left.count; k++) {
      const i = left.open[k] as number;
      chooseFirst(out, i, i + 1, tMin, tMax);
    }
  }

  return {
    met: 'two',
    both,
    first(rays, tMin, tMax, out) {
      const stages = c.inBox ? fastFor(rays.count) : null;
      if (stages) {
        both(rays, out);
        stages.first(out, rays.count, tMin, tMax);
      } else firstInTypeScript(rays, tMin, tMax, out);
      keepUnsettled(out);
    },
    classes(rays, out) {
      prepare(rays, out);
      if (c.inBox) openClasses(q, c, rays, out, left);
      else leaveAllOpen(rays);
      finish(rays, out);
    },
  };
}

import {
  type Answers,
  type Kernel,
  list,
  NONE,
  ONE,
  type Rays,
  selectFirst,
  TWO,
} from './batch.ts';

/**
 * Solves ray i, writes its roots into out.t0[i] and out.t1[i] (NaN where there is none), and returns the class.
 * It takes an index and no doubles: a call that is not inlined would box them.
 */
export type SolveRay = (rays: Rays, i: number, out: Answers) => number;

/**
 * A kernel that asks `solve` ray by ray: for methods whose one ray costs many times a call. `classes` takes the roots along: whether one of them leaves the
 * machine's range decides between a class and 'undecided', and they are the smaller part of the work.
 */
export function kernelOf(met: 'two' | 'one', solve: SolveRay): Kernel {
  const usual = met === 'two' ? TWO : ONE;
  function both(rays: Rays, out: Answers): void {
    out.rareCount = 0;
    for (let i = 0; i < rays.count; i++) {
      const verdict = solve(rays, i, out);
      out.margin[i] = verdict === NONE ? -1 : 1;
      if (verdict !== NONE && verdict !== usual) list(out, i, verdict);
    }
  }
  return {
    met,
    classes: both,
    both,
    first(rays, tMin, tMax, out) {
      both(rays, out);
      selectFirst(out, rays.count, tMin, tMax);
    },
  };
}

/** No root is left standing; returns the verdict. */
export function withoutRoots(out: Answers, i: number, verdict: number): number {
  out.t0[i] = Number.NaN;
  out.t1[i] = Number.NaN;
  return verdict;
}

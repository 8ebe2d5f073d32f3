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
 * Solves ray i, writes its roots into out.t0[i] and out.t1[i] (NaN where there is none), if they
 * are asked for, and returns the class. It takes an index and no doubles: a call that is not
 * inlined would box them.
 */
type SolveRay = (rays: Rays, i: number, out: Answers) => number;

/**
 * A kernel that asks `solve` ray by ray, or `classify` where the roots are not wanted: for methods
 * whose one ray costs many times a call.
 */
export function kernelOf(met: 'two' | 'one', solve: SolveRay, classify: SolveRay = solve): Kernel {
  const usual = met === 'two' ? TWO : ONE;
  function ask(one: SolveRay, rays: Rays, out: Answers): void {
    out.rareCount = 0;
    for (let i = 0; i < rays.count; i++) {
      const verdict = one(rays, i, out);
      out.margin[i] = verdict === NONE ? -1 : 1;
      if (verdict !== NONE && verdict !== usual) list(out, i, verdict);
    }
  }
  const both = (rays: Rays, out: Answers): void => ask(solve, rays, out);
  return {
    met,
    classes: (rays, out) => ask(classify, rays, out),
    both,
    first(rays, tMin, tMax, out) {
      both(rays, out);
      selectFirst(out, rays.count, tMin, tMax);
    },
  };
}

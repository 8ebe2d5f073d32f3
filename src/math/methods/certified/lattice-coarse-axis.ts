import { AT } from './lattice.ts';
import { BOUNDS, type CoarsePass } from './lattice-bounds.ts';
import { DOUBTS, HITS, type Scratch, UNSETTLED } from './lattice-scratch.ts';

/** For cylinders, whose formula does not look at y. */
export function coarseAroundAxis(s: Scratch): CoarsePass {
  const { index, x: xs, z: zs, ex: exs, ez: ezs, doubtful, unsettled, count } = s;
  const { A: As, slope: slopes, half: halves, near, far, slack } = s;
  return (lattice, { Ex, Ez, dx, dz }, { t0, t1 }, from, to) => {
    const Cx = lattice[AT.Cx] as number;
    const Cz = lattice[AT.Cz] as number;
    const rho = lattice[AT.rho] as number;
    const smallest = lattice[AT.smallest] as number;
    const largestDirection = lattice[AT.largestDirection] as number;
    const smallestDirection = lattice[AT.smallestDirection] as number;
    const clearly = BOUNDS[0] as number;
    const certain = BOUNDS[1] as number;
    const slackA = BOUNDS[3] as number;
    const slack0 = BOUNDS[4] as number;
    const farther = BOUNDS[5] as number;
    let hits = 0;
    let doubts = 0;
    let close = 0;
    for (let i = from; i < to; i++) {
      const x = dx[i] as number;
      const z = dz[i] as number;
      const ex = Ex[i] as number;
      const ez = Ez[i] as number;
      const px = ex - Cx;
      const pz = ez - Cz;
      const A = x * x + z * z;
      const wide = px * px + pz * pz;
      const b = x * px + z * pz;
      const D = b * b - A * (wide - rho);
      const Cm = wide + rho;
      const Q = A * Cm;
      const fits = A > smallestDirection && A < largestDirection;
      const clear = D > clearly * Q + smallest && fits;
      const missed = D < certain * Q - smallest && fits;
      if (clear) {
        const root = Math.sqrt(D);
        const inverse = 1 / (A * D);
        const over = inverse * D;
        const h = root * over;
        const middle = -b * over;
        index[hits] = i;
        xs[hits] = x;
        zs[hits] = z;
        exs[hits] = ex;
        ezs[hits] = ez;
        As[hits] = A;
        const signed = A * h;
        slopes[hits] = signed;
        halves[hits] = 0.5 * (signed * (inverse * A));
        near[hits] = middle - h;
        far[hits] = middle + h;
        slack[hits] = slackA + slack0;
        hits += 1;
      } else if (missed) {
        t0[i] = Number.NaN;
        t1[i] = Number.NaN;
      } else {
        const remote = b * b > farther * D;
        if (remote) doubtful[doubts++] = i;
        else unsettled[close++] = i;
      }
    }
    count[HITS] = hits;
    count[DOUBTS] = doubts;
    count[UNSETTLED] = close;
  };
}

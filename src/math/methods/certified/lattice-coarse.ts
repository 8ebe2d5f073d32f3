import { AT } from './lattice.ts';
import { BOUNDS, type CoarsePass } from './lattice-bounds.ts';
import { DOUBTS, HITS, type Scratch, UNSETTLED } from './lattice-scratch.ts';

/** For shapes with a term in y. */
export function coarseInSpace(s: Scratch): CoarsePass {
  const { index, x: xs, y: ys, z: zs, ex: exs, ey: eys, ez: ezs, doubtful, unsettled, count } = s;
  const { A: As, slope: slopes, half: halves, near, far, slack } = s;
  return (lattice, { Ex, Ey, Ez, dx, dy, dz }, { t0, t1 }, from, to) => {
    const Cx = lattice[AT.Cx] as number;
    const Cy = lattice[AT.Cy] as number;
    const Cz = lattice[AT.Cz] as number;
    const a = lattice[AT.a] as number;
    const rho = lattice[AT.rho] as number;
    const smallest = lattice[AT.smallest] as number;
    const largestDirection = lattice[AT.largestDirection] as number;
    const smallestDirection = lattice[AT.smallestDirection] as number;
    const clearly = BOUNDS[0] as number;
    const certain = BOUNDS[1] as number;
    const least = BOUNDS[2] as number;
    const slackA = BOUNDS[3] as number;
    const slack0 = BOUNDS[4] as number;
    const farther = BOUNDS[5] as number;
    let hits = 0;
    let doubts = 0;
    let close = 0;
    for (let i = from; i < to; i++) {
      const x = dx[i] as number;
      const y = dy[i] as number;
      const z = dz[i] as number;
      const ex = Ex[i] as number;
      const ey = Ey[i] as number;
      const ez = Ez[i] as number;
      const px = ex - Cx;
      const py = ey - Cy;
      const pz = ez - Cz;
      const round = x * x + z * z;
      const ayy = a * (y * y);
      const wide = px * px + pz * pz;
      const app = a * (py * py);
      const A = round - ayy;
      const Am = round + Math.abs(ayy);
      const b = x * px + z * pz - a * (y * py);
      const D = b * b - A * (wide - app - rho);
      const Cm = wide + Math.abs(app) + rho;
      const Q = Am * Cm;
      const fits = Am > smallestDirection && Am < largestDirection;
      const clear = D > clearly * Q + smallest && fits && Math.abs(A) > least * Am;
      const missed = D < certain * Q - smallest && fits;
      if (clear) {
        // One division beside the root, not after it: 1/(A·D) gives 1/A and 1/√D.
        const root = Math.sqrt(D);
        const inverse = 1 / (A * D);
        const over = inverse * D;
        const h = root * Math.abs(over);
        const middle = -b * over;
        index[hits] = i;
        xs[hits] = x;
        ys[hits] = y;
        zs[hits] = z;
        exs[hits] = ex;
        eys[hits] = ey;
        ezs[hits] = ez;
        As[hits] = A;
        const signed = A * h;
        slopes[hits] = signed;
        halves[hits] = 0.5 * (signed * (inverse * A));
        near[hits] = middle - h;
        far[hits] = middle + h;
        slack[hits] = slackA * (Am * Math.abs(over)) + slack0;
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

import type { Answers, Rays } from '../../batch/batch.ts';
import { AT, LARGEST_LENGTH, type Lattice } from './lattice.ts';
import { DOUBTS, HITS, type Scratch } from './lattice-scratch.ts';

/*
 * Pass 1: is it hit, and roughly where. u = 2^-53. D = b² − AC, in halves, is off by 27u·Q at most, Q = Am·Cm (class-quadric.ts, with
 * Am = x² + y² + z² and Cm = |p|² + ρ, which are no smaller than there since |a| ≤ 1). In units nothing overflows, and what underflows is
 * far below SMALLEST.
 *
 * D > CLEAR·Q: √D is known to 27u·2^13 < 2^-35 of itself. Then |b|/√D < 2^7, so that the rounding of the rough roots, a few u(|b| + √D)/|A|, is
 * below 2^-42 of their distance, and this is known to 2^-34.
 * |A| > LEAST·Am: |δA| ≤ 3u·Am + u|A| (squares u, their sum u; a·y² 3u; the difference), so A is known to 200u, and not 0.
 */
const CLEAR = 2 ** -14;
const CERTAIN = 28 * 2 ** -53;
const SMALLEST = 2 ** -100;
const LEAST = 2 ** -6;
const LARGEST_SQUARE = LARGEST_LENGTH ** 2;
/** Some component of d has then at least 2^3 units, so that t·d shows it when t is too large to be cut. */
const SMALLEST_SQUARE = 2 ** 8;

/** The relative error of a step in lattice-solve.ts is (4 Am/|A| + |b|/(2√D) + 15)u at most; pass 1 has these numbers at hand. */
export const SLACK_A = 4 * 2 ** -53;
export const SLACK_M = 2 * 2 ** -53;
export const SLACK = 15 * 2 ** -53;

/** The loops take their bounds from here: of a module's constants a bundler makes variables, which V8 looks up at each use. */
const BOUNDS = Float64Array.of(
  CLEAR,
  CERTAIN,
  SMALLEST,
  LEAST,
  LARGEST_SQUARE,
  SMALLEST_SQUARE,
  SLACK_A,
  SLACK_M,
  SLACK,
);

export type CoarsePass = (
  lattice: Lattice,
  rays: Rays,
  out: Answers,
  from: number,
  to: number,
) => void;

/** For shapes with a term in y. */
export function coarseInSpace(s: Scratch): CoarsePass {
  const { index, x: xs, y: ys, z: zs, ex: exs, ey: eys, ez: ezs, doubtful, count } = s;
  const { A: As, overA, near, far, overGap, slack } = s;
  return (lattice, { Ex, Ey, Ez, dx, dy, dz }, { t0, t1 }, from, to) => {
    const direction = lattice[AT.direction] as number;
    const directionY = lattice[AT.directionY] as number;
    const length = lattice[AT.length] as number;
    const lengthY = lattice[AT.lengthY] as number;
    const Cx = lattice[AT.Cx] as number;
    const Cy = lattice[AT.Cy] as number;
    const Cz = lattice[AT.Cz] as number;
    const a = lattice[AT.a] as number;
    const rho = lattice[AT.rho] as number;
    const clear = BOUNDS[0] as number;
    const certain = BOUNDS[1] as number;
    const smallest = BOUNDS[2] as number;
    const least = BOUNDS[3] as number;
    const largestSquare = BOUNDS[4] as number;
    const smallestSquare = BOUNDS[5] as number;
    const slackA = BOUNDS[6] as number;
    const slackM = BOUNDS[7] as number;
    const slack0 = BOUNDS[8] as number;
    let hits = 0;
    let doubts = 0;
    for (let i = from; i < to; i++) {
      const x = direction * (dx[i] as number);
      const y = directionY * (dy[i] as number);
      const z = direction * (dz[i] as number);
      const ex = length * (Ex[i] as number);
      const ey = lengthY * (Ey[i] as number);
      const ez = length * (Ez[i] as number);
      const px = ex - Cx;
      const py = ey - Cy;
      const pz = ez - Cz;
      const round = x * x + z * z;
      const yy = y * y;
      const wide = px * px + pz * pz;
      const pp = py * py;
      const A = round - a * yy;
      const Am = round + yy;
      const b = x * px + z * pz - a * (y * py);
      const D = b * b - A * (wide - a * pp - rho);
      const Cm = wide + pp + rho;
      const Q = Am * Cm;
      if (
        D > clear * Q + smallest &&
        Am < largestSquare &&
        Am > smallestSquare &&
        Cm < largestSquare &&
        Math.abs(A) > least * Am
      ) {
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
        overA[hits] = over;
        near[hits] = middle - h;
        far[hits] = middle + h;
        const quarter = 0.25 * (root * Math.abs(inverse)) * (A * A);
        overGap[hits] = quarter;
        slack[hits] =
          slackA * (Am * Math.abs(over)) + slackM * (Math.abs(middle) * quarter) + slack0;
        hits += 1;
      } else if (D < -(certain * Q) - smallest && Am < largestSquare && Cm < largestSquare) {
        t0[i] = Number.NaN;
        t1[i] = Number.NaN;
      } else doubtful[doubts++] = i;
    }
    count[HITS] = hits;
    count[DOUBTS] = doubts;
  };
}

/** For cylinders, whose formula does not look at y. */
export function coarseAroundAxis(s: Scratch): CoarsePass {
  const { index, x: xs, z: zs, ex: exs, ez: ezs, doubtful, count } = s;
  const { A: As, overA, near, far, overGap, slack } = s;
  return (lattice, { Ex, Ez, dx, dz }, { t0, t1 }, from, to) => {
    const direction = lattice[AT.direction] as number;
    const length = lattice[AT.length] as number;
    const Cx = lattice[AT.Cx] as number;
    const Cz = lattice[AT.Cz] as number;
    const rho = lattice[AT.rho] as number;
    const clear = BOUNDS[0] as number;
    const certain = BOUNDS[1] as number;
    const smallest = BOUNDS[2] as number;
    const largestSquare = BOUNDS[4] as number;
    const smallestSquare = BOUNDS[5] as number;
    const slackA = BOUNDS[6] as number;
    const slackM = BOUNDS[7] as number;
    const slack0 = BOUNDS[8] as number;
    let hits = 0;
    let doubts = 0;
    for (let i = from; i < to; i++) {
      const x = direction * (dx[i] as number);
      const z = direction * (dz[i] as number);
      const ex = length * (Ex[i] as number);
      const ez = length * (Ez[i] as number);
      const px = ex - Cx;
      const pz = ez - Cz;
      const A = x * x + z * z;
      const wide = px * px + pz * pz;
      const b = x * px + z * pz;
      const D = b * b - A * (wide - rho);
      const Cm = wide + rho;
      const Q = A * Cm;
      if (
        D > clear * Q + smallest &&
        A < largestSquare &&
        A > smallestSquare &&
        Cm < largestSquare
      ) {
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
        overA[hits] = over;
        near[hits] = middle - h;
        far[hits] = middle + h;
        const quarter = 0.25 * (root * inverse) * (A * A);
        overGap[hits] = quarter;
        slack[hits] = slackM * (Math.abs(middle) * quarter) + (slackA + slack0);
        hits += 1;
      } else if (D < -(certain * Q) - smallest && A < largestSquare && Cm < largestSquare) {
        t0[i] = Number.NaN;
        t1[i] = Number.NaN;
      } else doubtful[doubts++] = i;
    }
    count[HITS] = hits;
    count[DOUBTS] = doubts;
  };
}

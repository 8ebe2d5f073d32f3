import { type Answers, chooseFirst, type Rays } from '../../batch/batch.ts';
import type { Quadric } from '../../batch/quadric.ts';
import { laterStages, leaveAll, ordinary } from './blocks.ts';
import {
  AT_LATTICE,
  type CertifiedQuadric,
  inSlots,
  type Lattice,
  type OpenRays,
} from './numbers.ts';
import {
  AT_ROUGH,
  BLOCK,
  DOUBTS,
  HITS,
  ROUGH_BOUNDS,
  type Scratch,
  STARTING,
  UNSETTLED,
} from './units.ts';

/*
 * Pass 1 of units.ts where the first root in a range is asked for: nothing is solved of a ray that
 * has no root there, at half the price or less. Where it has one, both roots are solved all the
 * same: the nearer one's own operations are six tenths of those of both, 5 ns of 26, and to tell
 * these rays apart costs 7. Two rays at a time, in WebAssembly, seldom both have none.
 *
 * The rough roots are off by 2^-27 h at most, h half their distance: √D 2^-28.9, the middle 2^-35,
 * roundings u times |b|/√D ≤ 2^10. `apart` exceeds that so far that the rounded roots are on the
 * same side of tMin and tMax. `widest` leaves out each h of which 1/(A·D) has lost bits below the
 * normal doubles: these are above 2^300. What is rarely so is asked first: a branch that random
 * rays mislead waits for the root.
 */

/** The range asked for: in an array, like all numbers that loops take before they begin. */
export const AT_RANGE = { tMin: 0, tMax: 1 } as const;

/** In h. */
export const { at: AT_FIRST, doubles: FIRST_BOUNDS } = inSlots({ apart: 2 ** -20 });

/** As CoarsePass, but for hits without a root in the range, whose answers it puts, too. */
type RangedPass = (
  lattice: Lattice,
  range: Float64Array,
  rays: Rays,
  out: Answers,
  from: number,
  to: number,
) => void;

/** For shapes with a term in y. */
export function rangedInSpace(s: Scratch): RangedPass {
  const { index, x: xs, y: ys, z: zs, ex: exs, ey: eys, ez: ezs } = s;
  const { doubtful, unsettled, starting, count } = s;
  const { A: As, slope: slopes, half: halves, near, far, slack } = s;
  return (lattice, range, { Ex, Ey, Ez, dx, dy, dz }, { t0, t1 }, from, to) => {
    const Cx = lattice[AT_LATTICE.Cx] as number;
    const Cy = lattice[AT_LATTICE.Cy] as number;
    const Cz = lattice[AT_LATTICE.Cz] as number;
    const a = lattice[AT_LATTICE.a] as number;
    const rho = lattice[AT_LATTICE.rho] as number;
    const smallest = lattice[AT_LATTICE.smallest] as number;
    const largestDirection = lattice[AT_LATTICE.largestDirection] as number;
    const smallestDirection = lattice[AT_LATTICE.smallestDirection] as number;
    const widest = lattice[AT_LATTICE.largestSize] as number;
    const tMin = range[AT_RANGE.tMin] as number;
    const tMax = range[AT_RANGE.tMax] as number;
    const clearly = ROUGH_BOUNDS[AT_ROUGH.clearly] as number;
    const certain = ROUGH_BOUNDS[AT_ROUGH.certain] as number;
    const least = ROUGH_BOUNDS[AT_ROUGH.least] as number;
    const slackA = ROUGH_BOUNDS[AT_ROUGH.slackA] as number;
    const slack0 = ROUGH_BOUNDS[AT_ROUGH.slack0] as number;
    const nearly = ROUGH_BOUNDS[AT_ROUGH.nearly] as number;
    const farther = ROUGH_BOUNDS[AT_ROUGH.farther] as number;
    const apart = FIRST_BOUNDS[AT_FIRST.apart] as number;
    let hits = 0;
    let doubts = 0;
    let close = 0;
    let starts = 0;
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
      const bb = b * b;
      const AC = A * (wide - app - rho);
      const D = bb - AC;
      const Cm = wide + Math.abs(app) + rho;
      const Q = Am * Cm;
      const fits = Am > smallestDirection && Am < largestDirection;
      const clear =
        D > clearly * Q + smallest &&
        fits &&
        Math.abs(A) > least * Am &&
        Math.abs(AC) > nearly * bb;
      const missed = D < certain * Q - smallest && fits;
      if (clear) {
        const root = Math.sqrt(D);
        const inverse = 1 / (A * D);
        const over = inverse * D;
        const h = root * Math.abs(over);
        const middle = -b * over;
        const first = middle - h;
        const second = middle + h;
        const off = apart * h;
        const gone =
          h > 0 &&
          h < widest &&
          (second + off < tMin ||
            first - off > tMax ||
            (second - off > tMax && first + off < tMin));
        const signed = A * h;
        const steep = 0.5 * (signed * (inverse * A));
        const loose = slackA * (Am * Math.abs(over)) + slack0;
        if (gone) {
          t0[i] = Number.NaN;
          t1[i] = Number.NaN;
        } else {
          index[hits] = i;
          xs[hits] = x;
          ys[hits] = y;
          zs[hits] = z;
          exs[hits] = ex;
          eys[hits] = ey;
          ezs[hits] = ez;
          As[hits] = A;
          slopes[hits] = signed;
          halves[hits] = steep;
          near[hits] = first;
          far[hits] = second;
          slack[hits] = loose;
          hits += 1;
        }
      } else if (missed) {
        t0[i] = Number.NaN;
        t1[i] = Number.NaN;
      } else {
        const beside = Math.abs(AC) <= nearly * bb;
        const remote = bb > farther * D;
        if (beside) starting[starts++] = i;
        else if (remote) doubtful[doubts++] = i;
        else unsettled[close++] = i;
      }
    }
    count[HITS] = hits;
    count[DOUBTS] = doubts;
    count[UNSETTLED] = close;
    count[STARTING] = starts;
  };
}

/** For cylinders, whose formula does not look at y. */
export function rangedAroundAxis(s: Scratch): RangedPass {
  const { index, x: xs, z: zs, ex: exs, ez: ezs, doubtful, unsettled, starting, count } = s;
  const { A: As, slope: slopes, half: halves, near, far, slack } = s;
  return (lattice, range, { Ex, Ez, dx, dz }, { t0, t1 }, from, to) => {
    const Cx = lattice[AT_LATTICE.Cx] as number;
    const Cz = lattice[AT_LATTICE.Cz] as number;
    const rho = lattice[AT_LATTICE.rho] as number;
    const smallest = lattice[AT_LATTICE.smallest] as number;
    const largestDirection = lattice[AT_LATTICE.largestDirection] as number;
    const smallestDirection = lattice[AT_LATTICE.smallestDirection] as number;
    const widest = lattice[AT_LATTICE.largestSize] as number;
    const tMin = range[AT_RANGE.tMin] as number;
    const tMax = range[AT_RANGE.tMax] as number;
    const clearly = ROUGH_BOUNDS[AT_ROUGH.clearly] as number;
    const certain = ROUGH_BOUNDS[AT_ROUGH.certain] as number;
    const slackA = ROUGH_BOUNDS[AT_ROUGH.slackA] as number;
    const slack0 = ROUGH_BOUNDS[AT_ROUGH.slack0] as number;
    const nearly = ROUGH_BOUNDS[AT_ROUGH.nearly] as number;
    const farther = ROUGH_BOUNDS[AT_ROUGH.farther] as number;
    const apart = FIRST_BOUNDS[AT_FIRST.apart] as number;
    let hits = 0;
    let doubts = 0;
    let close = 0;
    let starts = 0;
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
      const bb = b * b;
      const AC = A * (wide - rho);
      const D = bb - AC;
      const Cm = wide + rho;
      const Q = A * Cm;
      const fits = A > smallestDirection && A < largestDirection;
      const clear = D > clearly * Q + smallest && fits && Math.abs(AC) > nearly * bb;
      const missed = D < certain * Q - smallest && fits;
      if (clear) {
        const root = Math.sqrt(D);
        const inverse = 1 / (A * D);
        const over = inverse * D;
        const h = root * over;
        const middle = -b * over;
        const first = middle - h;
        const second = middle + h;
        const off = apart * h;
        const gone =
          h > 0 &&
          h < widest &&
          (second + off < tMin ||
            first - off > tMax ||
            (second - off > tMax && first + off < tMin));
        const signed = A * h;
        const steep = 0.5 * (signed * (inverse * A));
        const loose = slackA + slack0;
        if (gone) {
          t0[i] = Number.NaN;
          t1[i] = Number.NaN;
        } else {
          index[hits] = i;
          xs[hits] = x;
          zs[hits] = z;
          exs[hits] = ex;
          ezs[hits] = ez;
          As[hits] = A;
          slopes[hits] = signed;
          halves[hits] = steep;
          near[hits] = first;
          far[hits] = second;
          slack[hits] = loose;
          hits += 1;
        }
      } else if (missed) {
        t0[i] = Number.NaN;
        t1[i] = Number.NaN;
      } else {
        const beside = Math.abs(AC) <= nearly * bb;
        const remote = bb > farther * D;
        if (beside) starting[starts++] = i;
        else if (remote) doubtful[doubts++] = i;
        else unsettled[close++] = i;
      }
    }
    count[HITS] = hits;
    count[DOUBTS] = doubts;
    count[UNSETTLED] = close;
    count[STARTING] = starts;
  };
}

let ranged: readonly [RangedPass, RangedPass] | null = null;

/**
 * The first root from tMin to tMax as both roots would have it, to the bit; NaN where there is
 * none. But for the rays that stay open.
 */
export function firstRoots(
  range: Float64Array,
  q: Quadric,
  c: CertifiedQuadric,
  rays: Rays,
  out: Answers,
  left: OpenRays,
): void {
  const tMin = range[AT_RANGE.tMin] as number;
  const tMax = range[AT_RANGE.tMax] as number;
  const { scratch, passes } = ordinary();
  const { residuals, solve } = passes;
  ranged ??= [rangedAroundAxis(scratch), rangedInSpace(scratch)];
  const form = q.hasY ? 1 : 0;
  left.count = 0;
  for (let from = 0; from < rays.count; from += BLOCK) {
    const to = Math.min(from + BLOCK, rays.count);
    if (c.lattice) {
      ranged[form](c.lattice, range, rays, out, from, to);
      residuals[form](c.lattice);
      solve(c.lattice, out);
    } else leaveAll(scratch, from, to);
    laterStages(scratch, q, c, rays, out, left);
    chooseFirst(out, from, to, tMin, tMax);
  }
}

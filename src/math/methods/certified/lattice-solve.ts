import type { Answers } from '../../batch/batch.ts';
import { AT, type Lattice } from './lattice.ts';
import { HITS, type Scratch, UNSETTLED } from './lattice-scratch.ts';

/*
 * Pass 3. The quadratic A(t − ta)(t − tb) is known by A and its values at the whole numbers a and b. With φ = f/A there, gap = b − a, and the
 * steps δa = ta − a, δb = tb − b:
 *
 *   δa = φa/(tb − a) = φa/(gap + δb),     δb = φb/(tb's distance from ta, taken from b) = φb/(δa − gap).
 *
 * Each is had from the other, in turn, beginning with what the rough tb leaves of b: a relative error e of a step becomes e·|δ|/gap in the next one.
 * Pass 1 knows the distance of the roots to 14u·Q/D and where their middle is to 4u√(Q/D) of it, together e ≤ 15u/CLEAR; with |δ| ≤ gap/64 the third
 * and the fourth step are free of it but for e/64² ≤ 4u.
 *
 * Errors of a step, w = Am/|A| and ε what pass 2 states of a residual's error absolutely (its 3u|f| are counted below):
 *   φ: f 3u, 1/A from 1/(AD)·D 3u and A's own (3w + 1)u, the product u:                             (3w + 8)u
 *   the divisor: its rounding u, and the other step's (3w + 10)u|δ| ≤ (0.05w + 0.2)u gap;           (0.05w + 1.2)u
 *   the quotient, the e from above, and what is left over of u²:                                    5u
 *   From its own ε, ε/(|A|(gap − |δ|)):                                                             1.02 ε/(|A|gap)
 *   From the other root's, through the divisor: its certificate keeps ε/(|A|gap) below u|tb|/2, and |tb|/gap is below (√(1/CLEAR) + 1)/1.9,
 *   with CLEAR = 2^-10 less than 18:                                                                9u|δ|
 *
 * In all 1.02 ε/(|A|gap) + (SLACK_A w + SLACK)|δ|. The root a + δa is rounded once: it is faithful, and the root itself where that is a double, if it
 * was off by less than u|t|/2 before, since neighbours of t are at least u|t| apart. FAITHFUL leaves a tenth for evaluating the bound, in which all is
 * multiplied by the gap. NaN and what overflows fail the comparisons.
 */
/** Beyond, the whole parts' sums might not be exact: below 2^24. */
export const LARGEST_SPREAD = 2 ** 24;
export const ROUNDING = 10.5 * 2 ** -53;
export const SMALL = 2 ** -11 * 2 ** -53;
export const FAITHFUL = 0.9 * 2 ** -54;
/** How much larger than both steps together the gap must be. */
const LEAST_GAP = 20;
export const SLACK_G = 13 * 2 ** -53;
export const CONSTANTS = Float64Array.of(
  ROUNDING,
  SMALL,
  FAITHFUL,
  LARGEST_SPREAD,
  LEAST_GAP,
  SLACK_G,
);

export type SolvePass = (lattice: Lattice, out: Answers) => void;

export function solvePass(s: Scratch): SolvePass {
  const { index, A: As, slope: slopes, half: halves, slack, unsettled, count } = s;
  const { wholeNear, wholeFar, g: gs, reach, fNear, fFar, spread, spreadFar } = s;
  return (lattice, { t0, t1 }) => {
    const back = lattice[AT.back] as number;
    const hits = count[HITS] as number;
    let left = count[UNSETTLED] as number;
    const rounding = CONSTANTS[0] as number;
    const small = CONSTANTS[1] as number;
    const faithful = CONSTANTS[2] as number;
    const largest = CONSTANTS[3] as number;
    const leastGap = CONSTANTS[4] as number;
    const slackG = CONSTANTS[5] as number;
    for (let j = 0; j < hits; j++) {
      const a = wholeNear[j] as number;
      const b = wholeFar[j] as number;
      const A = As[j] as number;
      const slope = slopes[j] as number;
      const half = halves[j] as number;
      const g = gs[j] as number;
      const fA = fNear[j] as number;
      const fB = fFar[j] as number;
      const gap = b - a;
      const root = slope + (g * g - A * fA - slope * slope) * half;
      const downA = root - g;
      const downB = root + (g + A * gap);
      const over = 1 / (downA * downB);
      const stepA = fA * (downB * over);
      const stepB = fB * (downA * over);
      const rootA = a + stepA;
      const rootB = b - stepB;
      const liftA = Math.abs(a) + 2;
      const liftB = Math.abs(b) + 2;
      const sizeA = (spread[j] as number) + 1.5 * liftA;
      const sizeB = (spreadFar[j] as number) + 1.5 * liftB;
      const weight = Math.abs(half);
      const loss = (slack[j] as number) + slackG * ((reach[j] as number) * weight);
      const lostA = Math.abs(stepA);
      const lostB = Math.abs(stepB);
      const errorA = weight * (sizeA * (rounding * liftA + small * sizeA));
      const errorB = weight * (sizeB * (rounding * liftB + small * sizeB));
      const settled =
        errorA + loss * lostA <= faithful * Math.abs(rootA) &&
        errorB + loss * lostB <= faithful * Math.abs(rootB) &&
        gap >= leastGap &&
        sizeA < largest &&
        sizeB < largest;
      const i = index[j] as number;
      if (settled) {
        t0[i] = back * rootA;
        t1[i] = back * rootB;
      } else unsettled[left++] = i;
    }
    count[UNSETTLED] = left;
  };
}

import type { Answers } from '../../batch/batch.ts';
import { AT, type Lattice, UNIT_OF_DIRECTION } from './lattice.ts';
import { HITS, type Scratch, UNSETTLED } from './lattice-scratch.ts';

/*
 * Pass 3. At a whole number a the quadratic has the value f and half the slope g = A·a + b, and D = g² − A f whatever a is. So with S = ±√D, of A's sign,
 *
 *   the smaller root is a + fa/(S − g),     the larger one b − fb/(S + g + A(b − a)),
 *
 * and S is had from the rough √D by Newton's step, which squares its error of 2^-29 (pass 1). With w = Am/|A|, R = reach/|S|, the steps δ ≤ 0.51 units and a gap
 * b − a of at least LEAST_GAP units: |A f|/D ≤ 4·0.51·1.03/20 < 0.11, and |g| is between 0.94|S| and 1.06|S|.
 *
 *   S: g² 12.7uR and 1.1u; A f 3u + (3w + 2)u, times 0.11; the difference u; half of all that; the step's roundings 1.5u:   6.4uR + (0.2w + 2.9)u
 *   S − g ≥ 1.94|S|: 6.4uR + 6uR + (0.2w + 2.9)u of |S|, and u:                                                       6.4uR + (0.1w + 2.5)u
 *   S + g + A·gap: the same, and A·gap ≤ 2.12|S| with (3w + 2)u, two roundings:                                       6.4uR + (3.5w + 6)u
 *   each step: f 3u, and four roundings (of one quotient for both, 1/(product of the divisors), in which each divisor cancels):  7u
 *   together                                                                           (6.5R + 4w + 14)u|δ|: SLACK_G, SLACK_A, SLACK
 *   From its own ε: ε/1.94|S|, and through S a fortieth of that:                                                      1.06 ε/(2|S|)
 *   From εa through S into the larger root's step: |A|εa/(2|S|)/(1.94|S|)·|δb|, |A δb| ≤ 0.055|S|:                    0.03 εa/(2|S|): SHARE
 *
 * A root is rounded once: it is faithful, and the root itself where that is a double, if it was off by less than u|t|/2 before, since neighbours of t are
 * at least u|t| apart. FAITHFUL leaves a tenth for evaluating the bound. NaN and what overflows fail the comparisons.
 */
export const ROUNDING = 11 * 2 ** -53 * UNIT_OF_DIRECTION;
export const SMALL = 2 ** -11 * 2 ** -53;
export const FAITHFUL = 0.9 * 2 ** -54;
export const SLACK_G = 13 * 2 ** -53;
export const SHARE = 2 ** -5;
export const CONSTANTS = Float64Array.of(
  ROUNDING,
  SMALL,
  FAITHFUL,
  SLACK_G,
  1.5 * UNIT_OF_DIRECTION,
  SHARE,
);

export type SolvePass = (lattice: Lattice, out: Answers) => void;

export function solvePass(s: Scratch): SolvePass {
  const { index, A: As, slope: slopes, half: halves, slack, unsettled, count } = s;
  const { wholeNear, wholeFar, g: gs, reach, fNear, fFar, spread, spreadFar } = s;
  return (lattice, { t0, t1 }) => {
    const two = lattice[AT.two] as number;
    const largest = lattice[AT.largestSize] as number;
    const leastGap = lattice[AT.leastGap] as number;
    const hits = count[HITS] as number;
    let left = count[UNSETTLED] as number;
    const rounding = CONSTANTS[0] as number;
    const small = CONSTANTS[1] as number;
    const faithful = CONSTANTS[2] as number;
    const slackG = CONSTANTS[3] as number;
    const threeHalves = CONSTANTS[4] as number;
    const share = CONSTANTS[5] as number;
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
      const liftA = Math.abs(a) + two;
      const liftB = Math.abs(b) + two;
      const sizeA = (spread[j] as number) + threeHalves * liftA;
      const sizeB = (spreadFar[j] as number) + threeHalves * liftB;
      const weight = Math.abs(half);
      const loss = (slack[j] as number) + slackG * ((reach[j] as number) * weight);
      const lostA = Math.abs(stepA);
      const lostB = Math.abs(stepB);
      const epsilonA = sizeA * (rounding * liftA + small * sizeA);
      const epsilonB = sizeB * (rounding * liftB + small * sizeB);
      const errorA = weight * epsilonA;
      const errorB = weight * (epsilonB + share * epsilonA);
      const settled =
        errorA + loss * lostA <= faithful * Math.abs(rootA) &&
        errorB + loss * lostB <= faithful * Math.abs(rootB) &&
        gap >= leastGap &&
        sizeA < largest &&
        sizeB < largest;
      const i = index[j] as number;
      if (settled) {
        t0[i] = rootA;
        t1[i] = rootB;
      } else unsettled[left++] = i;
    }
    count[UNSETTLED] = left;
  };
}

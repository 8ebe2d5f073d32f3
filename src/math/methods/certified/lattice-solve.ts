import type { Answers } from '../../batch/batch.ts';
import { AT, type Lattice, ROUND } from './lattice.ts';
import { HITS, type Scratch, UNSETTLED } from './lattice-scratch.ts';

/*
 * Pass 3. The quadratic A(t − ta)(t − tb) is known by A and its values at the whole numbers a and b. With φ = f/A there, gap = b − a, and the
 * steps δa = ta − a, δb = tb − b:
 *
 *   δa + δb = (φa − φb)/gap = sum,     K = gap + sum,     tb − ta = r = √(K² − 4φa),     δa = 2φa/(K + r),     δb = −2φb/(gap − sum + r).
 *
 * The root r is had without a root, by Newton's step r0 + (r² − r0²)/(2r0) from the distance r0 of the rough roots: that is known to 2^-34 (pass 1), so
 * the step is good to 2^-69.
 *
 * Errors of the step, where 32(|δa| + |δb|) ≤ gap, so that K + r > 1.9 gap and K < 1.07 r. With w = Am/|A| and ε the error of f/2 that pass 2
 * states absolutely (εa and εb; its 3u|f/2| are counted below):
 *   φ: f 3u, 1/A from 1/(AD)·D 3u and A's own (3w + 1)u, the product u:                             (3w + 8)u
 *   K + r: sum's error is (3w + 13)u(|δa| + |δb|), below (0.1w + 0.4)u gap; K, r: roundings:        (0.1w + 4)u
 *   the quotient, and what is left over of u²:                                                      2u
 *   together (3.1w + 14)u|δa|.
 *   From εa: 2·2εa/(|A|·1.9 gap) and through K + r 0.14 of εa/(|A|gap):                             2.25 εa/(|A|gap)
 *   From εb, through K + r: 2.2 εb/(|A|gap)·|δa|/gap. The certificate of tb keeps 2.25 εb/(|A|gap) below u|tb|/2, and
 *   |tb|/gap < (|b|/√D + 1)/1.9 with the b of pass 1:                                               (0.3|b|/√D + 0.3)u|δa|
 *
 * In all RESIDUAL_ERROR·ε/(|A|gap) + (SLACK_A w + SLACK_M |b|/(4√D) + SLACK)|δa|, and the same for b. The root a + δa is rounded once: it is
 * faithful, and the root itself where that is a double, if it was off by less than u|t|/2 before, since neighbours of t are at least u|t|
 * apart. FAITHFUL leaves a tenth for evaluating the bound. NaN and what overflows fail the comparisons.
 */
/** Beyond, the whole parts' sums might not be exact: below 2^23.4. */
export const LARGEST_SPREAD = 11e6;
export const RESIDUAL_ERROR = 2.5 * 2 ** -53;
export const ROUNDING = 5;
export const SMALL = 2 ** -13;
export const FAITHFUL = 0.9 * 2 ** -54;
/** How much larger than the steps the gap must be. */
const LEAST_GAP = 32;
export const CONSTANTS = Float64Array.of(
  ROUND,
  RESIDUAL_ERROR,
  ROUNDING,
  SMALL,
  FAITHFUL,
  LARGEST_SPREAD,
  LEAST_GAP,
);

export type SolvePass = (lattice: Lattice, out: Answers) => void;

export function solvePass(s: Scratch): SolvePass {
  const { index, A: As, overA, near, far, overGap, slack, unsettled, count } = s;
  const { fNear, fFar, overAH, spread, spreadFar } = s;
  return (lattice, { t0, t1 }) => {
    const back = lattice[AT.back] as number;
    const hits = count[HITS] as number;
    let left = 0;
    const cut = CONSTANTS[0] as number;
    const residualError = CONSTANTS[1] as number;
    const rounding = CONSTANTS[2] as number;
    const small = CONSTANTS[3] as number;
    const faithful = CONSTANTS[4] as number;
    const largest = CONSTANTS[5] as number;
    const leastGap = CONSTANTS[6] as number;
    for (let j = 0; j < hits; j++) {
      const ta = near[j] as number;
      const tb = far[j] as number;
      const a = ta + cut - cut;
      const b = tb + cut - cut;
      const inverse = overAH[j] as number;
      const over = 2 * (overA[j] as number);
      const phiA = over * (fNear[j] as number);
      const phiB = over * (fFar[j] as number);
      const gap = b - a;
      const sum = (phiA - phiB) * (inverse * (As[j] as number));
      const k = gap + sum;
      const rough = tb - ta;
      const r = rough + (k * k - 4 * phiA - rough * rough) * (overGap[j] as number);
      const stepA = (2 * phiA) / (k + r);
      const stepB = (2 * phiB) / (sum - gap - r);
      const rootA = a + stepA;
      const rootB = b + stepB;
      const liftA = Math.abs(a) + 2;
      const liftB = Math.abs(b) + 2;
      const sizeA = (spread[j] as number) + liftA;
      const sizeB = (spreadFar[j] as number) + liftB;
      const unit = residualError * Math.abs(inverse);
      const loss = slack[j] as number;
      const lostA = Math.abs(stepA);
      const lostB = Math.abs(stepB);
      const errorA = unit * (sizeA * (rounding * liftA + small * sizeA)) + loss * lostA;
      const errorB = unit * (sizeB * (rounding * liftB + small * sizeB)) + loss * lostB;
      const settled =
        errorA <= faithful * Math.abs(rootA) &&
        errorB <= faithful * Math.abs(rootB) &&
        leastGap * (lostA + lostB) <= gap &&
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

import type { Answers } from '../../batch/batch.ts';
import { AT, type Lattice, ROUND } from './lattice.ts';
import { DOUBTS, HITS, type Scratch } from './lattice-scratch.ts';

export const LARGEST_SPREAD = 11e6;
const RESIDUAL_ERROR = 2.5 * 2 ** -53;
export const ROUNDING = 5;
export const SMALL = 2 ** -12;
const FAITHFUL = 0.9 * 2 ** -54;
const CONSTANTS = Float64Array.of(ROUND, RESIDUAL_ERROR, ROUNDING, SMALL, FAITHFUL, LARGEST_SPREAD);

export type SolvePass = (lattice: Lattice, out: Answers) => void;

export function solvePass(s: Scratch): SolvePass {
  const { index, A: As, overA, near, far, overGap, slack, doubtful, count } = s;
  const { fNear, fFar, overAH, spread, spreadFar } = s;
  return (lattice, { t0, t1 }) => {
    const back = lattice[AT.back] as number;
    const hits = count[HITS] as number;
    let doubts = count[DOUBTS] as number;
    const cut = CONSTANTS[0] as number;
    const residualError = CONSTANTS[1] as number;
    const rounding = CONSTANTS[2] as number;
    const small = CONSTANTS[3] as number;
    const faithful = CONSTANTS[4] as number;
    const largest = CONSTANTS[5] as number;
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
      const i = index[j] as number;
      if (
        errorA <= faithful * Math.abs(rootA) &&
        errorB <= faithful * Math.abs(rootB) &&
        32 * (lostA + lostB) <= gap &&
        sizeA < largest &&
        sizeB < largest
      ) {
        t0[i] = back * rootA;
        t1[i] = back * rootB;
      } else doubtful[doubts++] = i;
    }
    count[DOUBTS] = doubts;
  };
}

import type { Answers, Rays } from '../../batch/batch.ts';
import type { Lattice } from './lattice.ts';
import { coarseInSpace } from './lattice-coarse.ts';
import { coarseAroundAxis } from './lattice-coarse-axis.ts';
import { residualsAroundAxis, residualsInSpace } from './lattice-residual.ts';
import { createScratch } from './lattice-scratch.ts';
import { solvePass } from './lattice-solve.ts';

const scratch = createScratch();
const coarse = [coarseAroundAxis(scratch), coarseInSpace(scratch)] as const;
const residuals = [residualsAroundAxis(scratch), residualsInSpace(scratch)] as const;
const solve = solvePass(scratch);

export const { doubtful, unsettled, count } = scratch;

/** Both roots of rays `from` to `to`, but for count[DOUBTS] `doubtful` and count[UNSETTLED] `unsettled` ones. */
export function ordinaryRoots(
  lattice: Lattice,
  hasY: boolean,
  rays: Rays,
  out: Answers,
  from: number,
  to: number,
): void {
  const form = hasY ? 1 : 0;
  coarse[form](lattice, rays, out, from, to);
  residuals[form](lattice);
  solve(lattice, out);
}

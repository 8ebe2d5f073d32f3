import { moduleOf } from '../../../wasm/module.ts';
import { type Loop, loopOf } from '../../../wasm/source.ts';
import { AT } from '../lattice.ts';
import { BOUNDS as COARSE } from '../lattice-bounds.ts';
import inSpace from '../lattice-coarse.ts?raw';
import aroundAxis from '../lattice-coarse-axis.ts?raw';
import residual from '../lattice-residual.ts?raw';
import { CONSTANTS as SOLVE } from '../lattice-solve.ts';
import solve from '../lattice-solve.ts?raw';
import { BOUNDS as RECENTRED } from '../recentred.ts';
import recentredAxis from '../recentred-axis.ts?raw';
import recentredSpace from '../recentred-space.ts?raw';
import { BOUNDS as REFINED } from '../refined.ts';
import refined from '../refined.ts?raw';
import { AT_SCALED } from '../scaled-quadric.ts';
import { blockKernel } from './block-kernel.ts';
import { LATTICE_NUMBERS, PAGES, SCALED_NUMBERS } from './layout.ts';
import { listKernel } from './list-kernel.ts';
import type { Numbers } from './prologue.ts';

const lattice = (key: string): number => LATTICE_NUMBERS + 8 * AT[key as keyof typeof AT];
const scaled = (key: string): number =>
  SCALED_NUMBERS + 8 * AT_SCALED[key as keyof typeof AT_SCALED];

const numbersOf = (known: Numbers['known']): Numbers => ({
  inMemory: { lattice, numbers: scaled },
  known,
});

/** What the three passes over ordinary rays take their bounds from. */
const PASSES = [COARSE, [], SOLVE].map((bounds) =>
  numbersOf({ BOUNDS: bounds, CONSTANTS: bounds }),
);

/** The kernels, compiled from the text of the loops in TypeScript: without y and with it. */
export function certifiedModule(): Uint8Array {
  return moduleOf(
    [false, true].flatMap((hasY) => {
      const ordinary: readonly [Loop, Loop, Loop] = [
        hasY
          ? loopOf(inSpace, 'coarseInSpace', hasY)
          : loopOf(aroundAxis, 'coarseAroundAxis', hasY),
        loopOf(residual, hasY ? 'residualsInSpace' : 'residualsAroundAxis', hasY),
        loopOf(solve, 'solvePass', hasY),
      ];
      const far = hasY
        ? loopOf(recentredSpace, 'recentredInSpace', hasY)
        : loopOf(recentredAxis, 'recentredAroundAxis', hasY);
      return [
        blockKernel(`ordinary${hasY}`, PASSES, ordinary),
        listKernel(`recentred${hasY}`, numbersOf({ BOUNDS: RECENTRED }), far, {
          settled: ['clear', 'settled'],
          missed: 'missed',
          early: null,
        }),
        listKernel(
          `refined${hasY}`,
          numbersOf({ BOUNDS: REFINED }),
          loopOf(refined, 'refine', hasY),
          {
            settled: ['clear', 'settled'],
            missed: null,
            early: 'clear',
          },
        ),
      ];
    }),
    PAGES,
  );
}

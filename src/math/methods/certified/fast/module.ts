import { IMPORT, PAGES } from '../../../batch/simd-memory.ts';
import { type Func, moduleOf } from '../../../wasm/module.ts';
import { elementOf, loopOf } from '../../../wasm/source.ts';
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
import refined from '../refined-roots.ts?raw';
import { AT_SCALED } from '../scaled-quadric.ts';
import { blockKernel } from './block-kernel.ts';
import { LATTICE_NUMBERS, SCALED_NUMBERS } from './layout.ts';
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

/** Where the parts end, found by measuring. */
const CUTS = [
  ['missed', 0],
  [elementOf('slack'), 0],
  [elementOf('spreadFar'), 1],
  ['downB', 2],
] as const;
const RECENTRED_CUTS = ['t', 'gridQ', 'b', 'clear'];
const REFINED_CUTS = ['clear', 'half', 'fa', 'fb'];

/** The kernels, compiled from the text of the loops in TypeScript: without y and with it. */
export const certifiedModule = (): Uint8Array =>
  moduleOf([...kernelsOf(false), ...kernelsOf(true)], { ...IMPORT, pages: PAGES });

function kernelsOf(hasY: boolean): Func[] {
  const rough = hasY
    ? loopOf(inSpace, 'coarseInSpace', hasY)
    : loopOf(aroundAxis, 'coarseAroundAxis', hasY);
  const values = loopOf(residual, hasY ? 'residualsInSpace' : 'residualsAroundAxis', hasY);
  const far = hasY
    ? loopOf(recentredSpace, 'recentredInSpace', hasY)
    : loopOf(recentredAxis, 'recentredAroundAxis', hasY);
  return [
    blockKernel(`ordinary${hasY}`, PASSES, [rough, values, loopOf(solve, 'solvePass', hasY)], CUTS),
    listKernel(
      `recentred${hasY}`,
      numbersOf({ BOUNDS: RECENTRED }),
      far,
      { clear: 'clear', settled: 'settled', missed: 'missed' },
      RECENTRED_CUTS,
    ),
    listKernel(
      `refined${hasY}`,
      numbersOf({ BOUNDS: REFINED }),
      loopOf(refined, 'refine', hasY),
      { clear: 'clear', settled: 'settled', missed: null },
      REFINED_CUTS,
    ),
  ];
}

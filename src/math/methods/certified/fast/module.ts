import { IMPORT, PAGES } from '../../../batch/simd-memory.ts';
import { type Func, moduleOf } from '../../../wasm/module.ts';
import { elementOf, loopOf } from '../../../wasm/source.ts';
import { AT_LATTICE, AT_SCALED } from '../quadric-numbers.ts';
import { RECENTRED_BOUNDS as RECENTRED } from '../recentred.ts';
import recentredAxis from '../recentred.ts?raw';
import recentredSpace from '../recentred.ts?raw';
import { REFINED_BOUNDS as REFINED } from '../refined.ts';
import refined from '../refined.ts?raw';
import { SOLVE_BOUNDS as SOLVE } from '../units-roots.ts';
import residual from '../units-roots.ts?raw';
import solve from '../units-roots.ts?raw';
import { ROUGH_BOUNDS as COARSE } from '../units-rough.ts';
import inSpace from '../units-rough.ts?raw';
import aroundAxis from '../units-rough.ts?raw';
import { blockKernel } from './block-kernel.ts';
import { LATTICE_NUMBERS, SCALED_NUMBERS } from './layout.ts';
import { listKernel } from './list-kernel.ts';
import type { Numbers } from './prologue.ts';

const lattice = (key: string): number =>
  LATTICE_NUMBERS + 8 * AT_LATTICE[key as keyof typeof AT_LATTICE];
const scaled = (key: string): number =>
  SCALED_NUMBERS + 8 * AT_SCALED[key as keyof typeof AT_SCALED];

const numbersOf = (known: Numbers['known']): Numbers => ({
  inMemory: { lattice, numbers: scaled },
  known,
});

/** What the three passes over ordinary rays take their bounds from. */
const PASSES = [{ ROUGH_BOUNDS: COARSE }, {}, { SOLVE_BOUNDS: SOLVE }].map(numbersOf);

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
      numbersOf({ RECENTRED_BOUNDS: RECENTRED }),
      far,
      { clear: 'clear', settled: 'settled', missed: 'missed' },
      RECENTRED_CUTS,
    ),
    listKernel(
      `refined${hasY}`,
      numbersOf({ REFINED_BOUNDS: REFINED }),
      loopOf(refined, 'refine', hasY),
      { clear: 'clear', settled: 'settled', missed: null },
      REFINED_CUTS,
    ),
  ];
}

import { readFileSync } from 'node:fs';
import { IMPORT, PAGES } from '../../../src/math/batch/simd-memory.ts';
import { AT_CLASS, CLASS_BOUNDS } from '../../../src/math/methods/certified/class.ts';
import {
  AT_SURFACE,
  AT_SURFACE_BOUND,
  SURFACE_BOUNDS,
} from '../../../src/math/methods/certified/from-surface.ts';
import { AT_LATTICE, AT_SCALED } from '../../../src/math/methods/certified/numbers.ts';
import { AT_RECENTRED, RECENTRED_BOUNDS } from '../../../src/math/methods/certified/recentred.ts';
import { AT_REFINED, REFINED_BOUNDS } from '../../../src/math/methods/certified/refined.ts';
import {
  LATTICE_NUMBERS,
  SCALED_NUMBERS,
  SURFACE_NUMBERS,
} from '../../../src/math/methods/certified/simd.ts';
import {
  AT_ROUGH,
  AT_SOLVE,
  ROUGH_BOUNDS,
  SOLVE_BOUNDS,
} from '../../../src/math/methods/certified/units.ts';
import { type Func, moduleOf } from '../wasm/module.ts';
import { blockKernel } from './block-kernel.ts';
import { classKernel } from './class-kernel.ts';
import { firstKernel } from './first-kernel.ts';
import { listKernel } from './list-kernel.ts';
import { oneRayFile } from './one-ray.ts';
import type { Numbers } from './prologue.ts';
import { elementOf, loopOf, type Source } from './source.ts';

const FOLDER = 'src/math/methods/certified';

/** The stages that have kernels, by file; read from the project's root. */
export function stageSources(): Readonly<Record<Stage, Source>> {
  return Object.fromEntries(
    STAGES.map((stage) => {
      const file = `${FOLDER}/${stage}.ts`;
      return [stage, { file, text: readFileSync(file, 'utf8') }];
    }),
  ) as Record<Stage, Source>;
}
const STAGES = ['class', 'units', 'from-surface', 'recentred', 'refined'] as const;
type Stage = (typeof STAGES)[number];

const lattice = (key: string): number =>
  LATTICE_NUMBERS + 8 * AT_LATTICE[key as keyof typeof AT_LATTICE];
const scaled = (key: string): number =>
  SCALED_NUMBERS + 8 * AT_SCALED[key as keyof typeof AT_SCALED];
const surface = (key: string): number =>
  SURFACE_NUMBERS + 8 * AT_SURFACE[key as keyof typeof AT_SURFACE];

/** A stage's bounds by name. */
const named = (at: Readonly<Record<string, number>>, doubles: readonly number[]) =>
  Object.fromEntries(Object.entries(at).map(([name, k]) => [name, doubles[k] as number]));

const numbersOf = (known: Numbers['known']): Numbers => ({
  inMemory: { lattice, numbers: scaled, surface },
  known,
});

/** What the three passes over ordinary rays take their bounds from. */
export const PASSES = [
  numbersOf({ ROUGH_BOUNDS: named(AT_ROUGH, ROUGH_BOUNDS) }),
  numbersOf({}),
  numbersOf({ SOLVE_BOUNDS: named(AT_SOLVE, SOLVE_BOUNDS) }),
];

/** Of units.ts, around an axis and in space. */
const PASS_NAMES = [
  ['coarseAroundAxis', 'residualsAroundAxis', 'solvePass'],
  ['coarseInSpace', 'residualsInSpace', 'solvePass'],
] as const;

/** Where the parts end, found by measuring. */
const CUTS = [
  ['missed', 0],
  [elementOf('slack'), 0],
  [elementOf('spreadFar'), 1],
  ['downB', 2],
] as const;
const SURFACE_CUTS = ['C', 'bl', 'clear'];
const RECENTRED_CUTS = ['t', 'gridQ', 'b', 'clear'];
const REFINED_CUTS = ['clear', 'half', 'fa', 'fb'];

/**
 * The kernels, compiled from the loops in TypeScript: without y and with it. Throws SyntaxError
 * with file and line for what the compiler does not understand.
 */
export const certifiedModule = (sources = stageSources()): Uint8Array =>
  moduleOf([...kernelsOf(sources, false), ...kernelsOf(sources, true), firstKernel('first')], {
    ...IMPORT,
    pages: PAGES,
  });

/** The passes over ordinary rays as functions of one. */
export const oneRayText = (sources = stageSources()): string =>
  oneRayFile(
    PASSES,
    [false, true].map((hasY) => [
      hasY ? 'oneInSpace' : 'oneAroundAxis',
      PASS_NAMES[hasY ? 1 : 0].map((name) => loopOf(sources.units, name, hasY)),
    ]),
  );

function kernelsOf(sources: Readonly<Record<Stage, Source>>, hasY: boolean): Func[] {
  const read = (stage: Stage, name: string) => loopOf(sources[stage], name, hasY);
  const [rough, values, solve] = PASS_NAMES[hasY ? 1 : 0];
  const start = read('from-surface', hasY ? 'surfaceInSpace' : 'surfaceAroundAxis');
  const far = read('recentred', hasY ? 'recentredInSpace' : 'recentredAroundAxis');
  return [
    classKernel(
      `classes${hasY}`,
      numbersOf({ CLASS_BOUNDS: named(AT_CLASS, CLASS_BOUNDS) }),
      read('class', hasY ? 'classesInSpace' : 'classesAroundAxis'),
    ),
    blockKernel(
      `ordinary${hasY}`,
      PASSES,
      [read('units', rough), read('units', values), read('units', solve)],
      CUTS,
    ),
    listKernel(
      `surface${hasY}`,
      numbersOf({ SURFACE_BOUNDS: named(AT_SURFACE_BOUND, SURFACE_BOUNDS) }),
      start,
      { clear: 'clear', settled: 'settled', missed: null },
      SURFACE_CUTS,
    ),
    listKernel(
      `recentred${hasY}`,
      numbersOf({ RECENTRED_BOUNDS: named(AT_RECENTRED, RECENTRED_BOUNDS) }),
      far,
      { clear: 'clear', settled: 'settled', missed: 'missed' },
      RECENTRED_CUTS,
    ),
    listKernel(
      `refined${hasY}`,
      numbersOf({ REFINED_BOUNDS: named(AT_REFINED, REFINED_BOUNDS) }),
      read('refined', 'refine'),
      { clear: 'clear', settled: 'settled', missed: null },
      REFINED_CUTS,
    ),
  ];
}

/*
 * Which loops there are, by method and kind of shape.
 * Made by `npm run kernels` from the formula trees; not to be edited.
 */
import { LOOPS as textbook32 } from './textbook32.ts';
import { LOOPS as textbook } from './textbook.ts';
import { LOOPS as stable } from './stable.ts';
import { LOOPS as moment } from './moment.ts';
import { LOOPS as compensated } from './compensated.ts';
import { LOOPS as interval } from './interval.ts';
import { ONE_RAY as textbook32One } from './textbook32-one.ts';
import { ONE_RAY as textbookOne } from './textbook-one.ts';
import { ONE_RAY as stableOne } from './stable-one.ts';
import { ONE_RAY as momentOne } from './moment-one.ts';
import { MODULE as textbook32Simd } from './textbook32-simd.ts';
import { MODULE as textbookSimd } from './textbook-simd.ts';
import { MODULE as stableSimd } from './stable-simd.ts';
import { MODULE as momentSimd } from './moment-simd.ts';
import { MODULE as compensatedSimd } from './compensated-simd.ts';
import { MODULE as intervalSimd } from './interval-simd.ts';
import type { Straight } from '../straight-loop.ts';

/** The names of a shape's numbers, in the order in which its loops take them. */
export const NUMBERS: Readonly<Record<string, readonly string[]>> = {
  plane: ['N.0', 'N.1', 'N.2', 'P.0', 'P.1', 'P.2'],
  cylinder: ['r', 'C.0', 'C.1', 'C.2'],
  cone: ['c', 'V.0', 'V.1', 'V.2'],
  hyperboloid: ['a', 'r', 'C.0', 'C.1', 'C.2'],
  circle: ['r', 'N.0', 'N.1', 'N.2', 'C.0', 'C.1', 'C.2'],
  square: ['L', 'N.0', 'N.1', 'N.2', 'P.0', 'P.1', 'P.2'],
  sphere: ['r', 'C.0', 'C.1', 'C.2'],
  paraboloid: ['k', 'V.0', 'V.1', 'V.2'],
};

export const STRAIGHT: Readonly<Record<string, Straight>> = {
  textbook32: {
    simd: textbook32Simd,
    arithmetic: 'float32',
    alone: textbook32One,
    loops: textbook32,
  },
  textbook: {
    simd: textbookSimd,
    arithmetic: 'float64',
    alone: textbookOne,
    loops: textbook,
  },
  stable: {
    simd: stableSimd,
    arithmetic: 'float64',
    alone: stableOne,
    loops: stable,
  },
  moment: {
    simd: momentSimd,
    arithmetic: 'float64',
    alone: momentOne,
    loops: moment,
  },
  compensated: {
    simd: compensatedSimd,
    arithmetic: 'double-double',
    alone: null,
    loops: compensated,
  },
  interval: {
    simd: intervalSimd,
    arithmetic: 'interval',
    alone: null,
    loops: interval,
  },
};

/*
 * Which loops there are, by method and kind of shape.
 * Made by `npm run kernels` from the formula trees; not to be edited.
 */
import * as textbook32 from './textbook32.ts';
import * as textbook from './textbook.ts';
import * as stable from './stable.ts';
import * as moment from './moment.ts';
import * as compensated from './compensated.ts';
import * as interval from './interval.ts';
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
    loops: {
      plane: { both: textbook32.planeBoth, classes: textbook32.planeClasses },
      cylinder: { both: textbook32.cylinderBoth, classes: textbook32.cylinderClasses },
      cone: { both: textbook32.coneBoth, classes: textbook32.coneClasses },
      hyperboloid: { both: textbook32.hyperboloidBoth, classes: textbook32.hyperboloidClasses },
      circle: { both: textbook32.circleBoth, classes: textbook32.circleClasses },
      square: { both: textbook32.squareBoth, classes: textbook32.squareClasses },
      sphere: { both: textbook32.sphereBoth, classes: textbook32.sphereClasses },
      paraboloid: { both: textbook32.paraboloidBoth, classes: textbook32.paraboloidClasses },
    },
  },
  textbook: {
    simd: textbookSimd,
    arithmetic: 'float64',
    alone: textbookOne,
    loops: {
      plane: { both: textbook.planeBoth, classes: textbook.planeClasses },
      cylinder: { both: textbook.cylinderBoth, classes: textbook.cylinderClasses },
      cone: { both: textbook.coneBoth, classes: textbook.coneClasses },
      hyperboloid: { both: textbook.hyperboloidBoth, classes: textbook.hyperboloidClasses },
      circle: { both: textbook.circleBoth, classes: textbook.circleClasses },
      square: { both: textbook.squareBoth, classes: textbook.squareClasses },
      sphere: { both: textbook.sphereBoth, classes: textbook.sphereClasses },
      paraboloid: { both: textbook.paraboloidBoth, classes: textbook.paraboloidClasses },
    },
  },
  stable: {
    simd: stableSimd,
    arithmetic: 'float64',
    alone: stableOne,
    loops: {
      plane: { both: stable.planeBoth, classes: stable.planeClasses },
      cylinder: { both: stable.cylinderBoth, classes: stable.cylinderClasses },
      cone: { both: stable.coneBoth, classes: stable.coneClasses },
      hyperboloid: { both: stable.hyperboloidBoth, classes: stable.hyperboloidClasses },
      circle: { both: stable.circleBoth, classes: stable.circleClasses },
      square: { both: stable.squareBoth, classes: stable.squareClasses },
      sphere: { both: stable.sphereBoth, classes: stable.sphereClasses },
      paraboloid: { both: stable.paraboloidBoth, classes: stable.paraboloidClasses },
    },
  },
  moment: {
    simd: momentSimd,
    arithmetic: 'float64',
    alone: momentOne,
    loops: {
      plane: { both: moment.planeBoth, classes: moment.planeClasses },
      cylinder: { both: moment.cylinderBoth, classes: moment.cylinderClasses },
      cone: { both: moment.coneBoth, classes: moment.coneClasses },
      hyperboloid: { both: moment.hyperboloidBoth, classes: moment.hyperboloidClasses },
      circle: { both: moment.circleBoth, classes: moment.circleClasses },
      square: { both: moment.squareBoth, classes: moment.squareClasses },
      sphere: { both: moment.sphereBoth, classes: moment.sphereClasses },
      paraboloid: { both: moment.paraboloidBoth, classes: moment.paraboloidClasses },
    },
  },
  compensated: {
    simd: compensatedSimd,
    arithmetic: 'double-double',
    alone: null,
    loops: {
      plane: { both: compensated.planeBoth, classes: compensated.planeBoth },
      cylinder: { both: compensated.cylinderBoth, classes: compensated.cylinderBoth },
      cone: { both: compensated.coneBoth, classes: compensated.coneBoth },
      hyperboloid: { both: compensated.hyperboloidBoth, classes: compensated.hyperboloidBoth },
      circle: { both: compensated.circleBoth, classes: compensated.circleBoth },
      square: { both: compensated.squareBoth, classes: compensated.squareBoth },
      sphere: { both: compensated.sphereBoth, classes: compensated.sphereBoth },
      paraboloid: { both: compensated.paraboloidBoth, classes: compensated.paraboloidBoth },
    },
  },
  interval: {
    simd: intervalSimd,
    arithmetic: 'interval',
    alone: null,
    loops: {
      plane: { both: interval.planeBoth, classes: interval.planeBoth },
      cylinder: { both: interval.cylinderBoth, classes: interval.cylinderBoth },
      cone: { both: interval.coneBoth, classes: interval.coneBoth },
      hyperboloid: { both: interval.hyperboloidBoth, classes: interval.hyperboloidBoth },
      circle: { both: interval.circleBoth, classes: interval.circleBoth },
      square: { both: interval.squareBoth, classes: interval.squareBoth },
      sphere: { both: interval.sphereBoth, classes: interval.sphereBoth },
      paraboloid: { both: interval.paraboloidBoth, classes: interval.paraboloidBoth },
    },
  },
};

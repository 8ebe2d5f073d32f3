import { coefficients } from './coefficients.ts';
import { crossing, passing } from './crossing.ts';
import { cut } from './cut.ts';
import type { Exercise } from './define.ts';
import { allDigits, digits } from './digits.ts';
import { discriminant } from './discriminant.ts';
import { effect } from './effect.ts';
import { first } from './first.ts';
import { flat } from './flat.ts';
import { graph } from './graph.ts';
import { method } from './method.ts';
import { allNappes, nappes } from './nappes.ts';
import { normal } from './normal.ts';
import { order } from './order.ts';
import { pixel } from './pixel.ts';
import { point } from './point.ts';
import { roots } from './roots.ts';
import { shadow } from './shadow.ts';
import { side } from './side.ts';
import { linear, parallel, position } from './special.ts';
import { tangent } from './tangent.ts';

/**
 * The newest version of every exercise, easy ones first. A new one is one new file and one word
 * here.
 */
export const EXERCISES: readonly Exercise[] = [
  flat,
  pixel,
  coefficients,
  side,
  discriminant,
  graph,
  roots,
  first,
  cut,
  order,
  point,
  position,
  allNappes,
  normal,
  shadow,
  effect,
  linear,
  passing,
  tangent,
  allDigits,
  method,
];

/**
 * Earlier versions of exercises, for the sets that have them: what a seed poses never changes, so a
 * change of what an exercise draws or asks is a new version of it.
 */
export const EARLIER: readonly Exercise[] = [parallel, nappes, crossing, digits];

export const findExercise = (id: string): Exercise | undefined =>
  EXERCISES.find((one) => one.id === id) ?? EARLIER.find((one) => one.id === id);

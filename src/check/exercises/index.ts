import { coefficients } from './coefficients.ts';
import { crossing } from './crossing.ts';
import type { Exercise } from './define.ts';
import { digits } from './digits.ts';
import { discriminant } from './discriminant.ts';
import { first } from './first.ts';
import { flat } from './flat.ts';
import { nappes } from './nappes.ts';
import { normal } from './normal.ts';
import { point } from './point.ts';
import { roots } from './roots.ts';
import { shadow } from './shadow.ts';
import { linear, parallel } from './special.ts';
import { tangent } from './tangent.ts';

/** Every exercise there is, easy ones first. A new one is one new file and one word here. */
export const EXERCISES: readonly Exercise[] = [
  flat,
  coefficients,
  discriminant,
  roots,
  first,
  point,
  parallel,
  nappes,
  normal,
  shadow,
  linear,
  crossing,
  tangent,
  digits,
];

export const findExercise = (id: string): Exercise | undefined =>
  EXERCISES.find((one) => one.id === id);

import type { Arithmetic } from '../arithmetic/arithmetic.ts';
import { DISCRIMINANT, POINT } from '../formula/common.ts';
import {
  evaluate,
  evaluateTriple,
  type Triple,
  type Values,
  withScalars,
  withVector,
} from '../formula/evaluate.ts';
import { scalar } from '../formula/expr.ts';
import type { CurvedFormula } from '../shapes/axial-quadric.ts';
import { type FlatFormula, whichHold, withPoint } from '../shapes/planar.ts';

/** Where a line meets a figure's plane, and which of the figure's conditions hold there. */
interface Meeting<T> {
  readonly x: Triple<T>;
  readonly holds: readonly (boolean | null)[];
}

/**
 * What decides, and how it is formed from the ray and the shape: one half of a method; the
 * arithmetic and the solver are the other.
 */
export interface Form {
  /** D of a curved shape, whose A, B and C are among the values. */
  discriminant<T>(formula: CurvedFormula, values: Values<T>, ar: Arithmetic<T>): T;
  /** For N·d ≠ 0; t and rate = N·d are among the values. */
  meeting<T>(formula: FlatFormula, values: Values<T>, ar: Arithmetic<T>): Meeting<T>;
}

/** The course's own: D = B² − 4AC, and X = E + t d put into the figure's conditions. */
export const courseForm: Form = {
  discriminant: (_, values, ar) => evaluate(DISCRIMINANT, ar, values),
  meeting({ bound }, values, ar) {
    const x = evaluateTriple(POINT, ar, values);
    return { x, holds: bound ? whichHold(bound.conditions, withPoint(values, x), ar) : [] };
  },
};

/**
 * By the ray's moment m = d × (E − C), in which the distance from which the ray comes cancels
 * before anything is rounded.
 */
export const momentForm: Form = {
  discriminant({ moment, momentD }, values, ar) {
    return evaluate(momentD, ar, withVector(values, 'm', evaluateTriple(moment, ar, values)));
  },
  meeting({ byMoment, bound }, values, ar) {
    const rate = evaluate(scalar('rate'), ar, values);
    const m = evaluateTriple(byMoment.m, ar, values);
    const w = evaluateTriple(byMoment.w, ar, withVector(values, 'm', m));
    const turned = ar.sign(rate) < 0;
    const at = withVector(
      withScalars(values, { rate: turned ? ar.neg(rate) : rate }),
      'w',
      turned ? [ar.neg(w[0]), ar.neg(w[1]), ar.neg(w[2])] : w,
    );
    const x = evaluateTriple(byMoment.x, ar, at);
    return { x, holds: bound ? whichHold(bound.momentConditions, at, ar) : [] };
  },
};

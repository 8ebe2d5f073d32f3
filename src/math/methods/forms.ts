import { type Arithmetic, bySign } from '../arithmetic/arithmetic.ts';
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
import { excesses, type FlatFormula, withPoint } from '../shapes/planar.ts';

/** Where a line meets a figure’s plane, and left − right of each of its conditions there. */
interface Meeting<T> {
  readonly x: Triple<T>;
  readonly excesses: readonly T[];
}

/**
 * How a method computes what decides the class from ray and shape: D, or the point in a figure's
 * plane. Its arithmetic and its solver are its other parts.
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
    return { x, excesses: bound ? excesses(bound.conditions, withPoint(values, x), ar) : [] };
  },
};

/**
 * From the ray's moment m = d × (E − C), which is the same for every E on the line: the distance of
 * E from the shape does not enlarge the error of D.
 */
export const momentForm: Form = {
  discriminant({ moment, momentD }, values, ar) {
    return evaluate(momentD, ar, withVector(values, 'm', evaluateTriple(moment, ar, values)));
  },
  meeting<T>({ byMoment, bound }: FlatFormula, values: Values<T>, ar: Arithmetic<T>) {
    const rate = evaluate(scalar('rate'), ar, values);
    const m = evaluateTriple(byMoment.m, ar, values);
    const w = evaluateTriple(byMoment.w, ar, withVector(values, 'm', m));
    const turned = (x: T): T =>
      bySign(
        rate,
        () => ar.neg(x),
        () => x,
        ar,
      );
    const at = withVector(withScalars(values, { rate: turned(rate) }), 'w', [
      turned(w[0]),
      turned(w[1]),
      turned(w[2]),
    ]);
    const x = evaluateTriple(byMoment.x, ar, at);
    return { x, excesses: bound ? excesses(bound.momentConditions, at, ar) : [] };
  },
};

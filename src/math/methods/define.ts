import type { Arithmetic } from '../arithmetic/arithmetic.ts';
import type { Coefficients, Intersection } from '../intersection.ts';
import type { Ray } from '../ray.ts';
import type { Shape } from '../shapes/index.ts';
import type { Form } from './forms.ts';
import type { Solver } from './solvers.ts';

/** Calls `use` with the arithmetic, form and solver of a method, whatever its type of numbers. */
type Parts = <R>(use: <T>(parts: OwnParts<T>) => R) => R;

/** One arithmetic, form and solver. */
export interface OwnParts<T> {
  readonly arithmetic: Arithmetic<T>;
  readonly form: Form;
  readonly solver: Solver;
}

/** A method of the ladder. Its functions expect input that was checked before. */
export interface Method {
  readonly id: string;
  readonly title: string;
  /** What it does in a few words, to stand below its title; absent: `idea` does. */
  readonly hint?: string;
  /** What it does, in one sentence. */
  readonly idea: string;
  /** What it promises, and where the promise ends. */
  readonly promise: string;
  readonly source: string;
  /**
   * What is proven for every finite input: the class is that of exact arithmetic, and each root is
   * the nearest double ('rounded') or one of the two around it ('faithful'). Absent: neither.
   */
  readonly proven?: 'rounded' | 'faithful';
  coefficients(shape: Shape, ray: Ray): Coefficients;
  intersect(shape: Shape, ray: Ray): Intersection;
  /** For tracing its operations one by one (src/lab); absent in a method that walks no trees. */
  readonly parts?: Parts;
}

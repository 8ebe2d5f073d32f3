import type { Ray } from '../math/ray.ts';
import type { Shape } from '../math/shapes/index.ts';
import type { Vec3 } from '../math/vec3.ts';

/** A ray and the shape it is asked about. */
export interface Input {
  readonly shape: Shape;
  readonly ray: Ray;
}

/** A number, a point or normal, or the id of a choice. NaN: the formula has no value there. */
export type Answer = number | Vec3 | string;

/** By quantity: A, B, C, D, case, t1, t2, first, why, t, P, N, N.d, … One that does not exist is absent. */
export type Answers = Readonly<Record<string, Answer>>;

export interface Option {
  readonly id: string;
  readonly title: string;
}

/** One thing that a question asks for. A direction is right at any positive length. */
export interface Field {
  /** The quantity. */
  readonly id: string;
  readonly kind: 'number' | 'triple' | 'direction' | 'choice';
  readonly label: string;
  /** For a choice. */
  readonly options: readonly Option[];
}

const of = (kind: Field['kind'], id: string, label: string, options: readonly Option[]): Field => ({
  id,
  kind,
  label,
  options,
});

export const numberField = (id: string, label = id): Field => of('number', id, label, []);
export const tripleField = (id: string, label = id): Field => of('triple', id, label, []);
export const directionField = (id: string, label = id): Field => of('direction', id, label, []);
export const choiceField = (id: string, label: string, options: readonly Option[]): Field =>
  of('choice', id, label, options);

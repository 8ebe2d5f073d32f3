import type { Surd } from '../math/exact.ts';
import type { Values } from '../math/formula.ts';
import type { Ray, Shape, Vec3 } from '../math/index.ts';

/** A ray and the shape it is asked about. */
export interface Input {
  readonly shape: Shape;
  readonly ray: Ray;
  /**
   * The numbers exactly as they were typed, where those are others than the doubles that store
   * them.
   */
  readonly typed?: Values<Surd> | null;
}

/** A number, a point or normal, or the id of a choice. NaN: the formula has no value there. */
export type Answer = number | Vec3 | string;

/**
 * By quantity, in one vocabulary for questions and own numbers. Curved: A, B, C, D, case, and of
 * the roots t1, t2, P1, P2, N1, N2. Flat: N.d, N.(E-P), place, t1, P1, N1, inside. Of the first
 * visible hit: first, why, t, P, N. One that does not exist is absent.
 */
export type Answers = Readonly<Record<string, Answer>>;

/** A student's answer that says that a quantity does not exist. */
export const ABSENT = 'does not exist';

interface Option {
  readonly id: string;
  readonly title: string;
}

/** One thing that a question asks for. A direction is right at any positive length. */
export interface Field {
  /** The quantity. */
  readonly id: string;
  readonly kind: 'number' | 'triple' | 'direction' | 'choice';
  readonly label: string;
  /** What sentences call it: "N·d", or a choice's label in quotes. */
  readonly name: string;
  /** For a choice. */
  readonly options: readonly Option[];
  /** Whether a dash, or nothing, is an answer: the quantity may not exist. */
  readonly mayBeAbsent: boolean;
}

const of = (
  kind: Field['kind'],
  id: string,
  label: string,
  options: readonly Option[] = [],
): Field => ({
  id,
  kind,
  label,
  name: kind === 'choice' ? `“${label} …”` : label,
  options,
  mayBeAbsent: false,
});

export const numberField = (id: string, label = id): Field => of('number', id, label);
export const tripleField = (id: string, label = id): Field => of('triple', id, label);
export const directionField = (id: string, label = id): Field => of('direction', id, label);
export const choiceField = (id: string, label: string, options: readonly Option[]): Field =>
  of('choice', id, label, options);

export const mayBeAbsent = (field: Field): Field => ({ ...field, mayBeAbsent: true });

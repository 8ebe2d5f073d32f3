import type { Surd } from '../math/exact.ts';
import type { Values } from '../math/formula.ts';
import type { Ray, Shape, Vec3 } from '../math/index.ts';

/** A ray and the shape that it is intersected with. */
export interface Input {
  readonly shape: Shape;
  readonly ray: Ray;
  /** The exact values of the typed numbers, if they differ from the stored doubles. */
  readonly typed?: Values<Surd> | null;
  /** Heights that the shape is kept between, its ends open. */
  readonly between?: readonly [low: number, high: number];
  /** A second surface that the ray goes through. */
  readonly other?: Shape;
}

/** A number, a point or normal, or the id of a choice. NaN: the formula has no value there. */
export type Answer = number | Vec3 | string;

/**
 * Answers by quantity. Curved shapes: A, B, C, D, case, t1, t2, P1, P2, N1, N2. Flat shapes: N.d,
 * N.(E-P), place, t1, P1, N1, inside. First visible hit: first, why, t, P, N. A quantity that does
 * not exist has no entry.
 */
export type Answers = Readonly<Record<string, Answer>>;

/** The answer of a student who says that a quantity does not exist. */
export const ABSENT = 'does not exist';

interface Option {
  readonly id: string;
  readonly title: string;
}

/** One quantity that a question asks for. A direction is right at any positive length. */
export interface Field {
  /** The quantity's name. */
  readonly id: string;
  readonly kind: 'number' | 'triple' | 'direction' | 'choice';
  readonly label: string;
  /** Its name in sentences: "N·d", or a choice's label in quotes. */
  readonly name: string;
  /** The options of a choice; else empty. */
  readonly options: readonly Option[];
  /** Whether the quantity may not exist, so that a dash or an empty box is an answer. */
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

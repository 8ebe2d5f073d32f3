import type { Vec3 } from '../../math/index.ts';
import { colour, number, oneOf, type Reader } from '../reader.ts';
import type { Colour, EffectValues } from '../types.ts';

/*
 * Fields that an effect adds to a scene, to a thing's material or to a light. A field that a scene
 * file leaves out has its default. The reader of files, the editor's forms and the tracer use only
 * what is declared here.
 */

/** What a field is part of. */
export type FieldOwner = 'scene' | 'material' | 'light';

interface Common {
  /** Label in the form, with the effect's name: 'fog density'. */
  readonly label: string;
}

interface NumberField extends Common {
  readonly type: 'number';
  readonly default: number;
  /** Range of valid values. */
  readonly range: readonly [least: number, most: number];
  /** Range of the form's slider, within `range`. */
  readonly slider: readonly [least: number, most: number];
  readonly step: number;
  /** Unit as shown; '' without one. */
  readonly unit: string;
}

interface ColourField extends Common {
  readonly type: 'colour';
  readonly default: Colour;
}

interface ChoiceField<W extends string = string> extends Common {
  readonly type: 'choice';
  readonly default: NoInfer<W>;
  readonly options: readonly (readonly [value: W, words: string])[];
}

export type Field = NumberField | ColourField | ChoiceField;
type Fields = Readonly<Record<string, Field>>;
export type FieldValue = number | string;

/** All fields of one effect at one place. */
export interface FieldSet<
  Id extends string = string,
  P extends FieldOwner = FieldOwner,
  F extends Fields = Fields,
> {
  readonly effect: Id;
  readonly place: P;
  readonly fields: F;
}

/** Keeps the literal types, from which those of the values are derived. */
export const defineFields = <
  const Id extends string,
  const P extends FieldOwner,
  const F extends Fields,
>(
  effect: Id,
  place: P,
  fields: F,
): FieldSet<Id, P, F> => ({ effect, place, fields });

/** A scene, a material or a light. */
export interface Owner {
  readonly effects?: EffectValues;
}

type ValueOf<F extends Field> = F extends NumberField
  ? number
  : F extends ChoiceField<infer W>
    ? W
    : Colour;

/** The owner's values, with defaults for the fields that it leaves out. */
export function valuesOf<F extends Fields>(
  { effect, fields }: FieldSet<string, FieldOwner, F>,
  { effects }: Owner,
): { readonly [K in keyof F]: ValueOf<F[K]> } {
  const given = effects?.[effect];
  const entries = Object.entries(fields).map(([key, field]) => [
    key,
    given?.[key] ?? field.default,
  ]);
  return Object.fromEntries(entries);
}

/**
 * The owner with another value. A default is left out, so that the scene's text is the shortest.
 */
export function withValue<O extends Owner>(
  owner: O,
  { effect, fields }: FieldSet,
  key: string,
  value: FieldValue,
): O {
  const { effects: { [effect]: own = {}, ...others } = {}, ...rest } = owner;
  const { [key]: _, ...kept } = own;
  const set = value === fields[key]?.default ? kept : { ...kept, [key]: value };
  const effects = Object.keys(set).length > 0 ? { ...others, [effect]: set } : others;
  return (Object.keys(effects).length > 0 ? { ...rest, effects } : rest) as O;
}

/** Reads a field's value; throws InvalidInput that quotes it. */
export function readerOf(field: Field): Reader<FieldValue> {
  if (field.type === 'number') return number(...field.range);
  return field.type === 'colour' ? colour : oneOf(field.options.map(([value]) => value));
}

/** All values of an owner by effect and key, for bodies: colours are linear light. */
export type BodyValues = Readonly<Record<string, Readonly<Record<string, number | string | Vec3>>>>;

type BodyValueOf<F extends Field> = F extends ColourField ? Vec3 : ValueOf<F>;

/**
 * Reads an effect's own values from a world, a material or a light. The descriptor passes this
 * function to its body, which does not import the descriptor.
 */
export const bodyValues =
  <F extends Fields>({ effect }: FieldSet<string, FieldOwner, F>) =>
  ({ values }: { readonly values: BodyValues }) =>
    values[effect] as { readonly [K in keyof F]: BodyValueOf<F[K]> };

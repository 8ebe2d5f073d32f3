import type { Vec3 } from '../../math/index.ts';
import { colour, number, oneOf, type Read } from '../reader.ts';
import type { Colour, EffectValues } from '../types.ts';

/*
 * Fields that an effect adds to a scene, to a thing's material or to a light. A field that a scene
 * file leaves out has its default. What is declared here is all that the reader of files, the
 * editor's forms and the tracer know of a field.
 */

/** What a field is part of. */
export type Place = 'scene' | 'material' | 'light';

interface Common {
  /** As the form has it, the effect's name included: 'fog density'. */
  readonly label: string;
}

interface NumberField extends Common {
  readonly type: 'number';
  readonly default: number;
  /** What a file may hold. */
  readonly range: readonly [least: number, most: number];
  /** What the form's slider reaches, within `range`. */
  readonly slider: readonly [least: number, most: number];
  readonly step: number;
  /** '' for a plain number. */
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
  P extends Place = Place,
  F extends Fields = Fields,
> {
  readonly effect: Id;
  readonly place: P;
  readonly fields: F;
}

/** Keeps the literal types, from which those of the values are derived. */
export const defineFields = <
  const Id extends string,
  const P extends Place,
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

/** What the owner says, with the default of each field that it leaves out. */
export function valuesOf<F extends Fields>(
  { effect, fields }: FieldSet<string, Place, F>,
  { effects }: Owner,
): { readonly [K in keyof F]: ValueOf<F[K]> } {
  const given = effects?.[effect];
  const entries = Object.entries(fields).map(([key, field]) => [
    key,
    given?.[key] ?? field.default,
  ]);
  return Object.fromEntries(entries);
}

/** The owner with another value. A default is left out: the scene is the same text as without. */
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

/** Throws InvalidInput in words that quote the value. */
export function readerOf(field: Field): Read<FieldValue> {
  if (field.type === 'number') return number(...field.range);
  return field.type === 'colour' ? colour : oneOf(field.options.map(([value]) => value));
}

/** All values of an owner, by effect and key, as bodies want them: colours are linear light. */
export type BodyValues = Readonly<Record<string, Readonly<Record<string, number | string | Vec3>>>>;

type BodyValueOf<F extends Field> = F extends ColourField ? Vec3 : ValueOf<F>;

/**
 * An effect's own among them, of whatever has them: a world, a look, a light. The descriptor hands
 * this to its body, which therefore need not know the descriptor.
 */
export const bodyValues =
  <F extends Fields>({ effect }: FieldSet<string, Place, F>) =>
  ({ values }: { readonly values: BodyValues }) =>
    values[effect] as { readonly [K in keyof F]: BodyValueOf<F[K]> };

import { type Reader, record } from '../reader.ts';
import type { EffectValues } from '../types.ts';
import {
  type Field,
  type FieldOwner,
  type FieldSet,
  type FieldValue,
  type Owner,
  readerOf,
  valuesOf,
} from './fields.ts';
import { EFFECTS } from './index.ts';

/** The fields that all effects together declare at a place, in the order of the registry. */
export const declaredAt = (place: FieldOwner): readonly FieldSet[] =>
  EFFECTS.flatMap(({ fields }): readonly FieldSet[] => fields).filter((set) => set.place === place);

/** Reads what is under `effects` in a scene, a material or a light. */
export function effectValues(place: FieldOwner): Reader<EffectValues> {
  const sets = declaredAt(place).map(({ effect, fields }) => {
    const keys = Object.entries(fields).map(([key, field]) => [key, readerOf(field)] as const);
    const read = record<Record<string, FieldValue>>(Object.fromEntries(keys), Object.keys(fields));
    return [effect, read] as const;
  });
  return record<EffectValues>(
    Object.fromEntries(sets),
    sets.map(([effect]) => effect),
  );
}

/** A declared field of an owner with its value. */
export interface FieldRow {
  readonly set: FieldSet;
  readonly key: string;
  readonly field: Field;
  readonly value: FieldValue;
}

/** The rows of an owner's form: every field declared for its place, also those at their default. */
export const fieldRows = (place: FieldOwner, owner: Owner): readonly FieldRow[] =>
  declaredAt(place).flatMap((set) => {
    const values = valuesOf(set, owner);
    return Object.entries(set.fields).map(([key, field]) => {
      const value = values[key] ?? field.default;
      return { set, key, field, value };
    });
  });

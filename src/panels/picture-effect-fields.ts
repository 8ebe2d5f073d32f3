import { html, nothing, type TemplateResult } from 'lit';
import { type FieldRow, fieldRows } from '../scene/effects/declared.ts';
import {
  type FieldOwner,
  type FieldValue,
  type Owner,
  withValue,
} from '../scene/effects/fields.ts';
import { choiceField, colourField, numberField } from './picture-fields.ts';

interface Tools {
  /** Sends an edit of the owner, which is applied to it as it is when the edit arrives. */
  readonly send: (edit: <O extends Owner>(now: O) => O) => void;
  /** Why the edit of the owner as drawn is invalid; null if it is valid. */
  readonly check: (edit: <O extends Owner>(now: O) => O) => string | null;
}

/** Controls for the fields that effects declare for a scene, a material or a light. */
export function effectFields(
  place: FieldOwner,
  owner: Owner,
  tools: Tools,
): TemplateResult | typeof nothing {
  const rows = fieldRows(place, owner);
  return rows.length > 0 ? html`${rows.map((row) => control(row, tools))}` : nothing;
}

function control({ set, key, field, value }: FieldRow, { send, check }: Tools): TemplateResult {
  const put =
    (x: FieldValue) =>
    <O extends Owner>(now: O): O =>
      withValue(now, set, key, x);
  const sendValue = (x: FieldValue): void => send(put(x));
  if (field.type === 'number') {
    const { label, unit, slider, step } = field;
    return numberField({
      label: unit === '' ? label : `${label} in ${unit}`,
      value: Number(value),
      range: slider,
      step,
      check: (x) => check(put(x)),
      send: sendValue,
    });
  }
  const simple =
    field.type === 'colour'
      ? colourField(field.label, String(value), sendValue)
      : choiceField(field.label, field.options, String(value), sendValue);
  return html`<div class="field-line">${simple}</div>`;
}

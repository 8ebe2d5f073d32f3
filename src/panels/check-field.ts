import { html, nothing, type TemplateResult } from 'lit';
import type { Field } from '../check/types.ts';

export interface FieldView {
  readonly field: Field;
  /** Unique on the page. */
  readonly id: string;
  readonly text: string;
  /** The verdict in a word; '' before the answer was judged. */
  readonly mark: string;
  /** Glyph beside the word. */
  readonly glyph: '' | '=' | '≠' | '?' | '→' | '≈';
  readonly invalid: boolean;
  readonly onText: (text: string) => void;
}

const PLACEHOLDERS: Readonly<Record<Field['kind'], string>> = {
  number: '',
  triple: 'x, y, z',
  direction: 'x, y, z',
  choice: '',
};

/** A labelled box or choice, with its mark behind it. */
export function fieldRow(view: FieldView): TemplateResult {
  const { field, id, mark, glyph } = view;
  return html`<div class="answer" data-field=${field.id} data-kind=${field.kind}>
    <label for=${id}>${field.label}${field.kind === 'choice' ? '' : ' ='}</label>
    ${field.kind === 'choice' ? choice(view) : box(view)}
    <span class="mark" id=${`${id}-mark`} data-mark=${glyph || nothing}>${
      glyph ? html`<span class="glyph" aria-hidden="true">${glyph}</span> ` : nothing
    }${mark}</span>
  </div>`;
}

function box({ field, id, text, invalid, mark, onText }: FieldView): TemplateResult {
  return html`<input
    id=${id}
    class="answer-box"
    type="text"
    autocomplete="off"
    autocapitalize="off"
    spellcheck="false"
    placeholder=${PLACEHOLDERS[field.kind] || nothing}
    .value=${text}
    aria-invalid=${invalid ? 'true' : 'false'}
    aria-describedby=${mark ? `${id}-mark` : nothing}
    @input=${(event: Event) => onText((event.target as HTMLInputElement).value)}
  />`;
}

function choice({ field, id, text, mark, onText }: FieldView): TemplateResult {
  return html`<select
    id=${id}
    class="answer-choice"
    aria-describedby=${mark ? `${id}-mark` : nothing}
    @change=${(event: Event) => onText((event.target as HTMLSelectElement).value)}
  >
    <option value="" ?selected=${text === ''}>choose…</option>
    ${field.options.map(
      ({ id: value, title }) => html`<option value=${value}
      ?selected=${text === value}>${title}</option>`,
    )}
  </select>`;
}

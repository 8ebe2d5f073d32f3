import { html, type TemplateResult } from 'lit';
import { live } from 'lit/directives/live.js';
import type { Vec3 } from '../math/index.ts';
import { AXES, withComponent } from '../math/shapes.ts';
import type { Scene } from '../scene/types.ts';
import '../ui/number-box.ts';
import '../ui/slider.ts';
import './picture-fields.css';

/** Sends an edit, not a scene: the form may have been drawn before the scene was last changed. */
export type ChangeScene = (edit: (now: Scene) => Scene) => void;

interface NumberField {
  readonly label: string;
  readonly value: number;
  readonly range: readonly [number, number];
  readonly step: number;
  readonly check: (value: number) => string | null;
  readonly send: (value: number) => void;
}

/** A label, a box and a slider. */
export function numberField({
  label,
  value,
  range,
  step,
  check,
  send,
}: NumberField): TemplateResult {
  const take = (event: CustomEvent<number>): void => {
    if (check(event.detail) === null) send(event.detail);
  };
  return html`<div class="field" @graze-value=${take}>
    <span class="field-label" aria-hidden="true">${label}</span>
    <graze-number id=${`field-${slug(label)}`} .value=${value} .step=${step} .label=${label}
      .check=${check}></graze-number>
    <graze-slider .value=${value} .least=${range[0]} .most=${range[1]} .step=${step}
      .label=${`${label}, slider`}></graze-slider>
  </div>`;
}

interface TripleField {
  readonly label: string;
  readonly value: Vec3;
  readonly names?: readonly [string, string, string];
  readonly step: number;
  readonly check: (edit: (now: Vec3) => Vec3) => string | null;
  readonly send: (edit: (now: Vec3) => Vec3) => void;
}

/** A label and three boxes; three numbers can be pasted into any of them. */
export function tripleField({
  label,
  value,
  names,
  step,
  check,
  send,
}: TripleField): TemplateResult {
  const put =
    (i: number, x: number) =>
    (now: Vec3): Vec3 =>
      withComponent(now, i, x);
  const take = (edit: (now: Vec3) => Vec3): void => {
    if (check(edit) === null) send(edit);
  };
  return html`<div class="field triple" role="group" aria-label=${label}
    @graze-triple=${(e: CustomEvent<Vec3>) => take(() => e.detail)}>
    <span class="field-label">${label}</span>
    ${AXES.map((axis, i) => {
      const name = `${label}, ${names?.[i] ?? axis}`;
      return html`<span class="field-part"
        @graze-value=${(e: CustomEvent<number>) => take(put(i, e.detail))}>
        <span class="axis" aria-hidden="true">${names?.[i] ?? axis}</span>
        <graze-number id=${`field-${slug(name)}`} .value=${value[i] ?? 0} .step=${step}
          .label=${name} .check=${(x: number) => check(put(i, x))}></graze-number>
      </span>`;
    })}
  </div>`;
}

export function colourField(
  label: string,
  value: string,
  send: (value: string) => void,
): TemplateResult {
  return html`<label class="field-colour"><input type="color" .value=${value}
    @input=${(e: Event) => send((e.target as HTMLInputElement).value)} /> ${label}</label>`;
}

export function checkField(
  label: string,
  value: boolean,
  send: (value: boolean) => void,
): TemplateResult {
  return html`<label class="field-check"><input type="checkbox" .checked=${live(value)}
    @change=${(e: Event) => send((e.target as HTMLInputElement).checked)} /> ${label}</label>`;
}

export function choiceField<W extends string>(
  label: string,
  options: readonly (readonly [value: W, words: string])[],
  value: W,
  send: (value: W) => void,
): TemplateResult {
  return html`<label class="field-choice">${label}
    <select @change=${(e: Event) => send((e.target as HTMLSelectElement).value as W)}>
      ${options.map(
        ([id, words]) => html`<option value=${id}
        ?selected=${id === value}>${words}</option>`,
      )}
    </select></label>`;
}

const slug = (label: string): string => label.replace(/\W+/g, '-');

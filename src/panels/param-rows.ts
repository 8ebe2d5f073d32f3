import { html, nothing, type TemplateResult } from 'lit';
import { guard } from 'lit/directives/guard.js';
import { InvalidInput, type Vec3 } from '../math/index.ts';
import {
  AXES,
  type AxisParam,
  checkParam,
  type NumberParam,
  type Param,
  type VectorParam,
  withComponent,
} from '../math/shapes.ts';
import '../ui/number-box.ts';
import '../ui/slider.ts';
import { textsOf } from '../ui/typed-event.ts';
import { symbol } from './formula.ts';
import type { Handle } from './params-of.ts';
import { classOf } from './symbols.ts';
import './param-rows.css';

/** The math module's message on an invalid value of a parameter; null if it is valid. */
function refusal(param: Param, candidate: unknown): string | null {
  try {
    checkParam(param, candidate);
    return null;
  } catch (error) {
    if (error instanceof InvalidInput) return error.message;
    throw error;
  }
}

/**
 * The row of a parameter of any type. It is rendered again only if its value or typed text changes:
 * its actions are edits, which use the state at the time when they arrive.
 */
export function paramRow(handle: Handle): unknown {
  const { param, value, typed, quantities, locked } = handle;
  const texts = param.type === 'vector' ? AXES.map((axis) => typed(`${param.symbol}.${axis}`)) : [];
  const text = param.type === 'number' ? typed(param.symbol) : '';
  return guard([param, value, quantities, locked, text, ...texts], () => row(handle));
}

function row(handle: Handle): TemplateResult {
  const { param } = handle;
  if (param.type === 'vector') return vectorRow(handle, param);
  return param.type === 'number' ? numberCell(handle, param) : axisCell(handle, param);
}

function vectorRow(
  { value, send, typed, reset, quantities, locked }: Handle,
  param: VectorParam,
): TemplateResult {
  const current = value as Vec3;
  const { symbol: letter, title, range, step, initial } = param;
  const cls = classOf(letter, 'vector');
  const triple = (event: CustomEvent<Vec3>): void => {
    if (refusal(param, event.detail) !== null) return;
    const texts = textsOf(event).map((text, i) => [`${letter}.${AXES[i]}`, text] as const);
    send(event.detail, Object.fromEntries(texts));
  };
  return html`<div class="param ${cls}" role="group" aria-label=${`${letter}, ${title}`}
    data-symbol=${letter} @graze-triple=${triple}>
    <span class="letter">${symbol(letter, null, cls, letter)}</span>
    ${AXES.map((axis, i) => {
      const label = `${letter}.${axis}`;
      const sendOne = (e: CustomEvent<number>): void =>
        send((now) => withComponent(now as Vec3, i, e.detail), typedAs(label, e));
      return html`<span class="cell" @graze-value=${sendOne}>
        <span class="axis" aria-hidden="true">${axis}</span>
        <graze-number
          id=${`box-${label}`}
          .value=${current[i] ?? 0}
          .step=${step}
          .label=${label}
          .symbol=${label}
          .locked=${locked}
          .typed=${typed(label)}
          .quantity=${quantities ? label : ''}
          .check=${(x: number) => refusal(param, withComponent(current, i, x))}
        ></graze-number>
        <graze-slider
          .value=${current[i] ?? 0}
          .least=${range[0]}
          .most=${range[1]}
          .step=${step}
          .label=${`${label}, slider`}
          .symbol=${label}
          .locked=${locked}
        ></graze-slider>
      </span>`;
    })}
    ${AXES.map((axis) => playButton(`${letter}.${axis}`, locked))}
    ${resetButton(letter, locked || equal(current, initial), reset)}
  </div>`;
}

function numberCell(
  { value, send: put, typed, reset, locked }: Handle,
  param: NumberParam,
): TemplateResult {
  const current = value as number;
  const { symbol: letter, title, range, step, initial } = param;
  const cls = classOf(letter, 'scalar');
  const send = (event: CustomEvent<number>): void => put(event.detail, typedAs(letter, event));
  return html`<div class="param single ${cls}" role="group" aria-label=${`${letter}, ${title}`}
    data-symbol=${letter} @graze-value=${send}>
    <span class="letter">${symbol(letter, null, cls, letter)}</span>
    <span class="cell">
      <graze-number
        id=${`box-${letter}`}
        .value=${current}
        .step=${step}
        .label=${`${letter}, ${title}`}
        .symbol=${letter}
        .locked=${locked}
        .typed=${typed(letter)}
        .quantity=${letter}
        .check=${(x: number) => refusal(param, x)}
      ></graze-number>
      <graze-slider
        .value=${current}
        .least=${range[0]}
        .most=${range[1]}
        .step=${step}
        .label=${`${letter}, slider`}
        .symbol=${letter}
        .locked=${locked}
      ></graze-slider>
    </span>
    ${playButton(letter, locked)}
    ${resetButton(letter, locked || current === initial, reset)}
  </div>`;
}

function axisCell(
  { value, send, reset, locked }: Handle,
  { title, initial }: AxisParam,
): TemplateResult {
  const current = String(value);
  return html`<div class="param single axis-param" role="group" aria-label=${title}>
    <span class="axis-title">normal along</span>
    <span class="choices" data-quantity="axis" data-value=${current}>${AXES.map(
      (axis) => html`<button
        type="button"
        class="choice"
        aria-pressed=${axis === current}
        ?disabled=${locked}
        @click=${() => send(axis)}
      >${axis}</button>`,
    )}</span>
    ${resetButton('axis', locked || current === initial, reset)}
  </div>`;
}

/** The typed text of an event with one number, under its label. */
function typedAs(label: string, event: Event): Readonly<Record<string, string>> {
  const [text] = textsOf(event);
  return text === undefined ? {} : { [label]: text };
}

function equal(a: Vec3, b: Vec3): boolean {
  return a.every((x, i) => Object.is(x, b[i]));
}

function resetButton(letter: string, resting: boolean, reset: () => void): TemplateResult {
  return html`<button
    type="button"
    class="reset"
    aria-label=${`Reset ${letter}`}
    title=${`Reset ${letter}`}
    aria-disabled=${resting}
    @click=${reset}
  ><svg viewBox="0 0 16 16" width="14" height="14" aria-hidden="true"><path
    d="M3.2 6.6A5 5 0 1 1 3.4 9.8M3 3.2v3.6h3.6" /></svg></button>`;
}

const playButton = (label: string, locked: boolean): unknown =>
  locked ? nothing : html`<graze-play label=${label}></graze-play>`;

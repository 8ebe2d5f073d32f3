import { html, mathml, nothing, type TemplateResult } from 'lit';
import { InvalidInput } from '../math/invalid-input.ts';
import { SHAPES } from '../math/shapes/index.ts';
import { definitionOf } from '../math/shapes/lookup.ts';
import {
  type AxisParam,
  checkParam,
  type NumberParam,
  type Param,
  type VectorParam,
} from '../math/shapes/params.ts';
import { AXES, type Vec3 } from '../math/vec3.ts';
import type { Dispatch } from '../state/actions.ts';
import type { ExploreModel } from '../state/derive.ts';
import { INITIAL, paramValue, RAY_PARAMS } from '../state/state.ts';
import { display } from '../text/format.ts';
import '../ui/number-box.ts';
import '../ui/slider.ts';
import { formula, symbol } from './formula.ts';
import { classOf } from './symbols.ts';
import { typesetRelation } from './typeset.ts';
import { value } from './value.ts';
import './controls.css';

/** The row of shapes: picking one keeps the ray. */
export function shapePicker({ state }: ExploreModel, dispatch: Dispatch): TemplateResult {
  return html`<div class="shapes" role="group" aria-label="Shape">
    ${SHAPES.map(
      ({ kind, title, icon }) => html`<button
        type="button"
        class="shape-choice"
        aria-pressed=${kind === state.kind}
        @click=${() => dispatch({ type: 'shape', kind })}
      ><svg viewBox="0 0 24 24" width="26" height="26" aria-hidden="true"><path d=${icon} /></svg><span>${title}</span></button>`,
    )}
  </div>`;
}

/** Sliders, boxes and resets for the ray and for whatever the shape declares. */
export function controls(model: ExploreModel, dispatch: Dispatch): TemplateResult {
  const { state, shape, title, meaning, derivation } = model;
  const { params } = definitionOf(shape);
  const vectors = params.filter((p): p is VectorParam => p.type === 'vector');
  const short = params.filter((p): p is NumberParam | AxisParam => p.type !== 'vector');
  const E = vectorRow(RAY_PARAMS.E, state.E, (v) => dispatch({ type: 'origin', value: v }), {
    reset: () => dispatch({ type: 'reset', what: 'E' }),
    quantities: true,
  });
  const d = vectorRow(RAY_PARAMS.d, state.d, (v) => dispatch({ type: 'direction', value: v }), {
    reset: () => dispatch({ type: 'reset', what: 'd' }),
    quantities: !state.unit,
  });
  return html`<section class="controls" aria-label="Parameters">
    ${rayHeader(model, dispatch)} ${E} ${d}
    <div class="group">
      <h2>${title}</h2>
      ${formula(typesetRelation(derivation.surface))}
      <span class="meaning">${meaning}</span>
    </div>
    ${vectors.map((param) =>
      vectorRow(
        param,
        paramValue(shape, param.key) as Vec3,
        (v) => dispatch({ type: 'param', key: param.key, value: v }),
        { reset: () => dispatch({ type: 'reset', what: { param: param.key } }), quantities: true },
      ),
    )}
    <div class="short-params" data-count=${short.length}>
      ${short.map((param) =>
        param.type === 'number'
          ? numberCell(param, paramValue(shape, param.key) as number, dispatch)
          : axisCell(param, String(paramValue(shape, param.key)), dispatch),
      )}
    </div>
  </section>`;
}

function rayHeader({ state, ray }: ExploreModel, dispatch: Dispatch): TemplateResult {
  const length = Math.hypot(...state.d);
  const R = mathml`<mi>R</mi><mo stretchy="false">(</mo><mi>t</mi><mo stretchy="false">)</mo><mo>=</mo><mi class="sym sym-E" data-symbol="E">E</mi><mo>+</mo><mi>t</mi><mi class="sym sym-d" data-symbol="d">d</mi>`;
  return html`<div class="group">
    <h2>Ray</h2>
    ${formula(R)}
    ${
      state.unit
        ? html`<span class="unit-d">(${AXES.map((axis, i) => html`${i > 0 ? ', ' : nothing}${value(`d.${axis}`, ray.direction[i] ?? 0, 4)}`)})</span>`
        : nothing
    }
    <label class="unit"><input
      type="checkbox"
      .checked=${state.unit}
      @change=${(event: Event) => dispatch({ type: 'unit', on: (event.target as HTMLInputElement).checked })}
    />unit ${symbol('d', null, 'sym sym-d', 'd')}</label>
    ${
      state.unit
        ? nothing
        : html`<span class="length">${formula(mathml`<mo fence="true" stretchy="false">|</mo><mi class="sym sym-d" data-symbol="d">d</mi><mo fence="true" stretchy="false">|</mo><mo>=</mo><mn>${display(length, 4)}</mn>`)}</span>`
    }
  </div>`;
}

/** Why a value is not allowed for a parameter, in the math module's own words; null if it is. */
function refusal(param: Param, candidate: unknown): string | null {
  try {
    checkParam(param, candidate);
    return null;
  } catch (error) {
    if (error instanceof InvalidInput) return error.message;
    throw error;
  }
}

interface RowOptions {
  readonly reset: () => void;
  /** Whether the boxes carry the quantities; with a unit d the kernel's own d is told elsewhere. */
  readonly quantities: boolean;
}

function vectorRow(
  param: VectorParam,
  current: Vec3,
  send: (v: Vec3) => void,
  { reset, quantities }: RowOptions,
): TemplateResult {
  const { symbol: letter, title, range, step, initial } = param;
  const cls = classOf(letter, 'vector');
  const triple = (event: CustomEvent<Vec3>): void => {
    if (refusal(param, event.detail) === null) send(event.detail);
  };
  return html`<div class="param ${cls}" role="group" aria-label=${`${letter}, ${title}`} data-symbol=${letter} @graze-triple=${triple}>
    <span class="letter">${symbol(letter, null, cls, letter)}</span>
    ${AXES.map((axis, i) => {
      const put = (x: number): Vec3 =>
        current.map((old, k) => (k === i ? x : old)) as unknown as Vec3;
      const label = `${letter}.${axis}`;
      return html`<span class="cell" @graze-value=${(e: CustomEvent<number>) => send(put(e.detail))}>
        <span class="axis" aria-hidden="true">${axis}</span>
        <graze-number
          id=${`box-${label}`}
          .value=${current[i] ?? 0}
          .step=${step}
          .label=${label}
          .symbol=${label}
          .quantity=${quantities ? label : ''}
          .check=${(x: number) => refusal(param, put(x))}
        ></graze-number>
        <graze-slider
          .value=${current[i] ?? 0}
          .least=${range[0]}
          .most=${range[1]}
          .step=${step}
          .label=${`${label}, slider`}
          .symbol=${label}
        ></graze-slider>
      </span>`;
    })}
    ${resetButton(letter, equal(current, initial), reset)}
  </div>`;
}

function numberCell(param: NumberParam, current: number, dispatch: Dispatch): TemplateResult {
  const { symbol: letter, title, key, range, step, initial } = param;
  const cls = classOf(letter, 'scalar');
  const send = (event: CustomEvent<number>): void =>
    dispatch({ type: 'param', key, value: event.detail });
  return html`<div class="param single ${cls}" role="group" aria-label=${`${letter}, ${title}`} data-symbol=${letter} @graze-value=${send}>
    <span class="letter">${symbol(letter, null, cls, letter)}</span>
    <span class="cell">
      <graze-number
        id=${`box-${letter}`}
        .value=${current}
        .step=${step}
        .label=${`${letter}, ${title}`}
        .symbol=${letter}
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
      ></graze-slider>
    </span>
    ${resetButton(letter, current === initial, () => dispatch({ type: 'reset', what: { param: key } }))}
  </div>`;
}

function axisCell(param: AxisParam, current: string, dispatch: Dispatch): TemplateResult {
  const { key, title, initial } = param;
  return html`<div class="param single axis-param" role="group" aria-label=${title}>
    <span class="axis-title">normal along</span>
    <span class="choices" data-quantity="axis" data-value=${current}>${AXES.map(
      (axis) => html`<button
        type="button"
        class="choice"
        aria-pressed=${axis === current}
        @click=${() => dispatch({ type: 'param', key, value: axis })}
      >${axis}</button>`,
    )}</span>
    ${resetButton('axis', current === initial, () => dispatch({ type: 'reset', what: { param: key } }))}
  </div>`;
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
  ><svg viewBox="0 0 16 16" width="14" height="14" aria-hidden="true"><path d="M3.2 6.6A5 5 0 1 1 3.4 9.8M3 3.2v3.6h3.6" /></svg></button>`;
}

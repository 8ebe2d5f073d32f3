import { html, mathml, nothing, type TemplateResult } from 'lit';
import { guard } from 'lit/directives/guard.js';
import { AXES } from '../math/shapes.ts';
import type { Dispatch } from '../state/actions.ts';
import type { ExploreModel } from '../state/derive.ts';
import { display } from '../text/format.ts';
import { formula, symbol } from './formula.ts';
import { paramRow } from './param-rows.ts';
import { rayHandles, shapeHandles } from './params-of.ts';
import { typesetRelation } from './typeset.ts';
import { value } from './value.ts';
import './controls.css';

type Control = (model: ExploreModel, dispatch: Dispatch) => unknown;

/** Controls for the ends of a shape, whose code is loaded late. */
export interface EndsControls {
  readonly endsSwitch: Control;
  readonly endsRow: Control;
}

/** Sliders, boxes and resets for the ray and the shape's parameters. */
export function controls(
  model: ExploreModel,
  dispatch: Dispatch,
  ends: EndsControls | null,
): TemplateResult {
  const { title, meaning, derivation } = model;
  const own = shapeHandles(model, dispatch);
  const vectors = own.filter(({ param }) => param.type === 'vector');
  const short = own.filter(({ param }) => param.type !== 'vector');
  return html`<section class="controls" aria-label="Parameters">
    ${rayHeader(model, dispatch)} ${rayHandles(model, dispatch).map(paramRow)}
    <div class="group surface">
      <h2>${title}</h2>
      ${guard([derivation.surface], () => formula(typesetRelation(derivation.surface)))}
      <span class="meaning">${meaning}</span>
      ${ends?.endsSwitch(model, dispatch)}
    </div>
    ${vectors.map(paramRow)}
    <div class="short-params" data-count=${short.length}>${short.map(paramRow)}</div>
    ${ends?.endsRow(model, dispatch)}
  </section>`;
}

const LINE = mathml`<mi>R</mi><mo stretchy="false">(</mo><mi>t</mi><mo stretchy="false">)</mo><mo
  >=</mo><mi class="sym sym-E" data-symbol="E">E</mi><mo>+</mo><mi>t</mi><mi class="sym sym-d"
  data-symbol="d">d</mi>`;

/** R(t) = E + t d, and the switch for a d of unit length. */
export function rayHeader({ state, ray }: ExploreModel, dispatch: Dispatch): TemplateResult {
  const length = Math.hypot(...state.d);
  const lengthOfD = mathml`<mo form="prefix" stretchy="false">|</mo><mi class="sym sym-d"
    data-symbol="d">d</mi><mo form="postfix" stretchy="false">|</mo><mo>=</mo><mn>${display(
      length,
      4,
    )}</mn>`;
  const components = AXES.map((axis, i) => {
    const shown = value(`d.${axis}`, ray.direction[i] ?? 0, { room: 8 });
    return html`${i > 0 ? ', ' : nothing}${shown}`;
  });
  const setUnit = (event: Event): void =>
    dispatch({ type: 'unit', on: (event.target as HTMLInputElement).checked });
  return html`<div class="group" role="group" aria-label="Ray">
    <h2>Ray</h2>
    ${formula(LINE)}
    ${state.unit ? html`<span class="unit-d">(${components})</span>` : nothing}
    <label class="unit"><input
      type="checkbox"
      .checked=${state.unit}
      ?disabled=${state.lock.includes('d')}
      @change=${setUnit}
    />unit ${symbol('d', null, 'sym sym-d', 'd')}</label>
    ${state.unit ? nothing : html`<span class="length">${formula(lengthOfD)}</span>`}
  </div>`;
}

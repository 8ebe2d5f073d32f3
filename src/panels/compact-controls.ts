import { html, nothing, type TemplateResult } from 'lit';
import type { Vec3 } from '../math/index.ts';
import { AXES } from '../math/shapes.ts';
import type { Dispatch } from '../state/actions.ts';
import type { ExploreModel } from '../state/derive.ts';
import { display, shortest } from '../text/format.ts';
import { type EndsControls, rayHeader } from './controls.ts';
import { formula, symbol } from './formula.ts';
import { paramRow } from './param-rows.ts';
import { type Handle, rayHandles, shapeHandles } from './params-of.ts';
import { classOf } from './symbols.ts';
import { typesetRelation } from './typeset.ts';
import './compact-controls.css';

/** Symbol of the parameter whose sliders are shown, or `ENDS`. */
let open = '';
const ENDS = 'ends';

/**
 * Parameters with their values in one line, and the sliders of one of them: for phones. `changed`
 * asks for another render.
 */
export function compactControls(
  model: ExploreModel,
  dispatch: Dispatch,
  changed: () => void,
  ends: EndsControls | null,
): TemplateResult {
  const handles = [...rayHandles(model, dispatch), ...shapeHandles(model, dispatch)];
  const found = handles.find(({ param }) => param.symbol === open);
  const isEnds = open === ENDS && ends !== null && model.found.details.family === 'curved';
  const current = isEnds ? null : (found ?? handles.at(-1));
  return html`<section class="compact-controls" aria-label="Parameters">
    <div class="tabs" role="group" aria-label="Parameter">
      ${handles.map((handle) =>
        tab(handle, handle === current, () => {
          open = handle.param.symbol;
          changed();
        }),
      )}
      ${
        ends && model.found.details.family === 'curved'
          ? html`<button type="button" class="tab-param" aria-pressed=${isEnds}
              @click=${() => {
                open = ENDS;
                changed();
              }}>ends</button>`
          : nothing
      }
    </div>
    ${
      current
        ? paramRow({ ...current, quantities: false })
        : isEnds
          ? html`${ends.endsSwitch(model, dispatch)}${ends.endsRow(model, dispatch)}`
          : nothing
    }
  </section>`;
}

/** The ray, the surface's equation and its meaning, which `compactControls` leaves out. */
export function equations(model: ExploreModel, dispatch: Dispatch): TemplateResult {
  const { derivation, meaning } = model;
  return html`${rayHeader(model, dispatch)}<p
    class="surface-line">${formula(typesetRelation(derivation.surface))}
    <span class="meaning">${meaning}</span></p>`;
}

function tab(
  { param, value, quantities }: Handle,
  pressed: boolean,
  pick: () => void,
): TemplateResult {
  const { symbol: letter, type } = param;
  const cls = classOf(letter, type === 'vector' ? 'vector' : 'scalar');
  const name =
    type === 'axis'
      ? html`<span class="axis-name">normal</span>`
      : symbol(letter, null, cls, letter);
  return html`<button type="button" class="tab-param ${cls}" aria-pressed=${pressed}
    data-symbol=${letter} @click=${pick}>
    ${name} <span class="tab-value">${shown(value, letter, quantities)}</span>
  </button>`;
}

function shown(value: Handle['value'], letter: string, quantities: boolean): TemplateResult {
  const one = (name: string, x: number | string): TemplateResult => {
    const full = typeof x === 'number' ? shortest(x) : x;
    return html`<span
      data-quantity=${quantities ? name : nothing}
      data-value=${quantities ? full : nothing}
    >${typeof x === 'number' ? display(x, 3) : x}</span>`;
  };
  if (typeof value !== 'object') return one(letter, value);
  const v: Vec3 = value;
  return html`(${AXES.map(
    (axis, i) => html`${i > 0 ? ', ' : nothing}${one(`${letter}.${axis}`, v[i] ?? 0)}`,
  )})`;
}

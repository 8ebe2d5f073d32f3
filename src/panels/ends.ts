import { html, mathml, nothing, type TemplateResult } from 'lit';
import { comp, minus, over, type Relation, scalar } from '../math/formula.ts';
import { AXES } from '../math/shapes.ts';
import type { Dispatch } from '../state/actions.ts';
import type { ExploreModel } from '../state/derive.ts';
import { type CapLine, flatNote } from '../state/ended.ts';
import { CAP_NAMES, END_PARAMS, endAction, endsRefusal, someEnds } from '../state/ends.ts';
import { distinctTexts } from '../state/heights.ts';
import { startOutcomeOf } from '../state/start-outcome.ts';
import { encode } from '../state/url.ts';
import { display, shortest } from '../text/format.ts';
import '../ui/number-box.ts';
import '../ui/slider.ts';
import type { EndsControls } from './controls.ts';
import { formula } from './formula.ts';
import { typesetRelation, typesetSymbols } from './typeset.ts';
import { value } from './value.ts';
import './ends.css';

const checked = (event: Event): boolean => (event.target as HTMLInputElement).checked;

/** Whether a curved shape has ends. */
function endsSwitch({ state, found }: ExploreModel, dispatch: Dispatch): unknown {
  if (found.details.family !== 'curved') return nothing;
  const cut = (event: Event): void =>
    dispatch({
      type: 'ends',
      value: checked(event) ? (now, shape) => now ?? someEnds(shape) : null,
    });
  return html`<label class="finite" title="Keep it between two heights"><input type="checkbox"
    .checked=${state.between !== null} ?disabled=${state.lock.includes('between')}
    @change=${cut} />finite</label>`;
}

/** Where the ends are, and whether discs close the shape there; nothing without ends. */
function endsRow({ state, found }: ExploreModel, dispatch: Dispatch): unknown {
  const { between, caps, lock } = state;
  if (found.details.family !== 'curved' || !between) return nothing;
  const isLocked = lock.includes('between');
  const close = (event: Event): void => {
    const on = checked(event);
    dispatch({ type: 'ends', value: (now) => now && { ...now, caps: on } });
  };
  return html`<div class="ends" role="group" aria-label="Ends">
    ${END_PARAMS.map((_, i) => height(i as 0 | 1, between, isLocked, dispatch))}
    <label title="Close both ends by discs"><input type="checkbox" .checked=${caps}
      ?disabled=${isLocked} @change=${close} />caps</label>
  </div>`;
}

export const endsControls: EndsControls = { endsSwitch, endsRow };

function height(
  i: 0 | 1,
  between: readonly [number, number],
  isLocked: boolean,
  dispatch: Dispatch,
): TemplateResult {
  const { symbol, title, range, step } = END_PARAMS[i];
  const send = ({ detail }: CustomEvent<number>): void => dispatch(endAction(i, detail));
  const refusal = (y: number): string | null =>
    endsRefusal(i === 0 ? [y, between[1]] : [between[0], y]);
  return html`<div class="end-height sym-shape" role="group" aria-label=${`${symbol}, ${title}`}
    data-symbol=${symbol} @graze-value=${send}>
    <span class="letter" aria-hidden="true">${symbol}</span>
    <graze-number id=${`box-${symbol}`} .value=${between[i]} .step=${step}
      .label=${`${symbol}, ${title}`} .symbol=${symbol} .locked=${isLocked}
      .quantity=${symbol} .check=${refusal}></graze-number>
    <graze-slider .value=${between[i]} .least=${range[0]} .most=${range[1]} .step=${step}
      .label=${`${symbol}, slider`} .symbol=${symbol} .locked=${isLocked}></graze-slider>
  </div>`;
}

const AT_HEIGHT = (end: 'low' | 'high') => over(minus(scalar(end), comp('E', 'y')), comp('d', 'y'));

/**
 * What the ends leave, below the roots: where the ray goes through each cap's plane and whether in
 * its circle, what exact arithmetic says if that is something else, and of a flat shape that
 * heights do not cut it here.
 */
export function endsLines(model: ExploreModel, dispatch: Dispatch): unknown {
  const { ended, state, title, found, derivation } = model;
  const started = startLine(model, dispatch);
  if (!state.between) return started;
  if (!ended) {
    return html`<p class="kept-between" role="note">${flatNote(title, state.between, found)}</p>
      ${started}`;
  }
  return html`${
    ended.contradicted
      ? html`<p class="contradicted">exact arithmetic says: ${ended.contradicted}</p>`
      : nothing
  }${ended.capLines.map((line) => capLine(line, derivation.surface))}${started}`;
}

/** What counts in the picture that the ray comes from, and the way back to its pixel. */
function startLine(model: ExploreModel, dispatch: Dispatch): unknown {
  const { state } = model;
  const started = startOutcomeOf(model);
  if (!started) return nothing;
  const { pixel } = state.settings.picture;
  return html`<p class="started" role="note" data-rule=${started.rule ?? nothing}
    data-first=${started.first === null ? nothing : shortest(started.first)}>${started.words}
    ${
      pixel
        ? html`<a class="textual" href=${encode({ ...state, page: 'picture' })}>back to pixel
          ${pixel.replace(',', ', ')} of the picture</a>`
        : nothing
    }
    <button type="button" class="textual"
      @click=${() => dispatch({ type: 'settings', values: { start: null } })}>forget the
      picture</button></p>`;
}

function capLine(line: CapLine, { left, right }: Relation): TemplateResult {
  const { end, height: y, at, isHit, text } = line;
  const within: Relation = { left, relation: '≤', right };
  return html`<div class="cap-line" role="group" aria-label=${CAP_NAMES[end]}
    data-fate=${isHit ? 'hit' : 'none'} data-symbol=${`t${end === 'low' ? 3 : 4}`}>
    <span class="name">${CAP_NAMES[end]}, y = ${display(y)}</span>
    ${
      at
        ? html`<span>${formula(
            mathml`<mi>t</mi><mo>=</mo>${typesetSymbols(AT_HEIGHT(end))}<mo>=</mo>`,
          )} ${value(`${end}.t`, at.t)}</span>
      <span>at (${AXES.map(
        (axis, i) => html`${i > 0 ? ', ' : nothing}${value(`${end}.${axis}`, at.point[i] ?? 0)}`,
      )})</span>
      <span>${formula(typesetRelation(within))}: ${compared(at)}</span>`
        : nothing
    }
    <span class="fate">${text}</span>
  </div>`;
}

/** "0.7 ≤ 2.25", with the relation that holds, and as many digits as it takes to see it. */
function compared({ left, right, side }: NonNullable<CapLine['at']>): string {
  const [a, b] = side === 0 ? [display(left), display(right)] : distinctTexts(left, right);
  return `${a} ${side > 0 ? '>' : side < 0 ? '<' : '='} ${b}`;
}

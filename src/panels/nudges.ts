import { html, type TemplateResult } from 'lit';
import { nextDown, nextUp } from '../math/float/ulp.ts';
import { definitionOf } from '../math/shapes/lookup.ts';
import { AXES, type Vec3 } from '../math/vec3.ts';
import type { Dispatch } from '../state/actions.ts';
import { type AppState, paramValue, shapeOf } from '../state/state.ts';
import { displayAll, shortest } from '../text/format.ts';
import { classOf } from './symbols.ts';
import './nudges.css';

/** One double of the input, and what to send when it is another one. */
interface Input {
  readonly vector: string;
  readonly axis: string;
  readonly sort: 'scalar' | 'vector';
  readonly value: number;
  send(value: number): void;
}

/** Every number that the kernel gets, each with a step to the doubles beside it: how little does it take to flip a verdict? */
export function nudges(state: AppState, dispatch: Dispatch): TemplateResult {
  return html`<div class="nudges" role="group" aria-label="Move an input to the next double">
    ${inputsOf(state, dispatch).map(nudge)}
  </div>`;
}

function nudge({ vector, axis, sort, value, send }: Input): TemplateResult {
  const name = `${vector}${axis ? `.${axis}` : ''}`;
  const key = (event: KeyboardEvent): void => {
    if (event.altKey || event.ctrlKey || event.metaKey) return;
    const up = event.key === 'ArrowUp' || event.key === 'ArrowRight';
    const down = event.key === 'ArrowDown' || event.key === 'ArrowLeft';
    if (!up && !down) return;
    event.preventDefault();
    send(up ? nextUp(value) : nextDown(value));
  };
  return html`<span class="nudge" @keydown=${key}>
    <button type="button" aria-label=${`${name} one double down`} @click=${() => send(nextDown(value))}>−</button>
    <span class="nudge-name ${classOf(vector, sort)}">${vector}${axis ? html`<sub>${axis}</sub>` : ''}</span>
    <span class="nudge-value" data-quantity=${name} data-value=${shortest(value)}>${displayAll(value)}</span>
    <button type="button" aria-label=${`${name} one double up`} @click=${() => send(nextUp(value))}>+</button>
  </span>`;
}

function inputsOf(state: AppState, dispatch: Dispatch): Input[] {
  const shape = shapeOf(state);
  const own = definitionOf(shape).params.flatMap(({ key, symbol, type }): Input[] => {
    const value = paramValue(shape, key);
    if (type === 'vector') {
      return ofVector(symbol, value as Vec3, (v) => dispatch({ type: 'param', key, value: v }));
    }
    if (type === 'axis') return [];
    const send = (x: number): void => dispatch({ type: 'param', key, value: x });
    return [{ vector: symbol, axis: '', sort: 'scalar', value: value as number, send }];
  });
  return [
    ...ofVector('E', state.E, (value) => dispatch({ type: 'origin', value })),
    ...ofVector('d', state.d, (value) => dispatch({ type: 'direction', value })),
    ...own,
  ];
}

function ofVector(vector: string, v: Vec3, send: (v: Vec3) => void): Input[] {
  return AXES.map((axis, i) => ({
    vector,
    axis,
    sort: 'vector',
    value: v[i] as number,
    send: (x) => send(v.map((old, k) => (k === i ? x : old)) as unknown as Vec3),
  }));
}

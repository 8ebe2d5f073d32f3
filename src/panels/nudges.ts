import { html, type TemplateResult } from 'lit';
import { nextDown, nextUp } from '../math/float/ulp.ts';
import { definitionOf } from '../math/shapes/lookup.ts';
import { AXES, type Vec3 } from '../math/vec3.ts';
import type { Dispatch } from '../state/actions.ts';
import { type AppState, paramValue, shapeOf } from '../state/state.ts';
import { displayAll, shortest } from '../text/format.ts';
import { Ahead } from '../ui/ahead.ts';
import { classOf } from './symbols.ts';
import './nudges.css';

/** A vector or a number of the input, and what to send when it is another one. */
interface Source {
  readonly symbol: string;
  readonly value: Vec3 | number;
  send(value: Vec3 | number): void;
}

type Step = (x: number) => number;

/**
 * Every number that the kernel gets, each with a step to the doubles beside it: how little does it take to flip a verdict? The returned
 * view remembers what it sent until the page has been drawn with it, so that no key is lost, however fast they come.
 */
export function createNudges(
  dispatch: Dispatch,
  moved: (name: string, from: number, to: number) => void,
): (state: AppState) => TemplateResult {
  const ahead = new Map<string, Ahead<Vec3 | number>>();
  const move = ({ symbol, value, send }: Source, i: number, step: Step): void => {
    const own = ahead.get(symbol) ?? new Ahead<Vec3 | number>();
    ahead.set(symbol, own);
    const now = own.of(value);
    const next =
      typeof now === 'number'
        ? step(now)
        : (now.map((x, k) => (k === i ? step(x) : x)) as unknown as Vec3);
    own.set(next);
    send(next);
    const part = (v: Vec3 | number): number => (typeof v === 'number' ? v : (v[i] as number));
    moved(typeof now === 'number' ? symbol : `${symbol}.${AXES[i]}`, part(now), part(next));
  };
  return (
    state,
  ) => html`<div class="nudges" role="group" aria-label="Move an input to the next double">
    ${sourcesOf(state, dispatch).map((source) =>
      typeof source.value === 'number'
        ? nudge(source.symbol, '', source.value, (step) => move(source, 0, step))
        : AXES.map((axis, i) =>
            nudge(source.symbol, axis, (source.value as Vec3)[i] as number, (step) =>
              move(source, i, step),
            ),
          ),
    )}
  </div>`;
}

const STEPS: Readonly<Record<string, Step>> = {
  ArrowUp: nextUp,
  ArrowRight: nextUp,
  ArrowDown: nextDown,
  ArrowLeft: nextDown,
};

function nudge(
  symbol: string,
  axis: string,
  value: number,
  move: (step: Step) => void,
): TemplateResult {
  const name = `${symbol}${axis ? `.${axis}` : ''}`;
  const key = (event: KeyboardEvent): void => {
    const step = STEPS[event.key];
    if (!step || event.altKey || event.ctrlKey || event.metaKey) return;
    event.preventDefault();
    move(step);
  };
  return html`<span class="nudge" @keydown=${key}>
    <button type="button" aria-label=${`${name} one double down`} @click=${() => move(nextDown)}>−</button>
    <span class="nudge-name ${classOf(symbol, axis ? 'vector' : 'scalar')}">${symbol}${axis ? html`<sub>${axis}</sub>` : ''}</span>
    <span class="nudge-value" data-quantity=${name} data-value=${shortest(value)}>${displayAll(value)}</span>
    <button type="button" aria-label=${`${name} one double up`} @click=${() => move(nextUp)}>+</button>
  </span>`;
}

function sourcesOf(state: AppState, dispatch: Dispatch): Source[] {
  const shape = shapeOf(state);
  const own = definitionOf(shape).params.flatMap(({ key, symbol, type }): Source[] => {
    if (type === 'axis') return [];
    const value = paramValue(shape, key) as Vec3 | number;
    return [{ symbol, value, send: (next) => dispatch({ type: 'param', key, value: next }) }];
  });
  return [
    { symbol: 'E', value: state.E, send: (v) => dispatch({ type: 'origin', value: v as Vec3 }) },
    { symbol: 'd', value: state.d, send: (v) => dispatch({ type: 'direction', value: v as Vec3 }) },
    ...own,
  ];
}

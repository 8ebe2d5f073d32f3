import { html, type TemplateResult } from 'lit';
import type { Vec3 } from '../math/index.ts';
import { AXES, definitionOf, nextDown, nextUp, withComponent } from '../math/shapes.ts';
import type { Dispatch, ParamValue } from '../state/actions.ts';
import { type AppState, paramValue, shapeOf } from '../state/state.ts';
import { displayAll, shortest } from '../text/format.ts';
import { classOf } from './symbols.ts';
import './nudges.css';

/** A vector or a number of the input, and how it is changed. */
interface Source {
  readonly symbol: string;
  readonly value: Vec3 | number;
  readonly send: (edit: (now: ParamValue) => ParamValue) => void;
}

type Step = (x: number) => number;

/** A number that was moved, under its name: E.x, r. */
type Moved = (name: string, from: number, to: number) => void;

/** Every number that the kernel gets, with buttons for the neighbouring doubles. */
export function nudges(state: AppState, dispatch: Dispatch, moved: Moved): TemplateResult {
  return html`<div class="nudges" role="group" aria-label="Move an input to the next double">
    ${sourcesOf(state, dispatch).map((source) =>
      typeof source.value === 'number'
        ? nudge(source.symbol, '', source.value, (step) => move(source, null, step, moved))
        : AXES.map((axis, i) =>
            nudge(source.symbol, axis, (source.value as Vec3)[i] as number, (step) =>
              move(source, i, step, moved),
            ),
          ),
    )}
  </div>`;
}

function move({ symbol, send }: Source, index: number | null, step: Step, moved: Moved): void {
  let [from, to] = [Number.NaN, Number.NaN];
  const stepped = (x: number): number => {
    from = x;
    to = step(x);
    return to;
  };
  send((now) =>
    index === null
      ? stepped(now as number)
      : withComponent(now as Vec3, index, stepped((now as Vec3)[index] as number)),
  );
  moved(index === null ? symbol : `${symbol}.${AXES[index]}`, from, to);
}

const STEPS: Readonly<Record<string, Step>> = {
  ArrowUp: nextUp,
  ArrowDown: nextDown,
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
    <button type="button" aria-label=${`${name} one double down`}
      @click=${() => move(nextDown)}>−</button>
    <span class="nudge-name ${classOf(symbol, axis ? 'vector' : 'scalar')}">${symbol}${
      axis ? html`<sub>${axis}</sub>` : ''
    }</span>
    <span class="nudge-value" data-quantity=${name}
      data-value=${shortest(value)}>${displayAll(value)}</span>
    <button type="button" aria-label=${`${name} one double up`}
      @click=${() => move(nextUp)}>+</button>
  </span>`;
}

function sourcesOf(state: AppState, dispatch: Dispatch): Source[] {
  const shape = shapeOf(state);
  const own = definitionOf(shape).params.flatMap(({ key, symbol, type }): Source[] => {
    if (type === 'axis') return [];
    const value = paramValue(shape, key) as Vec3 | number;
    return [{ symbol, value, send: (edit) => dispatch({ type: 'param', key, value: edit }) }];
  });
  const ray = (type: 'origin' | 'direction') => (edit: (now: ParamValue) => ParamValue) =>
    dispatch({ type, value: edit as (now: Vec3) => Vec3 });
  return [
    { symbol: 'E', value: state.E, send: ray('origin') },
    { symbol: 'd', value: state.d, send: ray('direction') },
    ...own,
  ];
}

import type { Vec3 } from '../math/index.ts';
import {
  AXES,
  checkParam,
  findShape,
  type NumberParam,
  type VectorParam,
  withComponent,
} from '../math/shapes.ts';
import type { Action, ParamValue } from '../state/actions.ts';
import { END_PARAMS, endAction, endsRefusal } from '../state/ends.ts';
import { type AppState, paramValue, RAY_PARAMS, shapeOf } from '../state/state.ts';

/** A number that a step lets be moved, with what its slider needs. */
export interface Freedom {
  /** 'r', 'E.x' */
  readonly name: string;
  /** The parameter's letter, which has its colour. */
  readonly symbol: string;
  readonly title: string;
  readonly range: readonly [number, number];
  readonly step: number;
  valueIn(state: AppState): number;
  action(value: number): Action;
  /** Whether a value is allowed. */
  allows(value: number, state: AppState): boolean;
}

/**
 * The numbers of `free: r`, `free: E.x` or `free: E`, or an end's, `free: high`; null if there is
 * no such parameter.
 */
export function freedomOf(text: string, state: AppState): readonly Freedom[] | null {
  const [letter = '', axis] = text.split('.');
  const own = findShape(state.kind)?.params.find(({ symbol }) => symbol === letter);
  const end = END_PARAMS.findIndex(({ symbol }) => symbol === text);
  if (end >= 0) return state.between ? [endOf(end as 0 | 1)] : null;
  if (own?.type === 'number') return axis === undefined ? [numberOf(own)] : null;
  const ray = letter === 'E' || letter === 'd' ? RAY_PARAMS[letter] : null;
  const vector = own?.type === 'vector' ? own : ray;
  if (!vector) return null;
  const all = AXES.map((_, i) => componentOf(vector, i, ray !== null && own === undefined));
  if (axis === undefined) return all;
  const one = all[['x', 'y', 'z'].indexOf(axis)];
  return one ? [one] : null;
}

const isAllowed = (param: NumberParam | VectorParam, value: ParamValue): boolean => {
  try {
    checkParam(param, value);
    return true;
  } catch {
    return false;
  }
};

function numberOf(param: NumberParam): Freedom {
  const { symbol, title, range, step, key } = param;
  return {
    name: symbol,
    ...{ symbol, title, range, step },
    valueIn: (state) => paramValue(shapeOf(state), key) as number,
    action: (value) => ({ type: 'param', key, value }),
    allows: (value) => isAllowed(param, value),
  };
}

/** A height that the state keeps its shape below or above. */
function endOf(i: 0 | 1): Freedom {
  const { symbol, title, range, step } = END_PARAMS[i];
  return {
    name: symbol,
    ...{ symbol, title, range, step },
    valueIn: (state) => state.between?.[i] ?? 0,
    action: (value) => endAction(i, value),
    allows: (value, { between }) =>
      between !== null && !endsRefusal(i === 0 ? [value, between[1]] : [between[0], value]),
  };
}

function componentOf(param: VectorParam, i: number, ofRay: boolean): Freedom {
  const { symbol, title, range, step, key } = param;
  const vectorIn = (state: AppState): Vec3 => {
    if (!ofRay) return paramValue(shapeOf(state), key) as Vec3;
    return symbol === 'E' ? state.E : state.d;
  };
  const put = (value: number) => (now: ParamValue) => withComponent(now as Vec3, i, value);
  return {
    name: `${symbol}.${AXES[i]}`,
    ...{ symbol, title, range, step },
    valueIn: (state) => vectorIn(state)[i] ?? 0,
    action(value) {
      if (!ofRay) return { type: 'param', key, value: put(value) };
      const edit = put(value) as (now: Vec3) => Vec3;
      return symbol === 'E' ? { type: 'origin', value: edit } : { type: 'direction', value: edit };
    },
    allows: (value, state) => isAllowed(param, withComponent(vectorIn(state), i, value)),
  };
}

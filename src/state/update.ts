import { walkLength } from '../math/formula.ts';
import type { Shape, Vec3 } from '../math/index.ts';
import { checkParam, findMethod, findShape, type Param, type ShapeKind } from '../math/shapes.ts';
import {
  type Action,
  applied,
  type Changes,
  type Edit,
  type EndsValue,
  type ParamValue,
} from './actions.ts';
import { isView } from './camera-view.ts';
import { allExamples, exampleOf } from './example.ts';
import type { Tangent } from './nearest-tangent.ts';
import {
  type AppState,
  INITIAL,
  initialShape,
  paramValue,
  RAY_PARAMS,
  rayOf,
  type Settings,
  shapeOf,
} from './state.ts';
import { retyped, type TypedTexts, untyped } from './typed-texts.ts';
import { decode } from './url.ts';

/**
 * The next state. An action whose value is not allowed changes nothing; the control that sent it
 * shows why.
 */
export function update(state: AppState, action: Action): AppState {
  const next = updated(state, action);
  if (next === state || action.type === 'link' || action.type === 'open') return next;
  return isLocked(state, next) ? state : kept(state, next);
}

/**
 * Whether something that the link locks would change. Another shape has numbers of its own, and an
 * example its own locks.
 */
function isLocked(state: AppState, next: AppState): boolean {
  if (next.lock !== state.lock) return false;
  const value = (now: AppState, symbol: string): unknown => {
    if (symbol === 'E' || symbol === 'd' || symbol === 'between') return now[symbol];
    const param = findShape(state.kind)?.params.find((one) => one.symbol === symbol);
    return param && paramValue(now.shapes[state.kind], param.key);
  };
  return state.lock.some(
    (symbol) =>
      !Object.is(value(state, symbol), value(next, symbol)) ||
      (symbol === 'd' && next.unit !== state.unit) ||
      (symbol === 'between' && next.caps !== state.caps),
  );
}

/** Stores the id of the example that a link showed, which is needed after a change. */
function kept(state: AppState, next: AppState): AppState {
  if (state.example !== null || next.example !== null) return next;
  const example = exampleOf(state);
  return example ? { ...next, example: example.entry.id } : next;
}

function updated(state: AppState, action: Action): AppState {
  switch (action.type) {
    case 'shape':
      return findShape(action.kind) ? { ...state, kind: action.kind as ShapeKind } : state;
    case 'origin':
      return withRay(state, 'E', action.value, action.texts);
    case 'direction':
      return withRay(state, 'd', action.value, action.texts);
    case 'unit':
      return { ...state, unit: action.on };
    case 'param':
      return withParam(state, action.key, action.value, action.texts);
    case 'ends':
      return withEnds(state, endsAfter(state, action.value));
    case 'method':
      return findMethod(action.id) ? { ...state, method: action.id } : state;
    case 'view':
      return isView(action.view) ? { ...state, view: action.view } : state;
    case 'bead':
      return withBead(state, applied(action.t, state.bead));
    case 'reset':
      return reset(state, action.what);
    case 'page':
      return state.page === action.page ? state : { ...state, page: action.page, problems: [] };
    case 'settings':
      return withSettings(
        state,
        typeof action.values === 'function'
          ? action.values(state.settings[state.page])
          : action.values,
      );
    case 'link':
      return decode(action.hash, state);
    case 'open':
      return applied(action.state, state);
    case 'example':
      return openExample(state, action.id);
    case 'browse':
      return openExample(state, neighbour(exampleOf(state)?.entry.id ?? state.example, action.by));
    case 'reveal':
      // The bead's place may be a hit, which would give the answer away.
      return {
        ...(state.revealed === null && action.lines === 0 ? withBead(state, null) : state),
        revealed: action.lines,
      };
    case 'ask':
      return { ...state, ask: action.ask };
    case 'tell':
      return state.told === action.on ? state : { ...state, told: action.on };
    case 'derive':
      return { ...state, derive: within(applied(action.step, state.derive), shapeOf(state)) };
    case 'ghost':
      return { ...state, ghost: action.on ? { shape: shapeOf(state), ray: rayOf(state) } : null };
    case 'tangent':
      return toTangent(state, action.find(state));
    case 'say':
      return { ...state, problems: action.problems };
    case 'dismiss':
      return { ...state, problems: [] };
    case 'undo':
    case 'redo':
      // The store's history handles these two.
      return state;
  }
}

const withBead = (state: AppState, bead: number | null): AppState =>
  bead === null || Number.isFinite(bead) ? { ...state, bead } : state;

/** The step, clamped to the number of steps of this shape's derivation. */
const within = (step: number | null, shape: Shape): number | null =>
  step && Math.max(1, Math.min(step, walkLength(shape)));

function toTangent(state: AppState, found: Tangent | null): AppState {
  if (!found) return state;
  const turned = withRay(withRay(state, 'E', found.E), 'd', found.d);
  return Object.entries(found.shape).reduce(
    (now, [key, value]) => withParam(now, key, value as ParamValue),
    turned,
  );
}

function allowed(param: Param, value: unknown): boolean {
  try {
    checkParam(param, value);
    return true;
  } catch {
    return false;
  }
}

/** Equality that tells −0 from 0. */
function same(a: ParamValue, b: ParamValue): boolean {
  if (typeof a !== 'object' || typeof b !== 'object') return Object.is(a, b);
  return a.length === b.length && a.every((x, i) => Object.is(x, b[i]));
}

function withRay(state: AppState, key: 'E' | 'd', edit: Edit<Vec3>, texts?: TypedTexts): AppState {
  const value = applied(edit, state[key]);
  if (!allowed(RAY_PARAMS[key], value)) return state;
  const next = same(value, state[key]) ? state : { ...state, [key]: value };
  return retyped(state, next, texts);
}

function withParam(
  state: AppState,
  key: string,
  edit: Edit<ParamValue>,
  texts?: TypedTexts,
): AppState {
  const param = findShape(state.kind)?.params.find((p) => p.key === key);
  if (!param) return state;
  const shape = shapeOf(state);
  const before = paramValue(shape, key);
  const value = applied(edit, before);
  if (!allowed(param, value)) return state;
  const next = same(value, before) ? state : withShape(state, { ...shape, [key]: value } as Shape);
  return retyped(state, next, texts);
}

const endsIn = ({ between, caps }: AppState): EndsValue | null => between && { between, caps };

const endsAfter = (state: AppState, edit: Extract<Action, { type: 'ends' }>['value']) =>
  typeof edit === 'function' ? edit(endsIn(state), shapeOf(state)) : edit;

function withEnds(state: AppState, ends: EndsValue | null): AppState {
  const [low = Number.NaN, high = Number.NaN] = ends?.between ?? [0, 1];
  if (!(low < high) || !Number.isFinite(low) || !Number.isFinite(high)) return state;
  const [between, caps] = [ends?.between ?? null, ends?.caps ?? false];
  const isSame = between && state.between?.every((y, i) => Object.is(y, between[i]));
  if ((isSame || between === state.between) && caps === state.caps) return state;
  return { ...state, between: isSame ? state.between : between, caps };
}

function withSettings(state: AppState, values: Changes): AppState {
  const before = state.settings[state.page];
  if (Object.entries(values).every(([key, value]) => (before[key] ?? null) === value)) return state;
  const merged = Object.entries({ ...before, ...values });
  const after = Object.fromEntries(merged.filter(([, value]) => value !== null)) as Settings;
  return { ...state, settings: { ...state.settings, [state.page]: after } };
}

function withShape(state: AppState, shape: Shape): AppState {
  return { ...state, shapes: { ...state.shapes, [shape.kind]: shape } };
}

type What = Extract<Action, { type: 'reset' }>['what'];

function reset(state: AppState, what: What): AppState {
  const { kind } = state;
  const without = (...letters: string[]): AppState => ({
    ...state,
    typed: untyped(state.typed, letters),
  });
  if (what === 'E') return { ...without('E'), E: INITIAL.E };
  if (what === 'd') return { ...without('d'), d: INITIAL.d };
  if (what === 'all') {
    const { E, d, unit, bead, view, between, caps } = INITIAL;
    const rest = { E, d, unit, bead, view, between, caps };
    return withShape({ ...without('E', 'd', kind), ...rest }, initialShape(kind));
  }
  const param = findShape(kind)?.params.find(({ key }) => key === what.param);
  if (!param) return state;
  return withParam(without(`${kind}.${param.symbol}`), param.key, param.initial);
}

function openExample(state: AppState, id: string): AppState {
  const found = allExamples().find((entry) => entry.id === id);
  return found ? { ...decode(found.link, state), example: id, derive: state.derive } : state;
}

/** Id of the next or previous example, cyclically; without one the first or the last. */
function neighbour(id: string | null, by: 1 | -1): string {
  const all = allExamples();
  const at = all.findIndex((entry) => entry.id === id);
  const next = at === -1 && by === -1 ? -1 : at + by;
  return all.at(next % all.length)?.id ?? '';
}

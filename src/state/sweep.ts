import { intersect, type Shape, type Vec3 } from '../math/index.ts';
import {
  AXES,
  type Axis,
  checkParam,
  definitionOf,
  type NumberParam,
  nextDown,
  nextUp,
  type Param,
  type VectorParam,
  withComponent,
} from '../math/shapes.ts';
import { display } from '../text/format.ts';
import type { Action } from './actions.ts';
import { type AppState, paramValue, RAY_PARAMS, rayOf, shapeOf } from './state.ts';

/*
 * A sweep plays one number (E.x, c, r) up, down and back, through the values where the class
 * changes. The drawn states are computed from the store's state, which does not change meanwhile.
 */

/** A value at which the certified class, or the sign of A or N·d, changes. */
interface Boundary {
  /** Of the two neighbouring doubles the one with a root, if one has. */
  readonly value: number;
  /** What is 0 there, and whether it is that at `value` itself. */
  readonly what: string;
  readonly isExact: boolean;
}

/** The exact class and signs at a value. */
interface Case {
  readonly value: number;
  readonly key: string;
  readonly zero: string | null;
  /** Number of hits. */
  readonly hits: number;
  readonly isStraight: boolean;
}

/** The result of the chosen method at a value. */
export interface Sample extends Pick<Case, 'value' | 'key' | 'zero'> {
  /** Its verdict. */
  readonly verdict: string;
  readonly hits: readonly { readonly t: number; readonly point: Vec3 }[];
  /** f in t. */
  readonly f: readonly [A: number, B: number, C: number];
}

/** The values that one number goes through. */
export interface Sweep {
  /** 'E.x', 'c'. */
  readonly label: string;
  /** Where the number is, and the ends of its way. */
  readonly home: number;
  readonly low: number;
  readonly high: number;
  readonly boundaries: readonly Boundary[];
  /** The way in words: "c from 0.2 to 1.3: A = 0 at c ≈ 0.9". */
  readonly text: string;
  /** Ascending in their values. */
  readonly samples: readonly Sample[];
}

/** Samples of a trail. */
const SAMPLES = 120;
/** Part of a slider's step that a number moves by while it plays. */
const FINE = 10;
/** How far a sweep goes past a boundary: a share of the way there, at least some slider steps. */
const BEYOND = { share: 0.4, steps: 4 };
/** A boundary this many times farther than the one on the other side is left out. */
const FARTHER = 4;
/** Duration from one end to the other, and of the pause at each boundary. */
const [WAY_MS, REST_MS] = [3200, 600];
/** Halvings until two doubles are neighbours. */
const HALVINGS = 1100;

interface SweptNumber {
  readonly param: NumberParam | VectorParam;
  readonly index: number | null;
  /** E, d, or a key of the shape. */
  readonly owner: 'E' | 'd' | null;
}

function placeOf(state: AppState, label: string): SweptNumber | null {
  const [symbol, axis] = label.split('.');
  const owner = symbol === 'E' || symbol === 'd' ? symbol : null;
  const params: readonly Param[] = owner
    ? [RAY_PARAMS[owner]]
    : definitionOf(shapeOf(state)).params;
  const param = params.find((one) => one.symbol === symbol);
  const index = axis === undefined ? null : AXES.indexOf(axis as Axis);
  if (
    !param ||
    param.type === 'axis' ||
    (index === null) !== (param.type === 'number') ||
    index === -1
  )
    return null;
  return { param, index, owner };
}

const valueIn = (state: AppState, { param, index, owner }: SweptNumber): number => {
  const value = owner ? state[owner] : paramValue(shapeOf(state), param.key);
  return index === null ? (value as number) : ((value as Vec3)[index] ?? 0);
};

/** The state with another value of one number; null where that is not allowed. */
export function withNumber(state: AppState, label: string, value: number): AppState | null {
  const place = placeOf(state, label);
  if (!place) return null;
  const { param, index, owner } = place;
  const shape = shapeOf(state);
  const before = owner ? state[owner] : paramValue(shape, param.key);
  const next = index === null ? value : withComponent(before as Vec3, index, value);
  try {
    checkParam(param, next);
  } catch {
    return null;
  }
  const typed = {};
  if (owner) return { ...state, [owner]: next, typed };
  const changed = { ...shape, [param.key]: next } as Shape;
  return { ...state, shapes: { ...state.shapes, [shape.kind]: changed }, typed };
}

/** The action that sets a number of the state to this value. */
export function toNumber(state: AppState, label: string, value: number): Action | null {
  const place = placeOf(state, label);
  if (!place) return null;
  const { param, index, owner } = place;
  const edit = (now: unknown) =>
    index === null ? value : withComponent(now as Vec3, index, value);
  if (owner === 'E') return { type: 'origin', value: edit as (now: Vec3) => Vec3 };
  if (owner === 'd') return { type: 'direction', value: edit as (now: Vec3) => Vec3 };
  return { type: 'param', key: param.key, value: edit };
}

function caseOf(state: AppState, value: number): Case {
  const { class: verdict, hits, details } = intersect(shapeOf(state), rayOf(state));
  const of = (sign: number | null, zero: string | null, isStraight: boolean): Case => ({
    ...{ value, key: `${verdict} ${sign}`, zero, hits: hits.length, isStraight },
  });
  if (details.family === 'flat') {
    const { rate } = details.signs;
    return of(rate, rate === 0 ? 'N·d = 0' : null, true);
  }
  const { A, D } = details.signs;
  return of(A, A === 0 ? 'A = 0' : D === 0 ? 'D = 0' : null, details.A === 0);
}

function sampleOf(state: AppState, { value, key, zero }: Case): Sample {
  const { class: verdict, hits, details } = intersect(shapeOf(state), rayOf(state), state.method);
  const f: Sample['f'] =
    details.family === 'flat'
      ? [0, details.rate, details.offset]
      : [details.A, details.B, details.C];
  return { value, key, zero, verdict, hits, f };
}

/**
 * The way of a number from where it is, through the nearest change of class on each side, and back;
 * a part of its slider where there is no such change. Null for what is no number of the state, or
 * has no way.
 */
export function sweepOf(state: AppState, label: string): Sweep | null {
  const place = placeOf(state, label);
  if (!place) return null;
  const { step, range } = place.param;
  const home = valueIn(state, place);
  const at = (value: number): Case | null => {
    const there = withNumber(state, label, value);
    return there && caseOf(there, value);
  };
  const [least, most] = rangeAround(home, range);
  const inSteps = multiples(least, most, step).filter((value) => value !== home);
  const scanned = sorted([...inSteps, least, home, most]).flatMap((value) => at(value) ?? []);
  const found = scanned.slice(1).flatMap((to, i) => changeBetween(scanned[i] as Case, to, at));
  const boundaries = found.map(({ boundary }) => boundary).filter(isFirst);
  const [low, high] = endsOf(home, step, [least, most], boundaries);
  const grid = multiples(low, high, Math.max((high - low) / SAMPLES, step / FINE));
  const values = sorted([
    ...[low, home, high, ...grid.map((value) => onGrid(value, step / FINE))],
    ...found.flatMap(({ beside }) => beside),
  ]).filter((value) => value >= low && value <= high);
  if (!(high > low) || values.length < 3) return null;
  const seen = boundaries.filter(({ value }) => value >= low && value <= high);
  const samples = values.flatMap((value) => {
    const there = withNumber(state, label, value);
    return there ? sampleOf(there, caseOf(there, value)) : [];
  });
  return { label, home, low, high, boundaries: seen, text: words(label, low, high, seen), samples };
}

/** The slider's range; about the number itself where that is beyond it. */
function rangeAround(home: number, [least, most]: readonly [number, number]): [number, number] {
  if (home >= least && home <= most) return [least, most];
  const half = (most - least) / 2;
  return [home - half, home + half];
}

const multiples = (from: number, to: number, step: number): number[] => {
  const count = Math.floor((to - from) / step + 1e-9);
  return Array.from({ length: Math.max(count, 0) + 1 }, (_, i) => onGrid(from + i * step, step));
};

/** The nearest multiple of the step, as a short decimal. */
const onGrid = (value: number, step: number): number =>
  Number((Math.round(value / step) * step).toPrecision(12)) + 0;

const sorted = (values: readonly number[]): number[] => [...new Set(values)].sort((a, b) => a - b);

const isFirst = ({ value }: Boundary, i: number, all: readonly Boundary[]): boolean =>
  all.findIndex((one) => one.value === value) === i;

/** Where the case changes between two values, to the last bit, and the doubles on both sides. */
function changeBetween(
  from: Case,
  to: Case,
  at: (value: number) => Case | null,
): { boundary: Boundary; beside: number[] }[] {
  if (from.key === to.key) return [];
  let [low, high] = [from, to];
  // Most often it changes at a value of the slider itself, or at 0.
  const first = [nextUp(from.value), nextDown(to.value), from.value < 0 && to.value > 0 ? 0 : null];
  for (let i = 0; i < HALVINGS; i++) {
    const middle = first[i] ?? low.value + (high.value - low.value) / 2;
    const isBetween = middle > low.value && middle < high.value;
    if (!isBetween && first[i] === undefined) break;
    const sample = isBetween ? at(middle) : null;
    if (!sample) {
      if (isBetween) break;
      continue;
    }
    if (sample.key === low.key) low = sample;
    else high = sample;
    if (sample.zero && sample.key !== from.key && sample.key !== to.key) break;
  }
  const exact = [low, high].find(({ zero }) => zero !== null);
  const nearest = exact ?? (low.hits > high.hits ? low : high);
  const boundary = { value: nearest.value, what: whatIn(low, high), isExact: exact !== undefined };
  return [{ boundary, beside: [low.value, high.value] }];
}

/** Words for the boundary between two cases; a rim or edge if no sign changes. */
function whatIn(low: Case, high: Case): string {
  const zero = low.zero ?? high.zero;
  if (zero) return zero;
  const [a, b] = [low.key.split(' '), high.key.split(' ')];
  const isFlat = low.isStraight && high.isStraight;
  if (a[1] !== b[1]) return isFlat ? 'N·d = 0' : 'A = 0';
  return isFlat ? 'the edge' : 'D = 0';
}

function endsOf(
  home: number,
  step: number,
  [least, most]: readonly [number, number],
  boundaries: readonly Boundary[],
): [number, number] {
  const values = boundaries.map(({ value }) => value);
  const isAt = values.includes(home);
  const away = (value: number | undefined): number =>
    value === undefined ? Number.POSITIVE_INFINITY : Math.abs(value - home);
  const [below, above] = [values.findLast((x) => x < home), values.find((x) => x > home)];
  const nearest = Math.min(away(below), away(above));
  if (nearest === Number.POSITIVE_INFINITY && !isAt) {
    const quarter = (most - least) / 4;
    return [Math.max(least, home - quarter), Math.min(most, home + quarter)];
  }
  const reach = (value: number | undefined): number => {
    const far = away(value);
    const isNear = value !== undefined && far <= FARTHER * nearest;
    const rest = isAt ? BEYOND.steps * step : 0;
    return isNear ? far + Math.max(BEYOND.share * far, BEYOND.steps * step) : rest;
  };
  const fine = (value: number): number => onGrid(value, step / FINE);
  return [
    Math.max(least, reach(below) ? fine(home - reach(below)) : home),
    Math.min(most, reach(above) ? fine(home + reach(above)) : home),
  ];
}

function words(label: string, low: number, high: number, all: readonly Boundary[]): string {
  const at = all.map(
    ({ what, value, isExact }) => `${what} at ${label} ${isExact ? '=' : '≈'} ${display(value)}`,
  );
  const way = `${label} from ${display(low)} to ${display(high)}`;
  return at.length > 0 ? `${way}: ${at.join(', ')}` : way;
}

/** A value of the sweep as a short decimal; home and boundaries keep all digits. */
export function playedAt(
  { home, low, high, boundaries }: Sweep,
  value: number,
  step: number,
): number {
  const isKept = value === home || boundaries.some((one) => one.value === value);
  return isKept ? value : Math.min(Math.max(onGrid(value, step / FINE), low), high);
}

/**
 * The value after `elapsed` ms: evenly from home to the upper end, to the lower one, and back, with
 * a rest at each boundary but home, also at one that is an end; null when it is back.
 */
export function valueAt(
  { home, low, high, boundaries }: Pick<Sweep, 'home' | 'low' | 'high' | 'boundaries'>,
  elapsed: number,
): number | null {
  const speed = (high - low) / WAY_MS;
  const stops = boundaries.map(({ value }) => value);
  let left = elapsed;
  let at = home;
  for (const to of [high, low, home]) {
    const up = to > at;
    const between = stops
      .filter((stop) => (up ? stop > at && stop < to : stop < at && stop > to))
      .sort((a, b) => (up ? a - b : b - a));
    for (const next of [...between, to]) {
      const way = Math.abs(next - at) / speed;
      if (left < way) return at + (up ? 1 : -1) * left * speed;
      left -= way;
      at = next;
      const rest = stops.includes(next) && next !== home ? REST_MS : 0;
      if (left < rest) return at;
      left -= rest;
    }
  }
  return null;
}

/** The slider's step of a number. */
export const stepOfNumber = (state: AppState, label: string): number =>
  placeOf(state, label)?.param.step ?? 1;

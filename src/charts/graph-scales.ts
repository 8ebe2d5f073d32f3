import type { GraphModel } from '../state/graph-model.ts';
import { display } from '../text/format.ts';
import type { Frame } from './graph-frame.ts';
import { clamp, niceTicks } from './steps.ts';

export interface Tick {
  readonly at: number;
  readonly value: number;
  readonly label: string;
}

/** The frame with its two scales. `y` is null when no height can be given to f at all. */
export interface Scales {
  readonly frame: Frame;
  readonly x: (t: number) => number;
  readonly y: (f: number) => number;
  readonly t: (x: number) => number;
  readonly tTicks: readonly Tick[];
  readonly fTicks: readonly Tick[];
  /** The labels of f are to be multiplied by 10 to this power; 0 for as they are. */
  readonly power: number;
}

/** On t. More would crowd the ray's own ticks on the axis. */
const MOST_TICKS = 7;
/**
 * Labels of f stay within the fixed margin: four figures, or a power of ten is taken out of all of
 * them.
 */
const [LARGEST_LABEL, SMALLEST_LABEL] = [9999, 0.1];

/** Between these a step and the number of its multiples are doubles with all their digits. */
const [SMALLEST_EXTENT, LARGEST_EXTENT] = [1e-290, 1e300];

const FAR = 1e4;

/** Null when the stretch has no extent that ticks can be set on. */
export function scalesOf(model: GraphModel, frame: Frame): Scales | null {
  const extents = [model.to - model.from, model.high - model.low];
  if (!extents.every((extent) => extent > SMALLEST_EXTENT && extent < LARGEST_EXTENT)) return null;
  const x = linear([model.from, model.to], [frame.left, frame.right]);
  const y = linear([model.low, model.high], [frame.floor, frame.top]);
  const fValues = y.ticks(Math.max(2, Math.round((frame.bottom - frame.top) / (3.6 * frame.em))));
  const power = commonPower(fValues);
  return {
    frame,
    x,
    y,
    t: (px) => x.invert(px),
    tTicks: ticks(tValues(x, frame), x, 0),
    fTicks: ticks(fValues, y, power),
    power,
  };
}

interface Linear {
  (value: number): number;
  invert(position: number): number;
  ticks(count: number): number[];
}

type Pair = readonly [number, number];

/** d3-scale's would bring its colours along, which the first load has no room for. */
function linear(domain: Pair, range: Pair): Linear {
  const scale = (value: number): number => between(range, share(domain, value));
  return Object.assign(scale, {
    invert: (position: number): number => between(domain, share(range, position)),
    ticks: (count: number): number[] => niceTicks(...domain, count),
  });
}

/** What lies many plots away is far enough there: 0 times an infinite share would be no number. */
const share = ([from, to]: Pair, value: number): number =>
  clamp((value - from) / (to - from), -FAR, FAR);
const between = ([from, to]: Pair, part: number): number => from * (1 - part) + to * part;

/** As many as their labels leave room for; far from 0 the labels are long. */
function tValues(x: Linear, { left, right, em }: Frame): number[] {
  const room = (right - left) / em;
  const most = Math.max(2, Math.floor(room / 3.2));
  const labels = ticks(x.ticks(most), x, 0).map((tick) => tick.label.length * 0.6 + 1.4);
  return x.ticks(
    Math.max(2, Math.min(most, MOST_TICKS, Math.floor(room / Math.max(...labels, 3.2)))),
  );
}

function ticks(values: readonly number[], scale: (value: number) => number, power: number): Tick[] {
  const finite = values.filter((value) => Number.isFinite(scale(value)));
  const digits = digitsToTell(finite);
  return finite.map((value) => ({
    at: scale(value),
    value,
    label: display(timesPowerOfTen(value, -power), digits),
  }));
}

/** So many that neighbours read differently: at t = 10⁸ a step of 1 needs nine. */
function digitsToTell(values: readonly number[]): number {
  const [first = 0, second = 0] = values;
  const largest = Math.max(Math.abs(first), Math.abs(values.at(-1) ?? 0));
  const needed = Math.ceil(Math.log10(largest / Math.abs(second - first))) + 1;
  return Number.isFinite(needed) ? Math.min(Math.max(6, needed), 17) : 6;
}

function commonPower(values: readonly number[]): number {
  const largest = Math.max(0, ...values.map(Math.abs));
  if (largest === 0 || (largest <= LARGEST_LABEL && largest >= SMALLEST_LABEL)) return 0;
  return Number(largest.toExponential().split('e')[1]);
}

/**
 * By the decimal text: exact up to the last rounding, and no power under- or overflows on the way.
 */
function timesPowerOfTen(x: number, power: number): number {
  const [mantissa, exponent] = x.toExponential(14).split('e');
  return Number(`${mantissa}e${Number(exponent) + power}`);
}

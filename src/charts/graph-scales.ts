import type { GraphModel } from '../state/graph-model.ts';
import { display } from '../text/format.ts';
import { clamp, niceTicks } from './axis-steps.ts';
import type { Frame } from './graph-frame.ts';

export interface Tick {
  readonly at: number;
  readonly value: number;
  readonly label: string;
}

/** The frame with its two scales; `y` is null if f has no finite range. */
export interface Scales {
  readonly frame: Frame;
  readonly x: (t: number) => number;
  readonly y: (f: number) => number;
  readonly t: (x: number) => number;
  readonly tTicks: readonly Tick[];
  readonly fTicks: readonly Tick[];
  /** Labels of f are in units of 10 to this power. */
  readonly power: number;
}

/** Largest number of labels of t. */
const MOST_TICKS = 7;
/** Range of labels of f that fit into the margin; else a power of ten is taken out of all. */
const [LARGEST_LABEL, SMALLEST_LABEL] = [9999, 0.1];

/** Range of an axis in which steps and their multiples neither under- nor overflow. */
const [SMALLEST_EXTENT, LARGEST_EXTENT] = [1e-290, 1e300];

const FAR = 1e4;

/** Null if the interval of t is too small or too large for ticks. */
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

/** A linear scale. */
function linear(domain: Pair, range: Pair): Linear {
  const scale = (value: number): number => between(range, share(domain, value));
  return Object.assign(scale, {
    invert: (position: number): number => between(domain, share(range, position)),
    ticks: (count: number): number[] => niceTicks(...domain, count),
  });
}

/** Position in the pair, 0 … 1, clamped to a finite range: 0 times infinity would be NaN. */
const share = ([from, to]: Pair, value: number): number =>
  clamp((value - from) / (to - from), -FAR, FAR);
const between = ([from, to]: Pair, part: number): number => from * (1 - part) + to * part;

/** Ticks of t, as many as their labels leave room for. */
function tValues(x: Linear, { left, right, em }: Frame): number[] {
  const room = (right - left) / em;
  const most = Math.max(2, Math.floor(room / 3.2));
  const all = x.ticks(most);
  const labels = ticks(all, x, 0).map((tick) => tick.label.length * 0.6 + 1.4);
  const count = Math.max(
    2,
    Math.min(most, MOST_TICKS, Math.floor(room / Math.max(...labels, 3.2))),
  );
  return count === most ? all : x.ticks(count);
}

function ticks(values: readonly number[], scale: (value: number) => number, power: number): Tick[] {
  const finite = values.filter((value) => Number.isFinite(scale(value)));
  const digits = digitsToTell(finite);
  return finite.map((value) => ({
    at: scale(value),
    value,
    label: display(power === 0 ? value : timesPowerOfTen(value, -power), digits),
  }));
}

/** Digits at which neighbouring labels differ: at t = 10⁸ a step of 1 needs nine. */
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

/** x · 10^power by its decimal text, with one rounding and no overflow of the power itself. */
function timesPowerOfTen(x: number, power: number): number {
  const [mantissa, exponent] = x.toExponential(14).split('e');
  return Number(`${mantissa}e${Number(exponent) + power}`);
}

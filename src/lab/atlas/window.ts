import { ulpDistance } from '../../math/index.ts';
import { nextUp, stepped } from '../../math/shapes.ts';

/** Pixels of a map along each side. */
export const SIDE = 256;
export const PIXELS = SIDE * SIDE;
/** The column, and the row, of the window's middle: there the numbers are those of `at`. */
export const MIDDLE = SIDE / 2;

/** What a window is measured in. */
export const MEASURES = [
  { id: 'lengths', title: 'lengths' },
  { id: 'decades', title: 'decades' },
  { id: 'ulps', title: 'doubles' },
] as const;
export type Measure = (typeof MEASURES)[number]['id'];

/**
 * Limits of the zoom. In lengths a window is 10^(1 − zoom) wide, in decades as many powers of ten;
 * in doubles a pixel is 10^(13 − zoom) of them, one at the end.
 */
export const ZOOMS: Readonly<Record<Measure, readonly [least: number, most: number]>> = {
  lengths: [-20, 20],
  decades: [-1, 16],
  ulps: [0, 13],
};
const ONE_DOUBLE = ZOOMS.ulps[1];

/** From one pixel of an axis to the next. */
export type PixelStep =
  | { readonly by: 'doubles'; readonly count: number }
  | { readonly by: 'lengths'; readonly size: number }
  | { readonly by: 'decades'; readonly size: number };

/** An axis of a window. Pixel `MIDDLE` has the number `at` itself; numbers ascend. */
export interface MapScale {
  readonly at: number;
  readonly step: PixelStep;
  /** The number at a pixel, any whole one, also outside of the window; rounded once or twice. */
  numberAt(pixel: number): number;
  /** The pixel whose number is nearest to x, also outside of the window. */
  pixelOf(x: number): number;
}

/** Powers of ten of whole numbers are the nearest doubles in every engine. */
function powerOfTen(exponent: number): number {
  const whole = Math.floor(exponent);
  const rest = exponent - whole;
  return Number(`1e${whole}`) * (rest === 0 ? 1 : 10 ** rest);
}

/**
 * The scale of an axis. Where doubles are farther apart than pixels would be, a pixel is one
 * double.
 *
 * @param at the number in the middle of the window. 0 has no decades: then they are lengths.
 */
export function scaleOf(measure: Measure, zoom: number, at: number): MapScale {
  const step = stepOf(measure, zoom, at);
  return {
    at,
    step,
    numberAt: (pixel) => numberAt(at, step, pixel - MIDDLE),
    pixelOf: (x) => MIDDLE + Math.round(offsetOf(at, step, x)),
  };
}

function offsetOf(at: number, step: PixelStep, x: number): number {
  if (step.by === 'doubles') return (Math.sign(x - at) * ulpDistance(at, x)) / step.count;
  if (step.by === 'lengths') return (x - at) / step.size;
  return (Math.sign(at) * Math.log10(x / at)) / step.size;
}

function stepOf(measure: Measure, zoom: number, at: number): PixelStep {
  if (measure === 'ulps') {
    return { by: 'doubles', count: Math.max(1, Math.round(powerOfTen(ONE_DOUBLE - zoom))) };
  }
  const size = powerOfTen(1 - zoom) / SIDE;
  const ulp = nextUp(Math.abs(at)) - Math.abs(at);
  if (measure === 'decades' && at !== 0) {
    return Math.abs(at) * size * Math.LN10 > ulp ? { by: 'decades', size } : ONE;
  }
  return size > ulp ? { by: 'lengths', size } : ONE;
}

const ONE: PixelStep = { by: 'doubles', count: 1 };

function numberAt(at: number, step: PixelStep, offset: number): number {
  if (offset === 0) return at;
  if (step.by === 'doubles') return stepped(at, offset * step.count);
  if (step.by === 'lengths') return at + offset * step.size;
  // By its difference to 1 a factor is as fine as doubles are.
  const power = Math.sign(at) * offset * step.size * Math.LN10;
  return Math.abs(power) < 1 ? at + at * Math.expm1(power) : at * Math.exp(power);
}

/**
 * Where the middle goes when the window is zoomed about a pixel, so that the number there stays as
 * near as pixels allow.
 */
export function atAfterZoom(
  measure: Measure,
  at: number,
  [from, to]: readonly [from: number, to: number],
  pixel: number,
): number {
  const target = scaleOf(measure, from, at).numberAt(pixel);
  const { step } = scaleOf(measure, to, at);
  return numberAt(target, step, MIDDLE - pixel);
}

/** The zoom within its limits, in steps of a hundredth. */
export function clampZoom(measure: Measure, zoom: number): number {
  const [least, most] = ZOOMS[measure];
  return Math.round(100 * Math.min(Math.max(zoom, least), most)) / 100;
}

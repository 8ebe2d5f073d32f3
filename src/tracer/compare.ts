import { NOTHING } from './types.ts';

/** A finished picture with the hits of its camera rays, as `Frame` of the workers. */
export interface Picture {
  readonly width: number;
  readonly height: number;
  readonly rgba: Uint8ClampedArray;
  readonly surface: Int32Array;
  readonly t: Float64Array;
}

/** Values of an error map's pixels; the worst that applies. */
export const SAME = 0;
export const OTHER_COLOUR = 1;
/** One ray hits and the other misses, or they hit different surfaces. */
export const OTHER_VERDICT = 2;

export interface Comparison {
  /** SAME, OTHER_COLOUR or OTHER_VERDICT for each pixel. */
  readonly map: Uint8Array;
  /** The largest difference of a channel, 0 … 255. */
  readonly levels: Uint8Array;
  /** Wrong decimal digits of t, of 15.95; NaN if the verdicts differ or nothing is hit. */
  readonly digits: Float32Array;
  readonly pixels: number;
  /** Pixels that have another colour. */
  readonly differing: number;
  /** Pixels with another verdict, whatever their colours. */
  readonly verdicts: number;
  /** Of those: `a` misses and `b` hits (holes, if b is right), and only `a` hits (ghosts). */
  readonly holes: number;
  readonly ghosts: number;
  /** Of those: both hit, but different surfaces. */
  readonly others: number;
  /** Median and most of `digits` where both hit the same surface; NaN if they never do. */
  readonly medianDigits: number;
  readonly mostDigits: number;
  readonly largestLevel: number;
}

/**
 * Compares picture `a` with `b`, the more accurate one. Throws RangeError if their sizes differ.
 */
export function comparePictures(a: Picture, b: Picture): Comparison {
  if (a.width !== b.width || a.height !== b.height) {
    throw new RangeError(`${a.width} × ${a.height} cannot be laid on ${b.width} × ${b.height}`);
  }
  const pixels = a.width * a.height;
  const map = new Uint8Array(pixels);
  const levels = new Uint8Array(pixels);
  const digits = new Float32Array(pixels);
  let holes = 0;
  let ghosts = 0;
  let others = 0;
  for (let i = 0; i < pixels; i++) {
    levels[i] = levelsApart(a.rgba, b.rgba, 4 * i);
    const mine = a.surface[i] as number;
    const right = b.surface[i] as number;
    map[i] = mine !== right ? OTHER_VERDICT : levels[i] ? OTHER_COLOUR : SAME;
    digits[i] = mine === right ? digitsLost(a.t[i] as number, b.t[i] as number) : Number.NaN;
    if (mine === NOTHING && right !== NOTHING) holes += 1;
    if (mine !== NOTHING && right === NOTHING) ghosts += 1;
    if (mine !== right && mine !== NOTHING && right !== NOTHING) others += 1;
  }
  const known = digits.filter((x) => !Number.isNaN(x)).sort();
  return {
    map,
    levels,
    digits,
    pixels,
    differing: levels.reduce((n, level) => n + (level > 0 ? 1 : 0), 0),
    verdicts: map.reduce((n, kind) => n + (kind === OTHER_VERDICT ? 1 : 0), 0),
    holes,
    ghosts,
    others,
    medianDigits: known[known.length >> 1] ?? Number.NaN,
    mostDigits: known.at(-1) ?? Number.NaN,
    largestLevel: levels.reduce((most, level) => Math.max(most, level), 0),
  };
}

function levelsApart(a: Uint8ClampedArray, b: Uint8ClampedArray, at: number): number {
  const channel = (k: number): number => Math.abs((a[at + k] as number) - (b[at + k] as number));
  return Math.max(channel(0), channel(1), channel(2));
}

/** log10(2^53): all that a double has. */
export const ALL_DIGITS = 53 * Math.log10(2);

/** Number of wrong decimal digits of t: 0 for equal or neighbouring doubles. */
export function digitsLost(t: number, right: number): number {
  if (t === right) return 0;
  const relative = Math.abs(t - right) / Math.abs(right);
  const lost = ALL_DIGITS + Math.log10(relative);
  return Number.isNaN(lost) ? Number.NaN : Math.min(Math.max(lost, 0), ALL_DIGITS);
}

import { decoded, level } from '../../tracer/colour.ts';
import type { Picture } from '../../tracer/compare.ts';
import { differencesBeside } from '../../tracer/edges.ts';
import type { PicturePart } from '../../tracer/types.ts';
import type { Background } from './trace-queue.ts';
import type { TraceRequest } from './trace-request.ts';

/** Rays a pixel at rest, on a square grid. */
export const MOST_SAMPLES = 16;

/** Order of the grid's points in which the first n are always spread out (Bayer matrix). */
const ORDER = [0, 10, 2, 8, 5, 15, 7, 13, 1, 11, 3, 9, 4, 14, 6, 12] as const;

/**
 * Differences of neighbouring pixels, in levels of 255, that count as edges, where steps may be
 * seen. Such pixels get EDGE_RAYS rays, with the ray of the first picture, before others get any.
 */
export const EDGES = [32, 8] as const;
export const EDGE_RAYS = 4;

/** What is traced in turn: rays `from` ≤ n < `to` of pixels that differ by more than `beyond`. */
const PASSES: readonly Pass[] = [
  ...EDGES.map((beyond) => ({ from: 0, to: EDGE_RAYS - 1, beyond })),
  ...ORDER.map((_, n) => ({ from: n, to: n + 1, beyond: -1 })),
];

interface Pass {
  readonly from: number;
  readonly to: number;
  readonly beyond: number;
}

/** Numbers of rays after which the whole picture is drawn: each drawing takes time. */
const SHOWN_AT = [2, 4, 8, 16] as const;

/** Traces more rays a pixel while no other picture is requested, edges first. */
interface Refiner extends Background {
  /** Sets the finished picture to refine; null for none. */
  setPicture(request: TraceRequest | null, stands: Picture | null): void;
  stop(): void;
  /** The finer picture; null before there is one. */
  finer(request: TraceRequest): Picture | null;
  /** How far it is; null if the picture is not refined. */
  progress(request: TraceRequest): Refined | null;
}

/** Rays of the grid that have been traced. */
export interface Refined {
  /** Of every pixel. */
  readonly everywhere: number;
  /** Of those at edges; no fewer. */
  readonly edges: number;
}

/** Linear light of each level. */
const LIGHT = Float64Array.from({ length: 256 }, (_, n) => decoded(n / 255));

const NOTHING: Refined = { everywhere: 0, edges: 0 };

export function createRefiner(): Refiner {
  let request: TraceRequest | null = null;
  /** The picture that stands, and by how much its pixels differ. */
  let coarse: Picture | null = null;
  let differences = new Uint8Array(0);
  /** The light of each pixel's rays, and the number of them. */
  let sums = new Float64Array(0);
  let counts = new Uint8Array(0);
  let at = 0;
  let part: PicturePart | null = null;
  let refined = NOTHING;
  let stopped = '';
  let shown: Picture | null = null;

  const is = ({ key }: TraceRequest): boolean => request?.key === key;

  /** Goes on to the next pass that has pixels. */
  const plan = (): void => {
    for (part = null; request && at < PASSES.length; at++) {
      const { from, to, beyond } = PASSES[at] as Pass;
      const pixels = counts.map((n, i) => +(n === from && (differences[i] as number) > beyond));
      if (pixels.includes(1)) {
        part = { samples: ORDER.slice(from, to), pixels };
        return;
      }
      if (beyond < 0) refined = { ...refined, everywhere: to };
    }
  };

  /**
   * Of each pixel the mean of all its rays, or of the grid once that is whole; those that it stands
   * with are `rays`.
   */
  const develop = ({ width, height, rgba: before, surface, t }: Picture, rays: number): Picture => {
    const rgba = new Uint8ClampedArray(before);
    for (let i = 0; i < width * height; i++) {
      const count = counts[i] as number;
      if (count === 0) continue;
      const others = count < MOST_SAMPLES ? rays : 0;
      for (let k = 4 * i; k < 4 * i + 3; k++) {
        const light = others * (LIGHT[before[k] as number] as number);
        rgba[k] = level(((sums[k - i] as number) + light) / (count + others));
      }
    }
    return { width, height, rgba, surface, t };
  };

  return {
    setPicture(now, stands) {
      if (now?.key === request?.key) return;
      request = stands && now;
      coarse = stands;
      const pixels = request ? request.settings.width * request.settings.height : 0;
      differences = stands && request ? differencesBeside(stands) : new Uint8Array(0);
      sums = new Float64Array(3 * pixels);
      counts = new Uint8Array(pixels);
      refined = NOTHING;
      shown = null;
      // A picture that was asked for with as many rays has no such edges.
      at = request && request.settings.samples >= EDGE_RAYS ? EDGES.length : 0;
      plan();
    },
    stop() {
      stopped = request?.key ?? '';
      if (!coarse || !request || refined.edges === 0) return;
      const { samples } = request.settings;
      shown = develop(coarse, samples);
      refined = { everywhere: refined.everywhere + samples, edges: refined.edges + samples };
    },
    next() {
      if (!request || !part || request.key === stopped) return null;
      const settings = { ...request.settings, samples: MOST_SAMPLES, part };
      return { ...request, key: `${request.key} pass ${at}`, settings, atOnce: true };
    },
    onResult(_, progress) {
      const { film } = progress.frame;
      const pass = PASSES[at];
      if (progress.state === 'failed' || !film || !part || !pass || !coarse || !request) {
        stopped = request?.key ?? '';
        return;
      }
      part.pixels.forEach((traced, i) => {
        if (traced === 0) return;
        counts[i] = pass.to;
        for (let k = 3 * i; k < 3 * i + 3; k++) {
          sums[k] = (sums[k] as number) + (film[k] as number);
        }
      });
      const isOfEdges = pass.beyond >= 0;
      refined = {
        everywhere: isOfEdges ? 0 : pass.to,
        edges: Math.max(pass.to, refined.edges),
      };
      at += 1;
      plan();
      if (isOfEdges || SHOWN_AT.some((n) => n === refined.everywhere)) {
        shown = develop(coarse, request.settings.samples);
      }
    },
    finer: (of) => (is(of) ? shown : null),
    progress: (of) => (is(of) ? refined : null),
  };
}

/** The first that has a picture to trace. */
export const oneAfterAnother = (...all: readonly Background[]): Background => {
  let last: Background | undefined;
  return {
    next() {
      for (const one of all) {
        const request = one.next();
        if (request) {
          last = one;
          return request;
        }
      }
      return null;
    },
    isEnough: (request, soFar) => last?.isEnough?.(request, soFar) ?? false,
    onResult(request, result) {
      last?.onResult(request, result);
    },
  };
};

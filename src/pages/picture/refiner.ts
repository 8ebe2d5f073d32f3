import { level } from '../../tracer/colour.ts';
import type { Picture } from '../../tracer/compare.ts';
import type { TraceProgress } from '../../workers/trace-job.ts';
import type { Background } from './trace-queue.ts';
import type { TraceRequest } from './trace-request.ts';

/** Rays a pixel at rest, on a square grid. */
export const MOST_SAMPLES = 16;

/** The grid's points in such an order that those that have been traced are spread out (Bayer). */
const ORDER = [0, 10, 2, 8, 5, 15, 7, 13, 1, 11, 3, 9, 4, 14, 6, 12] as const;

/** The picture is shown anew after so many: each takes time to be written as bytes. */
const SHOWN_AT = [2, 4, 8, 16] as const;

/** While nothing else is to be traced the picture gets more rays a pixel, one after another. */
interface Refiner extends Background {
  /** The picture that stands, which is refined; null for none. */
  of(request: TraceRequest | null): void;
  stop(): void;
  /** The finer picture; null before there is one. */
  frame(request: TraceRequest): Picture | null;
  /** Rays a pixel that have been traced; null if the picture is not refined. */
  done(request: TraceRequest): number | null;
}

export function createRefiner(): Refiner {
  let request: TraceRequest | null = null;
  let sums = new Float64Array(0);
  let passes = 0;
  let stopped = '';
  let shown: Picture | null = null;

  const is = ({ key }: TraceRequest): boolean => request?.key === key;

  const develop = ({ frame }: TraceProgress): Picture => {
    const { width, height, surface, t } = frame;
    const rgba = new Uint8ClampedArray(4 * width * height);
    for (let i = 0; i < width * height; i++) {
      for (let k = 0; k < 3; k++) {
        rgba[4 * i + k] = level((sums[3 * i + k] as number) / passes);
      }
      rgba[4 * i + 3] = 255;
    }
    return { width, height, rgba, surface, t };
  };

  return {
    of(next) {
      if (next?.key === request?.key) return;
      request = next;
      passes = 0;
      shown = null;
      sums = new Float64Array(next ? 3 * next.settings.width * next.settings.height : 0);
    },
    stop() {
      stopped = request?.key ?? '';
    },
    next() {
      const only = ORDER[passes];
      if (!request || only === undefined || request.key === stopped) return null;
      const settings = { ...request.settings, samples: MOST_SAMPLES, only };
      return { ...request, key: `${request.key} at ${only}`, settings, atOnce: true };
    },
    took(_, progress) {
      const { film } = progress.frame;
      if (progress.state === 'failed' || !film) {
        stopped = request?.key ?? '';
        return;
      }
      for (let i = 0; i < sums.length; i++) sums[i] = (sums[i] as number) + (film[i] as number);
      passes += 1;
      if (SHOWN_AT.some((n) => n === passes)) shown = develop(progress);
    },
    frame: (of) => (is(of) ? shown : null),
    done: (of) => (is(of) ? passes : null),
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
    enough: (request, soFar) => last?.enough?.(request, soFar) ?? false,
    took(request, result) {
      last?.took(request, result);
    },
  };
};

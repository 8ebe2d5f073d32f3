import { pixelsOf } from '../tracer/camera.ts';
import type { PicturePart, Tile } from '../tracer/types.ts';

/** Block sizes of the passes in px, coarse to fine. */
export const STEPS: readonly number[] = [8, 4, 2, 1];

/** Wanted time of a tile in ms: short for progress and cancelling, long enough for fast kernels. */
const MS_A_TILE = 60;
const MOST_PIXELS = 16_384;
const LEAST_PIXELS = 64;
/** Pixels of a tile before anything has been measured. */
const FIRST_PIXELS = 256;

interface Tiles {
  readonly total: number;
  /** The next tile; undefined after the last. A pass may begin before the one before is done. */
  next(): Tile | undefined;
  /** Reports the time of some pixels, by which later tiles are sized. */
  took(pixels: number, ms: number): void;
  /** The step of the pass that is given out now. */
  step(): number;
}

/**
 * Cuts a picture, or a part of it, into bands of rows, pass after pass; each pixel is in exactly
 * one tile.
 */
export function createTiles(
  width: number,
  height: number,
  workers: number,
  steps = STEPS,
  part?: PicturePart,
): Tiles {
  const total = part ? part.pixels.reduce((sum, one) => sum + one, 0) : width * height;
  let pass = 0;
  let row = 0;
  let pixels = FIRST_PIXELS;
  return {
    total,
    step: () => steps[Math.min(pass, steps.length - 1)] as number,
    took(count, ms) {
      const fitting = (count / Math.max(ms, 0.1)) * MS_A_TILE;
      // Rows differ, so the size moves only halfway to what was measured.
      pixels = Math.min(Math.max((pixels + fitting) / 2, LEAST_PIXELS), MOST_PIXELS);
    },
    next() {
      const step = steps[pass];
      if (step === undefined) return undefined;
      const refines = pass > 0;
      // In a refining pass every other row is already half traced.
      const aRow = (total / height / step) * (refines ? 0.75 : 1);
      const fair = (aRow * Math.ceil(height / step)) / workers;
      const rows = Math.max(1, Math.floor(Math.min(pixels, fair) / aRow));
      const y0 = row;
      const y1 = Math.min(height, y0 + rows * step);
      row = y1;
      if (row >= height) {
        row = 0;
        pass += 1;
      }
      const tile: Tile = { y0, y1, step, refines };
      return pixelsOf(tile, width, part).length > 0 ? tile : this.next();
    },
  };
}

import { pixelsOf } from '../tracer/camera.ts';
import type { Tile } from '../tracer/types.ts';

/** The blocks of the passes, coarse to fine. */
const STEPS: readonly number[] = [8, 4, 2, 1];

/**
 * A tile takes about this long: short enough to cancel and to show progress, long enough for the
 * kernels.
 */
const MS_A_TILE = 60;
const MOST_PIXELS = 16_384;
const LEAST_PIXELS = 64;
/** Before anything has been measured. */
const FIRST_PIXELS = 256;

interface Tiles {
  readonly total: number;
  /**
   * The next one, or undefined when all have been given out. A pass may begin before the last is
   * done.
   */
  next(): Tile | undefined;
  /** How long so many pixels took: later tiles are cut to measure. */
  took(pixels: number, ms: number): void;
  /** The step of the pass that is given out now. */
  step(): number;
}

/** Cuts a picture into bands of rows, pass after pass; each pixel is in exactly one tile. */
export function createTiles(width: number, height: number, workers: number): Tiles {
  let pass = 0;
  let row = 0;
  let pixels = FIRST_PIXELS;
  return {
    total: width * height,
    step: () => STEPS[Math.min(pass, STEPS.length - 1)] as number,
    took(count, ms) {
      const fitting = (count / Math.max(ms, 0.1)) * MS_A_TILE;
      // A coarse row says little about the next: halfway to what was measured.
      pixels = Math.min(Math.max((pixels + fitting) / 2, LEAST_PIXELS), MOST_PIXELS);
    },
    next() {
      const step = STEPS[pass];
      if (step === undefined) return undefined;
      const refines = pass > 0;
      // Every other row of a refining pass is half known.
      const aRow = (width / step) * (refines ? 0.75 : 1);
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
      return pixelsOf(tile, width).length > 0 ? tile : this.next();
    },
  };
}

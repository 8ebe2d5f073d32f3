import type { Border } from '../lab/atlas/borders.ts';
import type { MapFrame } from '../lab/atlas/frame.ts';
import { MARKS, type Mark, TENTHS } from '../lab/atlas/marks.ts';
import { SIDE } from '../lab/atlas/window.ts';

export type Rgb = readonly [number, number, number];

/** Share of ink, 0 … 1, at a pixel of a pattern whose motif has a side of `size` pixels. */
type Pattern = (x: number, y: number, size: number) => number;

const isFirstHalf = (x: number, size: number): boolean => x % size < size / 2;

/**
 * How a mark looks: by ink alone, solid, striped or dotted, so that it needs no colour. 'right' is
 * not here: its ink is the digits that are lost.
 */
export const PATTERNS: Readonly<Record<Exclude<Mark, 'right'>, Pattern>> = {
  misses: () => 1,
  invents: (x, y, size) => (isFirstHalf(x + y, size) ? 1 : 0.08),
  count: (_, y, size) => (isFirstHalf(y, size) ? 0.72 : 0.2),
  undecided: (x, y, size) => (isFirstHalf(x, size) && isFirstHalf(y, size) ? 0.9 : 0.04),
  nothing: (x, y, size) => ((x - y + SIDE * size * size) % (4 * size) < 1 ? 0.3 : 0),
};

const ALL_DIGITS = 16 * TENTHS;
/** Ink of a root without a right digit, and of one that has lost the least. */
const MOST = 0.5;
const LEAST = 0.05;

/** Ink of a pixel whose class is right, from the tenths of digits that are lost. */
export const inkOfLost = (lost: number): number =>
  lost < 1 ? 0 : LEAST + ((MOST - LEAST) * Math.min(lost, ALL_DIGITS)) / ALL_DIGITS;

/** Side of a pattern's motif in CSS pixels. */
const MOTIF = 5;

interface MapStyle {
  readonly paper: Rgb;
  readonly ink: Rgb;
  /** Pixels of the image per CSS pixel. */
  readonly density: number;
}

/**
 * A map of `side` by `side` places, row by row from the top, as RGBA. Borders are lines in
 * whichever of ink and paper stands out; a pixel that is not there yet is paper.
 */
export function paintMap(
  frame: MapFrame,
  borders: readonly Border[],
  side: number,
  { paper, ink, density }: MapStyle,
): Uint8ClampedArray<ArrayBuffer> {
  const rgba = new Uint8ClampedArray(4 * side * side);
  const cells = Int32Array.from({ length: side }, (_, x) => Math.floor((x * SIDE) / side));
  const size = Math.max(4, Math.round(MOTIF * density));
  const coverage = new Float32Array(side * side);
  for (let y = 0; y < side; y++) {
    const row = SIDE - 1 - (cells[y] as number);
    for (let x = 0; x < side; x++) {
      const pixel = row * SIDE + (cells[x] as number);
      coverage[y * side + x] = inkAt(frame, pixel, x, y, size);
    }
  }
  const width = Math.max(1, Math.round(density));
  for (const border of borders) drawBorder(coverage, border, side, width);
  for (let i = 0; i < coverage.length; i++) {
    const share = coverage[i] as number;
    for (let k = 0; k < 3; k++) {
      rgba[4 * i + k] = (paper[k] as number) * (1 - share) + (ink[k] as number) * share;
    }
    rgba[4 * i + 3] = 255;
  }
  return rgba;
}

function inkAt(frame: MapFrame, pixel: number, x: number, y: number, size: number): number {
  const mark = MARKS[frame.marks[pixel] as number];
  if (mark === undefined) return 0;
  return mark === 'right' ? inkOfLost(frame.lost[pixel] as number) : PATTERNS[mark](x, y, size);
}

/** Between a pixel and its neighbour: full ink on what is light there, else paper. */
function drawBorder(coverage: Float32Array, border: Border, side: number, width: number): void {
  const edge = (cell: number): number => Math.round((cell * side) / SIDE);
  const box = (x0: number, x1: number, y0: number, y1: number): void => {
    for (let y = Math.max(0, y0); y < Math.min(side, y1); y++) {
      for (let x = Math.max(0, x0); x < Math.min(side, x1); x++) {
        const at = y * side + x;
        coverage[at] = (coverage[at] as number) < 0.55 ? 1 : 0;
      }
    }
  };
  const half = width >> 1;
  for (const pixel of border.right) {
    const column = pixel % SIDE;
    const row = SIDE - 1 - Math.floor(pixel / SIDE);
    const x = edge(column + 1) - half;
    box(x, x + width, edge(row), edge(row + 1));
  }
  for (const pixel of border.above) {
    const column = pixel % SIDE;
    const row = SIDE - 1 - Math.floor(pixel / SIDE);
    const y = edge(row) - half;
    box(edge(column), edge(column + 1), y, y + width);
  }
}

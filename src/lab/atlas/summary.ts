import { bordersOf, distancesFrom } from './borders.ts';
import type { MapFrame } from './frame.ts';
import { MARKS, type Mark, markByte, PENDING, TENTHS } from './marks.ts';
import type { MapRequest } from './request.ts';
import { PIXELS, SIDE } from './window.ts';

/** What is wrong with a pixel, if anything. */
const WRONG: readonly Mark[] = ['misses', 'invents', 'count'];

/** What a map shows, in numbers. */
export interface MapSummary {
  /** Pixels that have a ray. */
  readonly rays: number;
  readonly counts: Readonly<Record<Mark, number>>;
  readonly wrong: number;
  /** Most digits of 16 that a root has lost where the class is right. */
  readonly mostLost: number;
  /** The border that most failing pixels are nearest to, and how far from it they reach. */
  readonly along: Along | null;
  /** Titles of all borders in the window. */
  readonly borders: readonly string[];
  /** Where the failing pixels lie: 'upper left', 'all over'; '' without one. */
  readonly where: string;
}

interface Along {
  readonly title: string;
  /** Pixels from the border within which 9 of 10 failing pixels lie. */
  readonly within: number;
}

/** Pixels that are wrong, or cannot tell. */
export function failingPixels({ marks }: MapFrame): number[] {
  const bytes = new Set([...WRONG, 'undecided' as const].map(markByte));
  const all: number[] = [];
  marks.forEach((mark, pixel) => {
    if (bytes.has(mark)) all.push(pixel);
  });
  return all;
}

export function summaryOf(request: MapRequest, frame: MapFrame): MapSummary {
  const counts = Object.fromEntries(MARKS.map((mark) => [mark, 0])) as Record<Mark, number>;
  let mostLost = 0;
  for (let pixel = 0; pixel < PIXELS; pixel++) {
    const mark = frame.marks[pixel] as number;
    if (mark === PENDING) continue;
    counts[MARKS[mark] as Mark] += 1;
    mostLost = Math.max(mostLost, frame.lost[pixel] as number);
  }
  const failing = failingPixels(frame);
  // The rays that leave a surface have other classes than the rays that come.
  const borders = request.start ? [] : bordersOf(request.shape, frame);
  const all = borders.map((border) => ({
    title: border.title,
    within: ninth(failing, distancesFrom(border)),
  }));
  const [along] = failing.length > 0 ? all.sort((a, b) => a.within - b.within) : [];
  return {
    rays: Object.values(counts).reduce((a, b) => a + b, 0) - counts.nothing,
    counts,
    wrong: WRONG.reduce((sum, mark) => sum + counts[mark], 0),
    mostLost: mostLost / TENTHS,
    along: along ?? null,
    borders: borders.map(({ title }) => title),
    where: whereOf(failing),
  };
}

/** The distance that 9 of 10 do not exceed. */
function ninth(pixels: readonly number[], distances: Int16Array): number {
  const sorted = pixels.map((pixel) => distances[pixel] as number).sort((a, b) => a - b);
  return sorted[Math.max(0, Math.ceil(0.9 * sorted.length) - 1)] ?? 0;
}

const ACROSS = ['left', '', 'right'] as const;
const UP = ['lower', '', 'upper'] as const;
/** Share of the window's side from which pixels that reach so far are called all over it. */
const WIDE = 0.7;

function whereOf(pixels: readonly number[]): string {
  if (pixels.length === 0) return '';
  const columns = pixels.map((pixel) => pixel % SIDE).sort((a, b) => a - b);
  const rows = pixels.map((pixel) => Math.floor(pixel / SIDE));
  rows.sort((a, b) => a - b);
  const span = (sorted: readonly number[]) => ((sorted.at(-1) ?? 0) - (sorted[0] ?? 0)) / SIDE;
  const third = (sorted: readonly number[]): number =>
    Math.floor((3 * (sorted[sorted.length >> 1] ?? 0)) / SIDE);
  const isWide = span(columns) > WIDE;
  const isHigh = span(rows) > WIDE;
  if (isWide && isHigh) return 'from side to side and from top to bottom';
  const left = isWide ? '' : ACROSS[third(columns)];
  const up = isHigh ? '' : UP[third(rows)];
  if (isWide) return up ? `from side to side, in the ${up} part` : 'from side to side, half-way up';
  if (isHigh)
    return left ? `from top to bottom, at the ${left}` : 'from top to bottom, in the middle';
  if (up && left) return `at the ${up} ${left}`;
  return up || left ? `in the ${up || left} part` : 'in the middle';
}

import { type Comparison, OTHER_COLOUR, OTHER_VERDICT } from '../../tracer/compare.ts';

type Rgb = readonly [number, number, number];

/** Darkness of a pixel, 0 to 1: least for digits of t, more for a colour, 1 for a surface. */
const MOST_FOR_DIGITS = 0.4;
const FOR_COLOUR = 0.62;
const ALL_DIGITS = 16;

/** The differences of two pictures in ink on paper. */
export function errorMap(
  { map, digits }: Comparison,
  width: number,
  height: number,
  paper: Rgb,
  ink: Rgb,
): ImageData {
  const data = new ImageData(width, height);
  for (let i = 0; i < map.length; i++) {
    const s = darkness(map[i] ?? 0, digits[i] ?? 0);
    for (let k = 0; k < 3; k++) {
      data.data[4 * i + k] = (paper[k] ?? 0) * (1 - s) + (ink[k] ?? 0) * s;
    }
    data.data[4 * i + 3] = 255;
  }
  return data;
}

function darkness(kind: number, lost: number): number {
  if (kind === OTHER_VERDICT) return 1;
  if (kind === OTHER_COLOUR) return FOR_COLOUR;
  return lost > 0 ? 0.1 + ((MOST_FOR_DIGITS - 0.1) * lost) / ALL_DIGITS : 0;
}

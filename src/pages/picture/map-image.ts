import { type Heat, shadeOf } from '../../state/picture/heat.ts';
import { type Comparison, OTHER_COLOUR, OTHER_VERDICT } from '../../tracer/compare.ts';

type Rgb = readonly [number, number, number];

/** Darkness of a pixel, 0 to 1: least for digits of t, more for a colour, 1 for a surface. */
const FOR_SURFACE = 1;
const FOR_COLOUR = 0.62;
const MOST_FOR_DIGITS = 0.4;
const ALL_DIGITS = 16;

const forDigits = (lost: number): number =>
  lost > 0 ? 0.1 + ((MOST_FOR_DIGITS - 0.1) * lost) / ALL_DIGITS : 0;

/** The differences of two pictures in ink on paper. */
export const errorImage =
  ({ map, digits }: Comparison) =>
  (i: number): number => {
    if (map[i] === OTHER_VERDICT) return FOR_SURFACE;
    return map[i] === OTHER_COLOUR ? FOR_COLOUR : forDigits(digits[i] ?? 0);
  };

/** Numbers of pixels in ink on paper. */
export const heatImage =
  (heat: Heat, values: Uint32Array) =>
  (i: number): number =>
    shadeOf(heat, values[i] ?? 0);

/** An image of shades, 0 being paper and 1 ink. */
export function shaded(
  width: number,
  height: number,
  [paper, ink]: readonly [Rgb, Rgb],
  shade: (i: number) => number,
): ImageData {
  const data = new ImageData(width, height);
  for (let i = 0; i < width * height; i++) {
    const s = shade(i);
    for (let k = 0; k < 3; k++) {
      data.data[4 * i + k] = (paper[k] ?? 0) * (1 - s) + (ink[k] ?? 0) * s;
    }
    data.data[4 * i + 3] = 255;
  }
  return data;
}

import type { Vec3 } from '../math/index.ts';
import type { Colour } from '../scene/types.ts';

/* sRGB (IEC 61966-2-1) and linear light. */

/** The steepest slope of `encoded`, at black. */
export const STEEPEST = 12.92;

/** Linear light 0 … 1 as sRGB 0 … 1. */
export const encoded = (x: number): number =>
  x <= 0.0031308 ? STEEPEST * x : 1.055 * x ** (1 / 2.4) - 0.055;

/** sRGB 0 … 1 as linear light. */
export const decoded = (x: number): number =>
  x <= 0.04045 ? x / STEEPEST : ((x + 0.055) / 1.055) ** 2.4;

/** '#rrggbb' as linear light. */
export function linear(colour: Colour): Vec3 {
  const channel = (k: number): number =>
    decoded(Number.parseInt(colour.slice(2 * k + 1, 2 * k + 3), 16) / 255);
  return [channel(0), channel(1), channel(2)];
}

/** Linear light as a byte. */
export function level(x: number): number {
  return Math.round(255 * encoded(x < 1 ? x : 1));
}

/** Largest |coordinate| in px of a drawing: beyond any screen, but safe in all browsers. */
export const FARTHEST = 1e5;

/**
 * A coordinate for SVG in CSS px, rounded to hundredths and clamped to `FARTHEST`; 0 for NaN. Every
 * number that goes into SVG is made by this function.
 */
export function coordinate(px: number): number {
  if (Number.isNaN(px)) return 0;
  // + 0 turns −0 into 0.
  return Math.round(Math.min(Math.max(px, -FARTHEST), FARTHEST) * 100) / 100 + 0;
}

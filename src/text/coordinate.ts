/** Farther out than any screen, and still a number that every browser draws with. */
export const FARTHEST = 1e5;

/**
 * A coordinate for a drawing in CSS px: hundredths, never beyond what browsers can draw, and 0 for
 * no number. Every number that goes into SVG passes here.
 */
export function coordinate(px: number): number {
  if (Number.isNaN(px)) return 0;
  // + 0 makes −0 a plain zero.
  return Math.round(Math.min(Math.max(px, -FARTHEST), FARTHEST) * 100) / 100 + 0;
}

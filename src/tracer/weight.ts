import type { MediumBody, World } from '../scene/effects/body.ts';
import { STEEPEST } from './colour.ts';

/*
 * Decides when a ray is not worth firing. Half a level of a pixel's byte is 1/510 of sRGB; since
 * sRGB rises by at most 12.92 for 1 of linear light, a change of less than HALF_A_LEVEL of linear
 * light is less than half a level, however dark the pixel.
 *
 * A ray that would arrive with weight w can bring at most w · brightest(world), with all that
 * descends from it: if that is below HALF_A_LEVEL it is not fired. The bound is for one ray. Glass
 * can leave out several for one pixel; a budget for their sum was tried, and once it is spent rays
 * of 1e-10 have to be followed (450 million of them in one picture). That the picture as a whole
 * stays within one level is tested on scenes, not proved.
 */
export const HALF_A_LEVEL = 0.5 / 255 / STEEPEST;

/** Most bounces of a ray, as between perfect mirrors its weight never decreases; 0.85 needs 54. */
export const MOST_BOUNCES = 64;

/**
 * No ray brings more than this. A background brings at most 1. A surface's own light is at most
 * ambient + Σ strength (paint ≤ 1, cosine ≤ 1) plus shine · Σ strength, times 1 − mirror; a mirror
 * adds `mirror` of what another ray brings; glass shows shine · Σ strength and 1 − shine of what
 * other rays bring, of which Fresnel gives R to one and 1 − R to the other. So if others bring at
 * most L, so does this one: L = max(1, ambient + (1 + the largest shine) Σ strength).
 *
 * Light that joins on the way comes on top: with s(L) for the most that a ray shows at its start, a
 * ray of the last generation shows at most s(L), one before it s(s(L)), and so on. The first body's
 * light is the nearest, so it comes last.
 */
export function brightest(world: World, ambient: number, ways: readonly MediumBody[]): number {
  const { materials, lights } = world;
  const light = lights.reduce((sum, { colour }) => sum + Math.max(...colour), 0);
  const shine = materials.reduce((most, material) => Math.max(most, material.shine), 0);
  let most = Math.max(1, ambient + (1 + shine) * light);
  for (let generation = 0; generation <= MOST_BOUNCES; generation++) {
    for (const way of ways.toReversed()) most = way.brightest(world, most);
  }
  return most;
}

import type { ShadowRays, Wave } from './body.ts';

/**
 * Adds a shadow ray from the hit of the wave's ray i along a direction of length 1; `limit` is the
 * distance to the light.
 */
export function addShadowRay(
  wave: Wave,
  i: number,
  shadowRays: ShadowRays,
  x: number,
  y: number,
  z: number,
  limit: number,
): void {
  const { rays } = shadowRays;
  const j = shadowRays.count;
  rays.Ex[j] = wave.Px[i] as number;
  rays.Ey[j] = wave.Py[i] as number;
  rays.Ez[j] = wave.Pz[i] as number;
  rays.dx[j] = x;
  rays.dy[j] = y;
  rays.dz[j] = z;
  shadowRays.limit[j] = limit;
  shadowRays.from[j] = wave.surface[i] as number;
  shadowRays.node[j] = wave.node[i] as number;
  shadowRays.sample[j] = wave.sample[i] as number;
  shadowRays.count = j + 1;
}

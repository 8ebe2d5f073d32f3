import type { Feelers, Wave } from './body.ts';

/**
 * Adds a shadow ray from the hit of the wave's ray i along a direction of length 1; `limit` is the
 * distance to the light.
 */
export function addFeeler(
  wave: Wave,
  i: number,
  feelers: Feelers,
  x: number,
  y: number,
  z: number,
  limit: number,
): void {
  const { rays } = feelers;
  const j = feelers.count;
  rays.Ex[j] = wave.Px[i] as number;
  rays.Ey[j] = wave.Py[i] as number;
  rays.Ez[j] = wave.Pz[i] as number;
  rays.dx[j] = x;
  rays.dy[j] = y;
  rays.dz[j] = z;
  feelers.limit[j] = limit;
  feelers.from[j] = wave.surface[i] as number;
  feelers.node[j] = wave.node[i] as number;
  feelers.sample[j] = wave.sample[i] as number;
  feelers.count = j + 1;
}

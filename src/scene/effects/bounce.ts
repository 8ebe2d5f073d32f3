import { REFLECTED, REFRACTED, type Wave } from './body.ts';

/**
 * Fires the mirrored ray, d − 2(d·N)N, from the stored hit point, with the share `weight` of the
 * ray's light. Returns its index in `next`.
 */
export function mirrored(wave: Wave, i: number, next: Wave, weight: number): number {
  const j = follow(wave, i, next, weight, REFLECTED);
  const x = wave.Nx[i] as number;
  const y = wave.Ny[i] as number;
  const z = wave.Nz[i] as number;
  const dx = wave.rays.dx[i] as number;
  const dy = wave.rays.dy[i] as number;
  const dz = wave.rays.dz[i] as number;
  const twice = 2 * (dx * x + dy * y + dz * z);
  next.rays.dx[j] = dx - twice * x;
  next.rays.dy[j] = dy - twice * y;
  next.rays.dz[j] = dz - twice * z;
  next.medium[j] = wave.medium[i] as number;
  return j;
}

/** Odd numbers by kind of ray, so that each branch of a path gets a seed of its own. */
const TURNS: readonly number[] = [0, 0x51ed270b, 0x2545f491];

/** Adds a ray of the next generation at the hit of ray i, without direction and medium. */
function follow(
  wave: Wave,
  i: number,
  next: Wave,
  weight: number,
  kind: typeof REFLECTED | typeof REFRACTED,
): number {
  const j = next.count;
  next.count = j + 1;
  next.rays.count = j + 1;
  next.rays.Ex[j] = wave.Px[i] as number;
  next.rays.Ey[j] = wave.Py[i] as number;
  next.rays.Ez[j] = wave.Pz[i] as number;
  next.sample[j] = wave.sample[i] as number;
  const path = Math.imul((wave.path[i] as number) ^ (TURNS[kind] as number), 0x85ebca6b);
  next.path[j] = path ^ (path >>> 13);
  next.kind[j] = kind;
  next.from[j] = wave.surface[i] as number;
  next.red[j] = (wave.red[i] as number) * weight;
  next.green[j] = (wave.green[i] as number) * weight;
  next.blue[j] = (wave.blue[i] as number) * weight;
  next.node[j] = wave.node[i] as number;
  return j;
}

/** The largest of a ray's weights. */
export const weightOf = (wave: Wave, i: number): number =>
  Math.max(wave.red[i] as number, wave.green[i] as number, wave.blue[i] as number);

/** Cosine between the ray and the normal on its side. */
export const cosineOf = ({ rays, Nx, Ny, Nz }: Wave, i: number): number =>
  -(
    (rays.dx[i] as number) * (Nx[i] as number) +
    (rays.dy[i] as number) * (Ny[i] as number) +
    (rays.dz[i] as number) * (Nz[i] as number)
  );

/**
 * Fires the bent ray by Snell's law: d's tangential part times eta, and a normal part that makes
 * the length 1. Returns its index in `next`.
 */
export function bent(
  wave: Wave,
  i: number,
  next: Wave,
  weight: number,
  eta: number,
  cosine: number,
): number {
  const j = follow(wave, i, next, weight, REFRACTED);
  const inwards = Math.sqrt(Math.max(0, 1 - eta * eta * (1 - cosine * cosine)));
  const along = eta * cosine - inwards;
  next.rays.dx[j] = eta * (wave.rays.dx[i] as number) + along * (wave.Nx[i] as number);
  next.rays.dy[j] = eta * (wave.rays.dy[i] as number) + along * (wave.Ny[i] as number);
  next.rays.dz[j] = eta * (wave.rays.dz[i] as number) + along * (wave.Nz[i] as number);
  next.medium[j] = wave.back[i] === 1 ? -1 : (wave.surface[i] as number);
  return j;
}

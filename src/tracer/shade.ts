import type { AddLight, Lit, SurfaceMaterial, Wave, WorldLight } from '../scene/effects/body.ts';
import type { Background } from '../scene/types.ts';
import { linear } from './colour.ts';
import type { TracerWorld } from './world.ts';

/* Shading that every picture has: points, normals, paint, and light on it. */

/** Lists the rays that hit something, and computes their points and normals. */
export function meet(wave: Wave, { targets }: TracerWorld): void {
  const { rays, t, surface, hits, Px, Py, Pz, Nx, Ny, Nz } = wave;
  let n = 0;
  for (let i = 0; i < wave.count; i++) {
    const target = targets[surface[i] as number];
    if (!target) continue;
    hits[n++] = i;
    const dx = rays.dx[i] as number;
    const dy = rays.dy[i] as number;
    const dz = rays.dz[i] as number;
    const at = t[i] as number;
    const px = (rays.Ex[i] as number) + at * dx;
    const py = (rays.Ey[i] as number) + at * dy;
    const pz = (rays.Ez[i] as number) + at * dz;
    const { by, N, center, a } = target.gradient;
    let x = by === 'plane' ? N[0] : px - center[0];
    let y = by === 'plane' ? N[1] : -a * (py - center[1]);
    let z = by === 'plane' ? N[2] : pz - center[2];
    if (by === 'trees') [x, y, z] = target.gradient.at(px, py, pz);
    const length = Math.sqrt(x * x + y * y + z * z);
    if (length > 0) {
      x /= length;
      y /= length;
      z /= length;
    } else {
      // At a vertex the gradient is 0: the normal is taken to face the ray.
      x = -dx;
      y = -dy;
      z = -dz;
    }
    const behind = x * dx + y * dy + z * dz > 0;
    Px[i] = px;
    Py[i] = py;
    Pz[i] = pz;
    Nx[i] = behind ? -x : x;
    Ny[i] = behind ? -y : y;
    Nz[i] = behind ? -z : z;
    wave.back[i] = behind ? 1 : 0;
  }
  wave.hitCount = n;
}

/** Sets the paint's colour, and the ambient light. */
export function paint(wave: Wave, { materials }: TracerWorld, ambient: number): void {
  for (let h = 0; h < wave.hitCount; h++) {
    const i = wave.hits[h] as number;
    const { colour } = materials[wave.surface[i] as number] as SurfaceMaterial;
    wave.paintR[i] = colour[0];
    wave.paintG[i] = colour[1];
    wave.paintB[i] = colour[2];
    wave.lightR[i] = ambient;
    wave.lightG[i] = ambient;
    wave.lightB[i] = ambient;
    wave.glossR[i] = 0;
    wave.glossG[i] = 0;
    wave.glossB[i] = 0;
  }
}

/** Lists the hits that face the light and whose material shows light. */
export function face(wave: Wave, { materials }: TracerWorld, light: WorldLight, lit: Lit): void {
  const [ax, ay, az] = light.at;
  let n = 0;
  for (let h = 0; h < wave.hitCount; h++) {
    const i = wave.hits[h] as number;
    const material = materials[wave.surface[i] as number] as SurfaceMaterial;
    if (material.matte === 0 && (material.shine === 0 || material.glossy === 0)) continue;
    let x = ax;
    let y = ay;
    let z = az;
    let distance = Number.POSITIVE_INFINITY;
    if (!light.sun) {
      x -= wave.Px[i] as number;
      y -= wave.Py[i] as number;
      z -= wave.Pz[i] as number;
      distance = Math.sqrt(x * x + y * y + z * z);
      x /= distance;
      y /= distance;
      z /= distance;
    }
    const cosine =
      x * (wave.Nx[i] as number) + y * (wave.Ny[i] as number) + z * (wave.Nz[i] as number);
    // Also if the light is at the hit, where the cosine is NaN.
    if (!(cosine > 0)) continue;
    lit.ray[n] = i;
    lit.Lx[n] = x;
    lit.Ly[n] = y;
    lit.Lz[n] = z;
    lit.distance[n] = distance;
    lit.cosine[n] = cosine;
    lit.reach[n] = 1;
    lit.red[n] = 1;
    lit.green[n] = 1;
    lit.blue[n] = 1;
    n += 1;
  }
  lit.count = n;
}

/** Diffuse light by Lambert's law. */
export function light(wave: Wave, lit: Lit): void {
  const [red, green, blue] = lit.light.colour;
  for (let k = 0; k < lit.count; k++) {
    const i = lit.ray[k] as number;
    const amount = (lit.reach[k] as number) * (lit.cosine[k] as number);
    wave.lightR[i] = (wave.lightR[i] as number) + amount * red * (lit.red[k] as number);
    wave.lightG[i] = (wave.lightG[i] as number) + amount * green * (lit.green[k] as number);
    wave.lightB[i] = (wave.lightB[i] as number) + amount * blue * (lit.blue[k] as number);
  }
}

/** Linear light of the samples: three doubles each, red, green, blue. */
export type Film = Float64Array;

/** A function that adds light along a wave's rays to the film. */
export const adderOf =
  ({ sample }: Wave, film: Film): AddLight =>
  (i, red, green, blue) => {
    const at = 3 * (sample[i] as number);
    film[at] = (film[at] as number) + red;
    film[at + 1] = (film[at + 1] as number) + green;
    film[at + 2] = (film[at + 2] as number) + blue;
  };

/** Adds each ray's light to its sample, in the order of the wave. */
export function gather(
  wave: Wave,
  { materials }: TracerWorld,
  { low, high }: Background,
  film: Film,
): void {
  const below = linear(low);
  const above = linear(high);
  for (let i = 0; i < wave.count; i++) {
    const at = 3 * (wave.sample[i] as number);
    const material = materials[wave.surface[i] as number];
    let r: number;
    let g: number;
    let b: number;
    if (material) {
      const { matte } = material;
      r =
        matte * (wave.paintR[i] as number) * (wave.lightR[i] as number) +
        (wave.glossR[i] as number);
      g =
        matte * (wave.paintG[i] as number) * (wave.lightG[i] as number) +
        (wave.glossG[i] as number);
      b =
        matte * (wave.paintB[i] as number) * (wave.lightB[i] as number) +
        (wave.glossB[i] as number);
    } else {
      const up = Math.min(1, Math.max(0, ((wave.rays.dy[i] as number) + 1) / 2));
      r = below[0] + up * (above[0] - below[0]);
      g = below[1] + up * (above[1] - below[1]);
      b = below[2] + up * (above[2] - below[2]);
    }
    film[at] = (film[at] as number) + (wave.red[i] as number) * r;
    film[at + 1] = (film[at + 1] as number) + (wave.green[i] as number) * g;
    film[at + 2] = (film[at + 2] as number) + (wave.blue[i] as number) * b;
  }
}

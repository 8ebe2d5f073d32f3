import { createRays, kernelArray } from '../math/batch.ts';
import type { Lit, ShadowRays, Wave, WorldLight } from '../scene/effects/body.ts';

const doubles = (n: number): Float64Array => new Float64Array(n);
const whole = (n: number): Int32Array => new Int32Array(n);

export function createWave(capacity: number): Wave {
  const n = capacity;
  return {
    count: 0,
    depth: 0,
    rays: createRays(n, kernelArray),
    sample: whole(n),
    path: whole(n),
    from: whole(n),
    medium: whole(n),
    kind: new Uint8Array(n),
    red: doubles(n),
    green: doubles(n),
    blue: doubles(n),
    node: whole(n),
    asked: whole(n),
    found: whole(n),
    t: doubles(n),
    surface: whole(n),
    hitCount: 0,
    hits: whole(n),
    Px: doubles(n),
    Py: doubles(n),
    Pz: doubles(n),
    Nx: doubles(n),
    Ny: doubles(n),
    Nz: doubles(n),
    back: new Uint8Array(n),
    paintR: doubles(n),
    paintG: doubles(n),
    paintB: doubles(n),
    lightR: doubles(n),
    lightG: doubles(n),
    lightB: doubles(n),
    glossR: doubles(n),
    glossG: doubles(n),
    glossB: doubles(n),
  };
}

export const capacityOf = (wave: Wave): number => wave.t.length;

/**
 * The wave itself if it has room for `more`, else a larger one with the same rays (not yet
 * followed).
 */
export function withRoom(wave: Wave, more: number): Wave {
  if (wave.count + more <= capacityOf(wave)) return wave;
  const larger = createWave(2 * (wave.count + more));
  larger.count = wave.count;
  larger.depth = wave.depth;
  larger.rays.count = wave.count;
  const { rays } = wave;
  larger.rays.Ex.set(rays.Ex);
  larger.rays.Ey.set(rays.Ey);
  larger.rays.Ez.set(rays.Ez);
  larger.rays.dx.set(rays.dx);
  larger.rays.dy.set(rays.dy);
  larger.rays.dz.set(rays.dz);
  larger.sample.set(wave.sample);
  larger.path.set(wave.path);
  larger.from.set(wave.from);
  larger.medium.set(wave.medium);
  larger.kind.set(wave.kind);
  larger.red.set(wave.red);
  larger.green.set(wave.green);
  larger.blue.set(wave.blue);
  larger.node.set(wave.node);
  return larger;
}

export function clear(wave: Wave, depth: number): void {
  wave.count = 0;
  wave.rays.count = 0;
  wave.hitCount = 0;
  wave.depth = depth;
}

export function createShadowRays(capacity: number): ShadowRays {
  return {
    count: 0,
    rays: createRays(capacity, kernelArray),
    limit: doubles(capacity),
    from: whole(capacity),
    blocker: whole(capacity),
    t: doubles(capacity),
    node: whole(capacity),
    sample: whole(capacity),
    asked: whole(capacity),
    found: whole(capacity),
  };
}

export function createLit(light: WorldLight, capacity: number): Lit {
  return {
    count: 0,
    light,
    ray: whole(capacity),
    Lx: doubles(capacity),
    Ly: doubles(capacity),
    Lz: doubles(capacity),
    distance: doubles(capacity),
    cosine: doubles(capacity),
    reach: doubles(capacity),
    red: doubles(capacity),
    green: doubles(capacity),
    blue: doubles(capacity),
  };
}

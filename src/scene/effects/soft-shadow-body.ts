import { seeded } from '../../math/rng.ts';
import type { LightBody, Lit, ShadowRays, Wave } from './body.ts';
import { addShadowRay } from './shadow-rays.ts';

/** Shadow rays per call: enough for fast kernels, few enough to stay in the cache. */
const AT_ONCE = 4096;

/** Number of random point sets that are drawn once; a hit uses one, rotated by a random angle. */
const SETS = 64;
const SEED = 2026;

/** Point sets by points per side of the grid: x and y of each point of a unit disc. */
const drawn = new Map<number, Float64Array>();

/** A jittered square grid, mapped onto the disc with equal areas. */
function pointsOf(side: number): Float64Array {
  const known = drawn.get(side);
  if (known) return known;
  const random = seeded(SEED);
  const points = new Float64Array(2 * SETS * side * side);
  for (let k = 0; k < SETS * side * side; k++) {
    const u = Math.floor(k / side) % side;
    const r = Math.sqrt((u + random()) / side);
    const angle = (2 * Math.PI * ((k % side) + random())) / side;
    points[2 * k] = r * Math.cos(angle);
    points[2 * k + 1] = r * Math.sin(angle);
  }
  drawn.set(side, points);
  return points;
}

/**
 * Shadow rays to points of the light's disc as seen from the hit. The points depend on the path
 * from the camera only, not on the order in which hits are processed.
 */
export const body: LightBody = {
  at: 'light',
  run(wave, lit, tools, all) {
    if (lit.light.radius === 0 && !all) return;
    const side = Math.max(1, Math.round(Math.sqrt(tools.lightSamples)));
    const each = side * side;
    const hits = Math.max(1, Math.floor(AT_ONCE / each));
    const askedBy = new Int32Array(hits * each);
    for (let first = 0; first < lit.count; first += hits) {
      const last = Math.min(first + hits, lit.count);
      const shadowRays = tools.shadowRays((last - first) * each);
      for (let k = first; k < last; k++) aim(wave, lit, k, side, shadowRays, askedBy);
      tools.findBlockers(shadowRays, lit.light);
      count(lit, first, last, each, shadowRays, askedBy);
    }
  },
};

function aim(
  wave: Wave,
  lit: Lit,
  k: number,
  side: number,
  shadowRays: ShadowRays,
  askedBy: Int32Array,
): void {
  const i = lit.ray[k] as number;
  const chance = mixed(Math.imul((wave.path[i] as number) ^ 0x9e3779b9, lit.light.index + 1));
  const points = pointsOf(side);
  const each = 2 * side * side;
  const first = (chance & (SETS - 1)) * each;
  const turn = (2 * Math.PI * (chance >>> 6)) / 2 ** 26;
  const { radius } = lit.light;
  const c = radius * Math.cos(turn);
  const w = radius * Math.sin(turn);
  const x = lit.Lx[k] as number;
  const y = lit.Ly[k] as number;
  const z = lit.Lz[k] as number;
  const distance = lit.distance[k] as number;
  // Orthonormal basis: Duff et al. 2017, Building an orthonormal basis, revisited.
  const s = z < 0 ? -1 : 1;
  const a = -1 / (s + z);
  const b = x * y * a;
  for (let at = first; at < first + each; at += 2) {
    const u = points[at] as number;
    const v = points[at + 1] as number;
    const p = c * u - w * v;
    const q = w * u + c * v;
    askedBy[shadowRays.count] = k;
    if (radius === 0) put(wave, i, shadowRays, x, y, z, distance);
    else {
      const dx = x * distance + p * (1 + s * x * x * a) + q * b;
      const dy = y * distance + p * s * b + q * (s + y * y * a);
      const dz = z * distance - p * s * x - q * y;
      const length = Math.sqrt(dx * dx + dy * dy + dz * dz);
      put(wave, i, shadowRays, dx / length, dy / length, dz / length, length);
    }
  }
}

/** A hash of 32 bits (the finalizer of MurmurHash3, Appleby, public domain). */
function mixed(bits: number): number {
  let h = bits ^ (bits >>> 16);
  h = Math.imul(h, 0x85ebca6b);
  h = Math.imul(h ^ (h >>> 13), 0xc2b2ae35);
  return (h ^ (h >>> 16)) >>> 0;
}

/** Adds a shadow ray, unless the light's point is below the surface's horizon. */
function put(
  wave: Wave,
  i: number,
  shadowRays: ShadowRays,
  x: number,
  y: number,
  z: number,
  limit: number,
): void {
  const above =
    x * (wave.Nx[i] as number) + y * (wave.Ny[i] as number) + z * (wave.Nz[i] as number);
  if (!(above > 0)) return;
  addShadowRay(wave, i, shadowRays, x, y, z, limit);
}

/** Sets the share of the points that are visible. */
function count(
  lit: Lit,
  first: number,
  last: number,
  each: number,
  shadowRays: ShadowRays,
  askedBy: Int32Array,
): void {
  let j = 0;
  for (let k = first; k < last; k++) {
    let free = 0;
    for (; j < shadowRays.count && askedBy[j] === k; j++) {
      if ((shadowRays.blocker[j] as number) < 0) free += 1;
    }
    lit.reach[k] = (lit.reach[k] as number) * (free / each);
  }
}

import { chooseFirst, type Rays } from '../../batch/batch.ts';
import {
  addressOf,
  BLOCK,
  CAPACITY,
  GAP,
  NUMBERS,
  part,
  type Run,
  SCRATCH,
  SCRATCH_BYTES,
  type SimdMemory,
} from '../../batch/simd-memory.ts';
import { SURFACE_COUNT, surfaceNumbers } from './from-surface.ts';
import type { FastRoots, FastStages } from './kernel.ts';

/*
 * What certified's kernels keep in the shared memory (batch/simd-memory.ts): the shape's numbers,
 * and in the scratch lists of rays that a stage leaves to the next one and what parts of a kernel
 * hand on. All in bytes.
 */

/**
 * Rays that the passes over ordinary ones hand on, so that these numbers stay in the first cache.
 */
export const HANDED = 128;

/** Where the constants of the ordinary rays' passes and of the stages after them begin. */
export const LATTICE_NUMBERS = NUMBERS;
export const SCALED_NUMBERS = NUMBERS + 512;
export const SURFACE_NUMBERS = SCALED_NUMBERS + 128;
/** tMin and tMax. */
export const INTERVAL = SURFACE_NUMBERS + 8 * SURFACE_COUNT;

/** The arrays of a block's rays. */
export const INPUTS = ['Ex', 'Ey', 'Ez', 'dx', 'dy', 'dz'] as const;
export type Input = (typeof INPUTS)[number];

/** The arrays whose addresses a kernel is given. */
export const PARAMS = ['Ex', 'Ey', 'Ez', 'dx', 'dy', 'dz', 't0', 't1'] as const;
export type Param = (typeof PARAMS)[number];

/** Rays of a call where none is copied: each has its place in the lists. */
export const LONG = 4 * CAPACITY;
const LIST_BYTES = 4 * LONG + GAP;

/** Where each array begins. The lists hold the rays' indices, and have room for one more. */
export const PLACE = {
  Ex: BLOCK.Ex,
  Ey: BLOCK.Ey,
  Ez: BLOCK.Ez,
  dx: BLOCK.dx,
  dy: BLOCK.dy,
  dz: BLOCK.dz,
  t0: BLOCK.t0,
  t1: BLOCK.t1,
  margin: BLOCK.margin,
  doubtful: SCRATCH,
  unsettled: SCRATCH + LIST_BYTES,
  starting: SCRATCH + 2 * LIST_BYTES,
  doubtfulBytes: SCRATCH + 3 * LIST_BYTES,
  startingBytes: SCRATCH + 3 * LIST_BYTES + 4,
} as const;

const HANDED_START = PLACE.doubtfulBytes + 64;
const HANDED_BYTES = 8 * HANDED + 64;
const HANDED_END = SCRATCH + SCRATCH_BYTES;

/**
 * Where the value number n that a part hands on is kept, for each ray of a lot. Throws RangeError
 * where there is no room for so many.
 */
export function handed(n: number): number {
  const start = HANDED_START + n * HANDED_BYTES;
  if (start + HANDED_BYTES > HANDED_END) {
    throw new RangeError(`no room to hand on ${n + 1} values`);
  }
  return start;
}

/**
 * Both roots by WebAssembly, two rays at a time: `bytes` is the module that scripts/kernels
 * compiles from the stages' own text, and so to the same bits (generated/certified-simd.ts).
 * Throws what the engine throws where it does not run them.
 */
export function createFastStages(memory: SimdMemory, bytes: Uint8Array): FastStages {
  const { buffer, block } = memory;
  const exports = memory.load(bytes);
  const indices = (offset: number): Int32Array => new Int32Array(buffer, offset, LONG + 1);
  const latticeNumbers = new Float64Array(
    buffer,
    LATTICE_NUMBERS,
    (SCALED_NUMBERS - LATTICE_NUMBERS) / 8,
  );
  const scaledNumbers = new Float64Array(buffer, SCALED_NUMBERS, 16);
  const surface = new Float64Array(buffer, SURFACE_NUMBERS, SURFACE_COUNT);
  const doubtful = indices(PLACE.doubtful);
  const unsettled = indices(PLACE.unsettled);
  const starting = indices(PLACE.starting);
  const doubtfulBytes = new Int32Array(buffer, PLACE.doubtfulBytes, 1);
  const startingBytes = new Int32Array(buffer, PLACE.startingBytes, 1);
  const kernels = [false, true].map((hasY) => ({
    classes: exports[`classes${hasY}`] as Run,
    ordinary: exports[`ordinary${hasY}`] as Run,
    surface: exports[`surface${hasY}`] as Run,
    recentred: exports[`recentred${hasY}`] as Run,
    refined: exports[`refined${hasY}`] as Run,
  }));

  /** Most rays of a call: those that are copied go through the block. */
  const mostOf = (rays: Rays, ...answers: readonly Float64Array[]): number =>
    [...INPUTS.map((name) => rays[name]), ...answers].every((array) => array.buffer === buffer)
      ? LONG
      : CAPACITY;

  const place = (name: Input, array: Float64Array, from: number, count: number): number =>
    addressOf(memory, name, array, from, count);

  const roots: FastRoots = (q, c, rays, out, left) => {
    const kernel = kernels[q.hasY ? 1 : 0] as (typeof kernels)[number];
    const { Ex, Ey, Ez, dx, dy, dz } = rays;
    const { t0, t1 } = out;
    const inPlace = t0.buffer === buffer && t1.buffer === buffer;
    const most = mostOf(rays, t0, t1);
    left.count = 0;
    scaledNumbers.set(c.numbers);
    if (c.lattice) latticeNumbers.set(c.lattice);
    for (let from = 0, count = 0; from < rays.count; from += count) {
      const rest = Math.min(most, rays.count - from);
      // The kernels write two answers at a time: the last of an odd number goes alone, through the
      // block, since what comes after it is not theirs.
      const here = inPlace && rest > 1;
      count = here ? rest & ~1 : rest;
      const ex = place('Ex', Ex, from, count);
      const ey = q.hasY ? place('Ey', Ey, from, count) : 0;
      const ez = place('Ez', Ez, from, count);
      const x = place('dx', dx, from, count);
      const y = q.hasY ? place('dy', dy, from, count) : 0;
      const z = place('dz', dz, from, count);
      const near = here ? t0.byteOffset + 8 * from : PLACE.t0;
      const far = here ? t1.byteOffset + 8 * from : PLACE.t1;
      let doubts = count;
      let open = 0;
      let starts = 0;
      if (c.lattice) {
        open = kernel.ordinary(ex, ey, ez, x, y, z, near, far, count) >> 2;
        doubts = (doubtfulBytes[0] as number) >> 2;
        starts = (startingBytes[0] as number) >> 2;
      } else for (let i = 0; i < count; i++) doubtful[i] = i;
      if (doubts > 0) {
        doubts = kernel.recentred(ex, ey, ez, x, y, z, near, far, PLACE.doubtful, doubts) >> 2;
      }
      if (doubts > 0) {
        doubts = kernel.refined(ex, ey, ez, x, y, z, near, far, PLACE.doubtful, doubts) >> 2;
      }
      if (starts > 0) {
        surface.set(surfaceNumbers(q, c));
        starts = kernel.surface(ex, ey, ez, x, y, z, near, far, PLACE.starting, starts) >> 2;
      }
      if (starts > 0) {
        starts = kernel.refined(ex, ey, ez, x, y, z, near, far, PLACE.starting, starts) >> 2;
      }
      if (open > 0) {
        open = kernel.refined(ex, ey, ez, x, y, z, near, far, PLACE.unsettled, open) >> 2;
      }
      if (!here) {
        t0.set(part(block.t0, 0, count), from);
        t1.set(part(block.t1, 0, count), from);
      }
      for (let j = 0; j < doubts; j++) left.open[left.count++] = from + (doubtful[j] as number);
      for (let j = 0; j < starts; j++) left.open[left.count++] = from + (starting[j] as number);
      for (let j = 0; j < open; j++) left.open[left.count++] = from + (unsettled[j] as number);
    }
  };

  const classes: FastRoots = (q, c, rays, { margin }, left) => {
    const kernel = kernels[q.hasY ? 1 : 0] as (typeof kernels)[number];
    const { Ex, Ey, Ez, dx, dy, dz } = rays;
    const inPlace = margin.buffer === buffer;
    const most = mostOf(rays, margin);
    left.count = 0;
    scaledNumbers.set(c.numbers);
    for (let from = 0, count = 0; from < rays.count; from += count) {
      const rest = Math.min(most, rays.count - from);
      // As in `roots`: the last of an odd number goes alone.
      const here = inPlace && rest > 1;
      count = here ? rest & ~1 : rest;
      const ex = place('Ex', Ex, from, count);
      const ey = q.hasY ? place('Ey', Ey, from, count) : 0;
      const ez = place('Ez', Ez, from, count);
      const x = place('dx', dx, from, count);
      const y = q.hasY ? place('dy', dy, from, count) : 0;
      const z = place('dz', dz, from, count);
      const at = here ? margin.byteOffset + 8 * from : PLACE.margin;
      const open = kernel.classes(ex, ey, ez, x, y, z, at, count) >> 2;
      if (!here) margin.set(part(block.margin, 0, count), from);
      for (let j = 0; j < open; j++) left.open[left.count++] = from + (doubtful[j] as number);
    }
  };
  const interval = new Float64Array(buffer, INTERVAL, 2);
  const first: FastStages['first'] = (out, count, tMin, tMax) => {
    const { t0, t1 } = out;
    const inPlace = t0.buffer === buffer && t1.buffer === buffer;
    const even = inPlace ? count & ~1 : 0;
    interval[0] = tMin;
    interval[1] = tMax;
    if (even > 0) exports.first?.(t0.byteOffset, t1.byteOffset, even);
    chooseFirst(out, even, count, tMin, tMax);
  };
  return { roots, classes, first };
}

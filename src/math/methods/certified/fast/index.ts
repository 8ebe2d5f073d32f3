import type { Answers, Rays } from '../../../batch/batch.ts';
import type { Allocate } from '../../../batch/memory.ts';
import type { Quadric } from '../../../batch/quadric.ts';
import type { FastRoots, OpenRays } from '../roots-quadric.ts';
import type { CertifiedQuadric } from '../scaled-quadric.ts';
import { createArena } from './arena.ts';
import {
  CAPACITY,
  INPUTS,
  type Input,
  LATTICE_NUMBERS,
  type Param,
  PLACE,
  SCALED_NUMBERS,
} from './layout.ts';
import { certifiedModule } from './module.ts';

export interface Fast {
  /** Both roots by WebAssembly, two rays at a time: the stages of roots-quadric.ts, compiled from the same text, and so to the same bits. */
  readonly roots: FastRoots;
  /** Arrays that need not be copied. */
  readonly allocate: Allocate;
}

/** Null where WebAssembly, its vectors or its memory are missing or forbidden. */
export function createFast(): Fast | null {
  const instance = instantiate();
  if (!instance) return null;
  const { buffer } = instance.exports.memory as WebAssembly.Memory;
  return { roots: fastRoots(instance.exports, buffer), allocate: createArena(buffer) };
}

function instantiate(): WebAssembly.Instance | null {
  if (typeof WebAssembly === 'undefined') return null;
  const bytes = certifiedModule() as BufferSource;
  try {
    return new WebAssembly.Instance(new WebAssembly.Module(bytes));
  } catch {
    // Without vectors an engine says CompileError, under a content security policy without 'wasm-unsafe-eval' that or EvalError, without room for the memory RangeError.
    return null;
  }
}

/** The addresses of Ex, Ey, Ez, dx, dy, dz, t0 and t1, and what else a kernel wants. */
type Run = (...numbers: number[]) => number;

function fastRoots(exports: WebAssembly.Exports, buffer: ArrayBuffer): FastRoots {
  const doubles = (offset: number, length = CAPACITY): Float64Array =>
    new Float64Array(buffer, offset, length);
  const indices = (offset: number): Int32Array => new Int32Array(buffer, offset, CAPACITY + 1);
  const block = Object.fromEntries(
    [...INPUTS, 't0', 't1'].map((name) => [name, doubles(PLACE[name as Param])]),
  ) as Record<Param, Float64Array>;
  const latticeNumbers = doubles(LATTICE_NUMBERS, (SCALED_NUMBERS - LATTICE_NUMBERS) / 8);
  const scaledNumbers = doubles(SCALED_NUMBERS, 16);
  const doubtful = indices(PLACE.doubtful);
  const unsettled = indices(PLACE.unsettled);
  const doubtfulBytes = new Int32Array(buffer, PLACE.doubtfulBytes, 1);
  const kernels = [false, true].map((hasY) => ({
    ordinary: exports[`ordinary${hasY}`] as Run,
    recentred: exports[`recentred${hasY}`] as Run,
    refined: exports[`refined${hasY}`] as Run,
  }));

  /** Where the kernels find a part of an input: where it is, or in the block, where it is copied to. */
  function addressOf(name: Input, array: Float64Array, from: number, count: number): number {
    if (array.buffer === buffer) return array.byteOffset + 8 * from;
    block[name].set(part(array, from, count));
    return PLACE[name];
  }

  return (q: Quadric, c: CertifiedQuadric, rays: Rays, out: Answers, left: OpenRays): void => {
    const kernel = kernels[q.hasY ? 1 : 0] as (typeof kernels)[number];
    const { Ex, Ey, Ez, dx, dy, dz } = rays;
    const { t0, t1 } = out;
    const inPlace = t0.buffer === buffer && t1.buffer === buffer;
    left.count = 0;
    scaledNumbers.set(c.numbers);
    if (c.lattice) latticeNumbers.set(c.lattice);
    for (let from = 0, count = 0; from < rays.count; from += count) {
      const rest = Math.min(CAPACITY, rays.count - from);
      // The kernels write two answers at a time: the last of an odd number goes alone, through the block, since what comes after it is not theirs.
      const here = inPlace && rest > 1;
      count = here ? rest & ~1 : rest;
      const ex = addressOf('Ex', Ex, from, count);
      const ey = q.hasY ? addressOf('Ey', Ey, from, count) : 0;
      const ez = addressOf('Ez', Ez, from, count);
      const x = addressOf('dx', dx, from, count);
      const y = q.hasY ? addressOf('dy', dy, from, count) : 0;
      const z = addressOf('dz', dz, from, count);
      const near = here ? t0.byteOffset + 8 * from : PLACE.t0;
      const far = here ? t1.byteOffset + 8 * from : PLACE.t1;
      let doubts = count;
      let open = 0;
      if (c.lattice) {
        open = kernel.ordinary(ex, ey, ez, x, y, z, near, far, count) >> 2;
        doubts = (doubtfulBytes[0] as number) >> 2;
      } else for (let i = 0; i < count; i++) doubtful[i] = i;
      if (doubts > 0) {
        doubts = kernel.recentred(ex, ey, ez, x, y, z, near, far, PLACE.doubtful, doubts) >> 2;
      }
      if (doubts > 0) {
        doubts = kernel.refined(ex, ey, ez, x, y, z, near, far, PLACE.doubtful, doubts) >> 2;
      }
      if (open > 0) {
        open = kernel.refined(ex, ey, ez, x, y, z, near, far, PLACE.unsettled, open) >> 2;
      }
      if (!here) {
        t0.set(part(block.t0, 0, count), from);
        t1.set(part(block.t1, 0, count), from);
      }
      for (let j = 0; j < doubts; j++) left.open[left.count++] = from + (doubtful[j] as number);
      for (let j = 0; j < open; j++) left.open[left.count++] = from + (unsettled[j] as number);
    }
  };
}

/** A view of a part, or the array itself if that is all of it: views cost more than copying some hundred numbers. */
const part = (array: Float64Array, from: number, count: number): Float64Array =>
  from === 0 && count === array.length ? array : array.subarray(from, from + count);

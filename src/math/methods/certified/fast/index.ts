import type { Answers, Rays } from '../../../batch/batch.ts';
import type { Quadric } from '../../../batch/quadric.ts';
import type { FastRoots, OpenRays } from '../roots-quadric.ts';
import type { CertifiedQuadric } from '../scaled-quadric.ts';
import { CAPACITY, INPUTS, LATTICE_NUMBERS, PLACE, SCALED_NUMBERS } from './layout.ts';
import { certifiedModule } from './module.ts';

type Block = (count: number) => number;
type Stage = (list: number, count: number) => number;

/**
 * Both roots by WebAssembly, two rays at a time: the stages of roots-quadric.ts, compiled from the same text, and so to the same bits. Null where WebAssembly or
 * its vectors are missing or forbidden.
 */
export function createFastRoots(): FastRoots | null {
  const instance = instantiate();
  return instance && fastRoots(instance);
}

function instantiate(): WebAssembly.Instance | null {
  if (typeof WebAssembly === 'undefined') return null;
  try {
    return new WebAssembly.Instance(new WebAssembly.Module(certifiedModule() as BufferSource));
  } catch (error) {
    // A content security policy without 'wasm-unsafe-eval', or an engine without vectors, says CompileError.
    if (error instanceof WebAssembly.CompileError) return null;
    throw error;
  }
}

function fastRoots({ exports }: WebAssembly.Instance): FastRoots {
  const { buffer } = exports.memory as WebAssembly.Memory;
  const doubles = (offset: number, length = CAPACITY): Float64Array =>
    new Float64Array(buffer, offset, length);
  const indices = (offset: number): Int32Array => new Int32Array(buffer, offset, CAPACITY + 1);
  const inputs = INPUTS.map((name) => ({ name, array: doubles(PLACE[name]) }));
  const flat = inputs.filter(({ name }) => name !== 'Ey' && name !== 'dy');
  const t0 = doubles(PLACE.t0);
  const t1 = doubles(PLACE.t1);
  const latticeNumbers = doubles(LATTICE_NUMBERS, (SCALED_NUMBERS - LATTICE_NUMBERS) / 8);
  const scaledNumbers = doubles(SCALED_NUMBERS, 16);
  const doubtful = indices(PLACE.doubtful);
  const unsettled = indices(PLACE.unsettled);
  const doubtfulBytes = new Int32Array(buffer, PLACE.doubtfulBytes, 1);
  const kernels = [false, true].map((hasY) => ({
    ordinary: exports[`ordinary${hasY}`] as Block,
    recentred: exports[`recentred${hasY}`] as Stage,
    refined: exports[`refined${hasY}`] as Stage,
  }));

  return (q: Quadric, c: CertifiedQuadric, rays: Rays, out: Answers, left: OpenRays): void => {
    const kernel = kernels[q.hasY ? 1 : 0] as (typeof kernels)[number];
    left.count = 0;
    scaledNumbers.set(c.numbers);
    if (c.lattice) latticeNumbers.set(c.lattice);
    for (let from = 0; from < rays.count; from += CAPACITY) {
      const count = Math.min(CAPACITY, rays.count - from);
      for (const { name, array } of q.hasY ? inputs : flat) {
        array.set(part(rays[name], from, count));
      }
      let doubts = count;
      let open = 0;
      if (c.lattice) {
        open = kernel.ordinary(count) >> 2;
        doubts = (doubtfulBytes[0] as number) >> 2;
      } else for (let i = 0; i < count; i++) doubtful[i] = i;
      if (doubts > 0) doubts = kernel.recentred(PLACE.doubtful, doubts) >> 2;
      if (doubts > 0) doubts = kernel.refined(PLACE.doubtful, doubts) >> 2;
      if (open > 0) open = kernel.refined(PLACE.unsettled, open) >> 2;
      out.t0.set(part(t0, 0, count), from);
      out.t1.set(part(t1, 0, count), from);
      for (let j = 0; j < doubts; j++) left.open[left.count++] = from + (doubtful[j] as number);
      for (let j = 0; j < open; j++) left.open[left.count++] = from + (unsettled[j] as number);
    }
  };
}

/** A view of a part, or the array itself if that is all of it: views cost more than copying some hundred numbers. */
const part = (array: Float64Array, from: number, count: number): Float64Array =>
  from === 0 && count === array.length ? array : array.subarray(from, from + count);

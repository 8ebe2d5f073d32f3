import type { Answers, Rays } from './batch.ts';
import { NUMBERS as NUMBER_NAMES, STRAIGHT } from './generated/index.ts';
import {
  addressOf,
  BLOCK,
  BLOCK_ARRAYS,
  CAPACITY,
  NUMBERS,
  part,
  type Run,
  SCRATCH,
  type SimdMemory,
} from './simd-memory.ts';
import type { Source } from './straight.ts';
import { type Ask, type Loop, PLACE } from './straight-loop.ts';

const INPUTS = ['Ex', 'Ey', 'Ez', 'dx', 'dy', 'dz'] as const;
const OUTPUTS = ['t0', 't1', 'margin'] as const;
const WRITTEN = { both: ['t0', 't1'], classes: ['margin'] } as const;

/** Rays of a call where none is copied: each has room for its mark in the scratch. */
const LONG = 2 ** 14;

/**
 * The loops of the straight methods in WebAssembly: two rays at a time, or four in float32. Arrays
 * that are not in the memory of the kernels, and the last rays, are copied part by part.
 */
export function simdSource(memory: SimdMemory): Source {
  const { buffer, block } = memory;
  const modules = new Map<string, Readonly<Record<string, Run>>>();
  const listed = new Int32Array(buffer, SCRATCH, LONG);
  const doubles = new Float64Array(buffer, NUMBERS, BLOCK[BLOCK_ARRAYS[0]] / 8);
  const singles = new Float32Array(buffer, NUMBERS, BLOCK[BLOCK_ARRAYS[0]] / 8);
  const at: number[] = [];

  function runOf(method: string, name: string): Run {
    let functions = modules.get(method);
    if (!functions) {
      const text = atob((STRAIGHT[method]?.simd ?? '').replaceAll('\n', ''));
      functions = memory.load(Uint8Array.from(text, (c) => c.charCodeAt(0)));
      modules.set(method, functions);
    }
    return functions[name] as Run;
  }

  function loop(method: string, kind: string, ask: Ask): Loop {
    const isSingle = STRAIGHT[method]?.arithmetic === 'float32';
    const lanes = isSingle ? 4 : 2;
    const written = WRITTEN[ask];
    const run = runOf(method, `${kind}${ask === 'both' ? 'Both' : 'Classes'}`);
    return (numbers, rays, out, marked) => {
      (isSingle ? singles : doubles).set(numbers);
      const inPlace = written.every((name) => out[name].buffer === buffer);
      const isCopied = !inPlace || INPUTS.some((name) => rays[name].buffer !== buffer);
      const most = isCopied ? CAPACITY : LONG;
      let left = 0;
      for (let from = 0, count = 0; from < rays.count; from += count) {
        const rest = Math.min(most, rays.count - from);
        // Vectors are written whole: what comes after the last rays is not theirs.
        const here = inPlace && rest >= lanes;
        count = here ? rest - (rest % lanes) : rest;
        setPlaces(rays, out, from, count, here);
        const padded = count + ((lanes - (count % lanes)) % lanes);
        const end = run(...at, SCRATCH, NUMBERS, padded, ask === 'both' ? 1 : 0);
        for (let k = 0; k < (end - SCRATCH) >> 2; k++) {
          const mark = listed[k] as number;
          if ((mark & PLACE) < count) marked[left++] = from + mark;
        }
        if (here) continue;
        for (const name of written) out[name].set(part(block[name], 0, count), from);
      }
      return left;
    };
  }

  function setPlaces(rays: Rays, out: Answers, from: number, count: number, here: boolean): void {
    INPUTS.forEach((name, k) => {
      at[k] = addressOf(memory, name, rays[name], from, count);
    });
    OUTPUTS.forEach((name, k) => {
      const own = out[name];
      const isOwn = here && own.buffer === buffer;
      at[INPUTS.length + k] = isOwn ? own.byteOffset + 8 * from : BLOCK[name];
    });
  }

  return (method, kind) =>
    STRAIGHT[method] && NUMBER_NAMES[kind]
      ? { both: loop(method, kind, 'both'), classes: loop(method, kind, 'classes') }
      : null;
}

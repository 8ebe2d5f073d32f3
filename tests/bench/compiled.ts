import { loopOf } from '../../scripts/kernels/trees/emit-typescript.ts';
import { functionOf, moduleOf } from '../../scripts/kernels/trees/emit-wasm.ts';
import { arraysOf } from '../../scripts/kernels/trees/generate.ts';
import type { Program } from '../../scripts/kernels/trees/program.ts';
import { stripTypes } from '../../src/check/program/strip.ts';
import { addressOf, NUMBERS, SCRATCH, type SimdMemory } from '../../src/math/batch/simd-memory.ts';
import { type Loop, PLACE } from '../../src/math/batch/straight-loop.ts';

/** A program, and the names of the numbers that it is given. */
export interface Made {
  readonly program: Program;
  readonly numbers: readonly string[];
}

/** The same as loops of both targets. */
export interface Compiled {
  readonly typescript: Loop;
  readonly simd: Loop;
}

/** Each program in a module of its own, as the generator makes those that are committed. */
export function compiled({ program, numbers }: Made, memory: SimdMemory): Compiled {
  return { typescript: inTypeScript(program, numbers), simd: inSimd(program, numbers, memory) };
}

function inTypeScript(program: Program, numbers: readonly string[]): Loop {
  const scratch = { count: 0, handed: 0 };
  const text = loopOf('loop', numbers, program, scratch);
  const plain = stripTypes([...arraysOf(scratch, [text]), text, ''].join('\n'));
  if (!plain.ok) throw new SyntaxError(plain.message);
  return new Function(`${plain.text}\nreturn loop;`)() as Loop;
}

const INPUTS = ['Ex', 'Ey', 'Ez', 'dx', 'dy', 'dz'] as const;
const OUTPUTS = ['t0', 't1', 'margin'] as const;

/** Rays of a call: each has room for its mark. */
const LONG = 2 ** 14;

/** For arrays of the memory, and a multiple of four rays. */
function inSimd(program: Program, numbers: readonly string[], memory: SimdMemory): Loop {
  const { width } = program.format;
  const run = memory.load(moduleOf([functionOf(['loop'], numbers, program)])).loop;
  const given =
    width === 32
      ? new Float32Array(memory.buffer, NUMBERS, numbers.length)
      : new Float64Array(memory.buffer, NUMBERS, numbers.length);
  const listed = new Int32Array(memory.buffer, SCRATCH, LONG);
  return (own, rays, out, marked) => {
    given.set(own);
    let left = 0;
    for (let from = 0; from < rays.count; from += LONG) {
      const count = Math.min(LONG, rays.count - from);
      const at = [
        ...INPUTS.map((name) => addressOf(memory, name, rays[name], from, count)),
        ...OUTPUTS.map((name) => addressOf(memory, name, out[name], from, count)),
      ];
      const end = run?.(...at, SCRATCH, NUMBERS, count, 1) ?? SCRATCH;
      for (let k = 0; k < (end - SCRATCH) >> 2; k++) {
        const mark = listed[k] as number;
        if ((mark & PLACE) < count) marked[left++] = from + mark;
      }
    }
    return left;
  };
}

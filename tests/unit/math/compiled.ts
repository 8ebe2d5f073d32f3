import { type Code, codeOf } from '../../../scripts/kernels/certified/expression.ts';
import { expressionOf } from '../../../scripts/kernels/certified/source.ts';
import { moduleOf } from '../../../scripts/kernels/wasm/module.ts';
import * as op from '../../../scripts/kernels/wasm/ops.ts';

export const ONE_PAGE = { module: 'batch', name: 'memory', pages: 1 } as const;

type Numbers = Readonly<Record<string, number>>;

/** Two lanes, x and its neighbour: the operations must not mix them. */
type Evaluate = (low: Numbers, high: Numbers) => readonly [number, number];

/** A formula as the kernels compute it, of two sets of numbers at a time. */
export function compiled(formula: string, names: readonly string[]): Evaluate {
  const load = (name: string): Code => {
    const k = names.indexOf(name);
    if (k < 0) throw new ReferenceError(`${name} is not known`);
    return op.load(op.i32(0), 16 * (k + 1));
  };
  const body = [...op.store(op.i32(0), 0, codeOf(expressionOf(formula), load)), ...op.i32(0)];
  const bytes = moduleOf([{ name: 'run', params: 0, ints: 0, vectors: 0, body }], ONE_PAGE);
  const imported = new WebAssembly.Memory({ initial: ONE_PAGE.pages });
  const module = new WebAssembly.Module(bytes as BufferSource);
  const { exports } = new WebAssembly.Instance(module, { batch: { memory: imported } });
  const memory = new Float64Array(imported.buffer);
  return (low, high) => {
    names.forEach((name, k) => {
      memory[2 * k + 2] = low[name] as number;
      memory[2 * k + 3] = high[name] as number;
    });
    (exports.run as () => number)();
    return [memory[0] as number, memory[1] as number];
  };
}

/** The same condition as the kernels have it: both bits of a mask. */
export function compiledCondition(
  formula: string,
  names: readonly string[],
): (at: Numbers) => boolean {
  // Where the mask is set, 1 is left of it: all bits of 1 and the mask.
  const evaluate = compiled(formula, names);
  return (at) => {
    const [low, high] = evaluate(at, at).map(
      (x) => new BigInt64Array(Float64Array.of(x).buffer)[0],
    );
    if (low !== high || (low !== 0n && low !== -1n)) throw new Error(`${formula} is no mask`);
    return low === -1n;
  };
}

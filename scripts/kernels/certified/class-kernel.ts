import { INPUTS, PLACE } from '../../../src/math/methods/certified/simd.ts';
import { numbered } from '../wasm/locals.ts';
import type { Func } from '../wasm/module.ts';
import * as op from '../wasm/ops.ts';
import { listOpen } from './block-kernel.ts';
import type { Code } from './expression.ts';
import { flowOf, inputOf, partsOf, scopeOf } from './flow.ts';
import type { Numbers } from './prologue.ts';
import { elementOf, type Loop } from './source.ts';

/* The filter of classes: over all rays in one part, two at a time. */

const PARAMS = [...INPUTS, 'margin'] as const;
const COUNT = PARAMS.length;
const { AT, TO, BITS, END, VECTORS } = numbered(
  COUNT + 1,
  ...(['AT', 'TO', 'BITS', 'END', 'VECTORS'] as const),
);

/**
 * `name(…INPUTS, margin, count)` writes the loop's `margin`, and returns how many bytes of
 * `doubtful` it filled: with the rays that are not `clear`.
 */
export function classKernel(name: string, numbers: Numbers, loop: Loop): Func {
  const flow = flowOf([loop], [numbers]);
  const { scope, prologue } = scopeOf(flow, VECTORS);
  const at = op.get(AT);
  const of = (array: (typeof PARAMS)[number]): Code => op.plus(op.get(PARAMS.indexOf(array)), at);
  const input = (element: string): Code | null => {
    const array = inputOf(element);
    return array ? op.load(of(array), 0) : null;
  };
  const [clear, margin] = [flow.name('clear'), flow.name(elementOf('margin'))];
  const parts = partsOf(flow, [], [[clear, margin]], { hand: at, input, again: true }, scope);
  const body: Code = [
    ...prologue,
    ...op.set(END, op.shiftLeft(op.get(COUNT), op.i32(3))),
    ...op.set(AT, op.i32(0)),
    ...op.set(TO, op.i32(PLACE.doubtful)),
    ...op.during(op.less(at, op.get(END)), [
      ...parts.code(0),
      ...op.store(of('margin'), 0, parts.value(margin, 0)),
      ...listOpen(TO, op.flip(op.bitmask(parts.value(clear, 0)), op.i32(3)), {
        ...{ bits: BITS, at: AT, end: END },
      }),
      ...op.forward(AT, op.i32(16)),
    ]),
    ...op.minus(op.get(TO), op.i32(PLACE.doubtful)),
  ];
  return { name, params: COUNT + 1, ints: VECTORS - COUNT - 1, vectors: scope.count(), body };
}

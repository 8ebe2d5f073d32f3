import { INTERVAL } from '../../../src/math/methods/certified/simd.ts';
import { numbered } from '../wasm/locals.ts';
import type { Func } from '../wasm/module.ts';
import * as op from '../wasm/ops.ts';

/* What `first` makes of both roots, two rays at a time: as chooseFirst of batch.ts. */

const { T0, T1, COUNT, AT, END, NEAR, FAR, LOW, HIGH } = numbered(
  0,
  ...(['T0', 'T1', 'COUNT', 'AT', 'END'] as const),
  ...(['NEAR', 'FAR', 'LOW', 'HIGH'] as const),
);
const NAN = op.constant(Number.NaN);

/** `name(t0, t1, count)`: the lesser root from tMin to tMax into t0, NaN into t1. */
export function firstKernel(name: string): Func {
  const at = op.get(AT);
  const inside = (root: number) =>
    op.and(op.ge(op.get(root), op.get(LOW)), op.le(op.get(root), op.get(HIGH)));
  const body = [
    ...op.set(LOW, op.loadSplat(INTERVAL)),
    ...op.set(HIGH, op.loadSplat(INTERVAL + 8)),
    ...op.set(END, op.shiftLeft(op.get(COUNT), op.i32(3))),
    ...op.set(AT, op.i32(0)),
    ...op.during(op.less(at, op.get(END)), [
      ...op.set(NEAR, op.load(op.plus(op.get(T0), at), 0)),
      ...op.set(FAR, op.load(op.plus(op.get(T1), at), 0)),
      ...op.store(
        op.plus(op.get(T0), at),
        0,
        op.select(op.get(NEAR), op.select(op.get(FAR), NAN, inside(FAR)), inside(NEAR)),
      ),
      ...op.store(op.plus(op.get(T1), at), 0, NAN),
      ...op.forward(AT, op.i32(16)),
    ]),
    ...op.i32(0),
  ];
  return { name, params: COUNT + 1, ints: END - COUNT, vectors: HIGH - END, body };
}

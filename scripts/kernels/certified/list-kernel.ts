import { HANDED, handed, PARAMS, type Param } from '../../../src/math/methods/certified/simd.ts';
import { numbered } from '../wasm/locals.ts';
import type { Func } from '../wasm/module.ts';
import * as op from '../wasm/ops.ts';
import type { Code } from './expression.ts';
import { flowOf, inputOf, partsOf, scopeOf } from './flow.ts';
import type { Numbers } from './prologue.ts';
import { elementOf, type Loop } from './source.ts';

/*
 * A stage after the ordinary rays' passes: over a list of rays, two at a time, from wherever they
 * are.
 */

const LIST = PARAMS.length;
const { COUNT, AT, TO, END, LOT_END, LOW, HIGH, BITS, HAND, HAND_END, VECTORS } = numbered(
  LIST + 1,
  ...(['COUNT', 'AT', 'TO', 'END', 'LOT_END', 'LOW', 'HIGH'] as const),
  ...(['BITS', 'HAND', 'HAND_END', 'VECTORS'] as const),
);
const PAIR = 16;
const NAN = op.constant(Number.NaN);

/**
 * What the stage says of a ray: the condition under which it is computed further at all, the one
 * under which it then has both roots, and the one under which it misses.
 */
export interface Verdicts {
  readonly clear: string;
  readonly settled: string;
  readonly missed: string | null;
}

/**
 * `name(…PARAMS, list, count)` settles what it can, moves the others to the front of the list and
 * returns how many bytes these are. The list has room for one more.
 */
export function listKernel(
  name: string,
  numbers: Numbers,
  loop: Loop,
  verdicts: Verdicts,
  cuts: readonly string[],
): Func {
  if (cuts.length === 0) throw new RangeError(`${name} has no parts`);
  const flow = flowOf([loop], [numbers]);
  const { scope, prologue } = scopeOf(flow, VECTORS);
  const at = op.get(AT);
  const hand = op.get(HAND);
  const address = (array: Param, index: number): Code =>
    op.plus(op.get(PARAMS.indexOf(array)), op.shiftLeft(op.get(index), op.i32(3)));
  const input = (element: string): Code | null => {
    const array = inputOf(element);
    return array ? op.gather(address(array, LOW), address(array, HIGH), 0) : null;
  };
  const clear = flow.name(verdicts.clear);
  const settled = flow.name(verdicts.settled);
  const missed = verdicts.missed === null ? null : flow.name(verdicts.missed);
  const [t0, t1] = [flow.name(elementOf('t0')), flow.name(elementOf('t1'))];
  const last = cuts.length;
  const lastWanted = [clear, settled, t0, t1, ...(missed ? [missed] : [])];
  const parts = partsOf(
    flow,
    cuts.map((cut) => flow.name(cut)),
    [...cuts, null].map((_, p) => (p === last ? lastWanted : [])),
    { hand, input, again: false },
    scope,
  );
  const INDICES = handed(parts.free);
  const answered = scope.declare('answered');
  const roots = { t0: scope.declare('near'), t1: scope.declare('far') };
  const of = (value: string): Code => parts.value(value, last);
  const lane = (n: number): Code => {
    const index = n === 0 ? LOW : HIGH;
    return op.when(
      op.both(op.get(BITS), op.i32(1 << n)),
      [
        ...op.storeLane(address('t0', index), 0, op.get(roots.t0), n),
        ...op.storeLane(address('t1', index), 0, op.get(roots.t1), n),
      ],
      // The last of an odd number went with itself.
      op.when(
        n === 0 ? op.i32(1) : op.notEqual(op.get(LOW), op.get(HIGH)),
        op.append(TO, op.get(index)),
      ),
    );
  };
  const answer = (): Code => [
    ...op.set(answered, op.and(of(clear), of(settled))),
    ...op.set(roots.t0, op.select(of(t0), NAN, op.get(answered))),
    ...op.set(roots.t1, op.select(of(t1), NAN, op.get(answered))),
    ...op.set(BITS, op.bitmask(missed ? op.or(op.get(answered), of(missed)) : op.get(answered))),
    ...lane(0),
    ...lane(1),
  ];
  const firstPart: Code = [
    ...op.set(HAND, op.i32(0)),
    ...op.during(op.less(at, op.get(LOT_END)), [
      ...op.set(LOW, op.loadInt(at, 0)),
      ...op.set(HIGH, op.loadInt(at, 4)),
      ...op.storeInt(hand, INDICES, op.get(LOW)),
      ...op.storeInt(hand, INDICES + 4, op.get(HIGH)),
      ...parts.code(0),
      ...op.forward(HAND, op.i32(PAIR)),
      ...op.forward(AT, op.i32(8)),
    ]),
    ...op.set(HAND_END, hand),
  ];
  const later = cuts.flatMap((_, k) => [
    ...op.set(HAND, op.i32(0)),
    ...op.during(op.less(hand, op.get(HAND_END)), [
      ...parts.code(k + 1),
      ...(k + 1 < last
        ? []
        : [
            ...op.set(LOW, op.loadInt(hand, INDICES)),
            ...op.set(HIGH, op.loadInt(hand, INDICES + 4)),
            ...answer(),
          ]),
      ...op.forward(HAND, op.i32(PAIR)),
    ]),
  ]);
  const body: Code = [
    ...prologue,
    ...op.set(AT, op.get(LIST)),
    ...op.set(TO, op.get(LIST)),
    ...op.set(END, op.plus(op.get(LIST), op.shiftLeft(op.get(COUNT), op.i32(2)))),
    ...op.storeInt(op.get(END), 0, op.loadInt(op.minus(op.get(END), op.i32(4)), 0)),
    ...op.during(op.less(at, op.get(END)), [
      ...op.set(LOT_END, op.plus(at, op.i32(4 * HANDED))),
      ...op.when(op.less(op.get(END), op.get(LOT_END)), op.set(LOT_END, op.get(END))),
      ...firstPart,
      ...later,
    ]),
    ...op.minus(op.get(TO), op.get(LIST)),
  ];
  return { name, params: LIST + 2, ints: VECTORS - LIST - 2, vectors: scope.count(), body };
}

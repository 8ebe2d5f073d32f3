import {
  HANDED,
  handed,
  PARAMS,
  type Param,
  PLACE,
} from '../../../src/math/methods/certified/simd.ts';
import { numbered } from '../wasm/locals.ts';
import type { Func } from '../wasm/module.ts';
import * as op from '../wasm/ops.ts';
import type { Code } from './expression.ts';
import { flowOf, inputOf, partsOf, type Step, scopeOf } from './flow.ts';
import type { Numbers } from './prologue.ts';
import { elementOf, type Loop } from './source.ts';

/*
 * The three passes over ordinary rays, two rays at a time: rough roots of all, then residuals and
 * steps of the pairs of which at least one is clearly hit. As in TypeScript, rays are taken in lots
 * that fit the first cache.
 */

const COUNT = PARAMS.length;
const PLACES_OF = numbered(
  COUNT + 1,
  ...(['AT', 'LOT', 'DOUBTFUL', 'UNSETTLED', 'STARTING', 'BITS', 'OPEN'] as const),
  ...(['LOT_END', 'END', 'HAND', 'HAND_END', 'VECTORS'] as const),
);
const { AT, LOT, DOUBTFUL, UNSETTLED, STARTING, BITS, OPEN } = PLACES_OF;
const { LOT_END, END, HAND, HAND_END, VECTORS } = PLACES_OF;
const PAIR = 16;
const NAN = op.constant(Number.NaN);

/**
 * Appends the indices of the rays of a pair whose bits are set to `list`, if they are among those
 * asked for: `at` and `end` count in bytes of an array.
 */
export function listOpen(
  list: number,
  bits: Code,
  locals: { readonly bits: number; readonly at: number; readonly end: number },
): Code {
  const at = op.get(locals.at);
  const lane = (n: number): Code =>
    op.when(
      op.both(
        op.notEqual(op.both(op.get(locals.bits), op.i32(1 << n)), op.i32(0)),
        op.less(op.plus(at, op.i32(8 * n)), op.get(locals.end)),
      ),
      op.append(list, op.plus(op.shiftRight(at, op.i32(3)), op.i32(n))),
    );
  return [...op.set(locals.bits, bits), ...op.when(op.get(locals.bits), [...lane(0), ...lane(1)])];
}

/**
 * `name(…PARAMS, count)` returns how many bytes of `unsettled` it filled, and puts those of
 * `doubtful` and `starting` into `doubtfulBytes` and `startingBytes`. `cuts` are the values of the
 * three loops after which a part ends; the first part must tell which rays are clear.
 */
export function blockKernel(
  name: string,
  numbers: readonly Numbers[],
  loops: readonly [Loop, Loop, Loop],
  cuts: readonly (readonly [string, 0 | 1 | 2])[],
): Func {
  if (cuts.length === 0) throw new RangeError(`${name} has no parts`);
  const flow = flowOf(loops, numbers);
  const { scope, prologue } = scopeOf(flow, VECTORS);
  const at = op.get(AT);
  const hand = op.get(HAND);
  const of = (array: Param): Code => op.plus(op.get(PARAMS.indexOf(array)), at);
  const input = (element: string): Code | null => {
    const array = inputOf(element);
    return array ? op.load(of(array), 0) : null;
  };
  const clear = flow.name('clear', 0);
  const missed = flow.name('missed', 0);
  const settled = flow.name('settled', 2);
  const [t0, t1] = [flow.name(elementOf('t0')), flow.name(elementOf('t1'))];
  // To which list an open ray goes is asked for those alone.
  const late = (verdict: string): Step => {
    const found = flow.steps.find(({ target }) => target === flow.name(verdict, 0));
    if (!found) throw new ReferenceError(`${verdict} is not known`);
    return found;
  };
  const [beside, remote] = [late('beside'), late('remote')];
  const rest = {
    ...flow,
    steps: flow.steps.filter((step) => step !== beside && step !== remote),
  };
  const last = cuts.length;
  const wanted = [...cuts, null].map((_, p) =>
    p === 0 ? [clear, missed] : p === last ? [clear, settled, t0, t1] : [],
  );
  const parts = partsOf(
    rest,
    cuts.map(([cut, k]) => flow.name(cut, k)),
    wanted,
    { hand, input, again: true },
    scope,
  );
  const PLACES = handed(parts.free);

  const listBits = (list: number, bits: Code): Code =>
    listOpen(list, bits, { bits: BITS, at: AT, end: END });
  const no = (bits: Code): Code => op.flip(bits, op.i32(3));
  const one = (value: string, p: number): Code => parts.value(value, p);

  const roughPart: Code = [
    ...op.set(AT, op.get(LOT)),
    ...op.set(HAND, op.i32(0)),
    ...op.during(op.less(at, op.get(LOT_END)), [
      ...parts.code(0),
      ...op.storeInt(hand, PLACES, at),
      ...op.set(OPEN, no(op.bitmask(op.or(one(clear, 0), one(missed, 0))))),
      ...op.when(op.get(OPEN), [
        ...parts.extra(beside, 0),
        ...parts.extra(remote, 0),
        ...listBits(STARTING, op.both(op.get(OPEN), op.bitmask(one(beside.target, 0)))),
        ...op.set(OPEN, op.both(op.get(OPEN), no(op.bitmask(one(beside.target, 0))))),
        ...listBits(DOUBTFUL, op.both(op.get(OPEN), op.bitmask(one(remote.target, 0)))),
        ...listBits(UNSETTLED, op.both(op.get(OPEN), no(op.bitmask(one(remote.target, 0))))),
      ]),
      ...op.when(op.anyTrue(one(clear, 0)), op.forward(HAND, op.i32(PAIR)), [
        ...op.store(of('t0'), 0, NAN),
        ...op.store(of('t1'), 0, NAN),
      ]),
      ...op.forward(AT, op.i32(PAIR)),
    ]),
    ...op.set(HAND_END, hand),
  ];
  const solved = scope.declare('solved');
  const other = scope.declare('other');
  const answer = (): Code => [
    ...op.set(solved, op.and(one(clear, last), one(settled, last))),
    // All bits set are a NaN.
    ...op.set(other, op.not(op.get(solved))),
    ...op.store(of('t0'), 0, op.or(one(t0, last), op.get(other))),
    ...op.store(of('t1'), 0, op.or(one(t1, last), op.get(other))),
    ...listBits(UNSETTLED, op.bitmask(op.andNot(one(clear, last), op.get(solved)))),
  ];
  const later = cuts.flatMap((_, k) => [
    ...op.set(HAND, op.i32(0)),
    ...op.during(op.less(hand, op.get(HAND_END)), [
      ...op.set(AT, op.loadInt(hand, PLACES)),
      ...parts.code(k + 1),
      ...(k + 1 === last ? answer() : []),
      ...op.forward(HAND, op.i32(PAIR)),
    ]),
  ]);
  const body: Code = [
    ...prologue,
    ...op.set(END, op.shiftLeft(op.get(COUNT), op.i32(3))),
    ...op.set(LOT, op.i32(0)),
    ...op.set(DOUBTFUL, op.i32(PLACE.doubtful)),
    ...op.set(UNSETTLED, op.i32(PLACE.unsettled)),
    ...op.set(STARTING, op.i32(PLACE.starting)),
    ...op.during(op.less(op.get(LOT), op.get(END)), [
      ...op.set(LOT_END, op.plus(op.get(LOT), op.i32(8 * HANDED))),
      ...op.when(op.less(op.get(END), op.get(LOT_END)), op.set(LOT_END, op.get(END))),
      ...roughPart,
      ...later,
      ...op.set(LOT, op.get(LOT_END)),
    ]),
    ...op.storeInt(
      op.i32(0),
      PLACE.doubtfulBytes,
      op.minus(op.get(DOUBTFUL), op.i32(PLACE.doubtful)),
    ),
    ...op.storeInt(
      op.i32(0),
      PLACE.startingBytes,
      op.minus(op.get(STARTING), op.i32(PLACE.starting)),
    ),
    ...op.minus(op.get(UNSETTLED), op.i32(PLACE.unsettled)),
  ];
  return { name, params: COUNT + 1, ints: VECTORS - COUNT - 1, vectors: scope.count(), body };
}

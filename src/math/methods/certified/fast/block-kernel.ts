import type { Code } from '../../../wasm/expression.ts';
import { compile, createScope } from '../../../wasm/locals.ts';
import type { Func } from '../../../wasm/module.ts';
import * as op from '../../../wasm/ops.ts';
import { arraysRead, elementOf, type Loop } from '../../../wasm/source.ts';
import { HANDED, handed, INPUTS, type Input, PARAMS, type Param, PLACE } from './layout.ts';
import { constantsOf, type Numbers } from './prologue.ts';

/*
 * The three passes over ordinary rays, two rays at a time: rough roots of all, then residuals and steps of the pairs of which at least one is clearly hit. As
 * in TypeScript the passes follow each other in parts that fit the first cache.
 */

const COUNT = PARAMS.length;
const [AT, PART, DOUBTFUL, UNSETTLED, BITS, OPEN, PART_END, END, HAND, HAND_END] = [
  ...[1, 2, 3, 4, 5, 6, 7, 8, 9, 10].map((n) => COUNT + n),
] as [number, number, number, number, number, number, number, number, number, number];
const VECTORS = COUNT + 11;
const PAIR = 16;
const NAN = op.constant(Number.NaN);

/** `name(…PARAMS, count)` returns how many bytes of `unsettled` it filled, and puts those of `doubtful` into `doubtfulBytes`. */
export function blockKernel(
  name: string,
  numbers: readonly Numbers[],
  [rough, middle, last]: readonly [Loop, Loop, Loop],
): Func {
  const scope = createScope(VECTORS);
  const at = op.get(AT);
  const of = (array: Param): Code => op.plus(op.get(PARAMS.indexOf(array)), at);
  const hand = op.get(HAND);
  const scopes = [rough, middle, last].map(() => scope.inner());
  const [first = scope, , third = scope] = scopes;
  const prologue = [rough, middle, last].map(({ constants }, k) =>
    constantsOf(constants, numbers[k] as Numbers, scopes[k] ?? scope),
  );

  // What a pass writes and a later one reads has a place of its own.
  const slots = new Map<string, number>();
  // What is only an input needs none: it is read again.
  const again = new Map<string, Input>();
  for (const { statements } of [rough, middle]) {
    for (const { target, writes, formula } of statements) {
      const input = writes && statements.find(({ target: name }) => name === formula)?.formula;
      const found = INPUTS.find((name) => input === elementOf(name));
      if (found) again.set(target, found);
      else if (writes && !slots.has(target)) slots.set(target, slots.size);
    }
  }
  const slot = (array: string): number => {
    const n = slots.get(array);
    if (n === undefined) throw new ReferenceError(`${array} is read but never written`);
    return handed(n);
  };
  const CLEAR = handed(slots.size);
  const PLACES = handed(slots.size + 1);

  const inputOf = (array: string): readonly [Code, number] | null => {
    const input = again.get(array) ?? INPUTS.find((name) => name === array);
    return input ? [of(input), 0] : null;
  };
  const remote = rough.statements.find(({ target }) => target === 'remote');
  if (!remote) throw new ReferenceError('remote is not known');
  const pass = ({ statements }: Loop, k: number): Code => {
    const inner = scopes[k] ?? scope;
    const loads = arraysRead(statements).flatMap((array) =>
      op.set(inner.declare(elementOf(array)), op.load(...(inputOf(array) ?? [hand, slot(array)]))),
    );
    const write = (array: string, value: Code): Code =>
      array === 't0' || array === 't1'
        ? op.set(inner.declare(array), value)
        : again.has(array)
          ? []
          : op.store(hand, slot(array), value);
    const now = statements.filter((statement) => statement !== remote);
    return [...loads, ...compile(now, inner, write)];
  };
  const append = (list: number, value: Code): Code => [
    ...op.storeInt(op.get(list), 0, value),
    ...op.set(list, op.plus(op.get(list), op.i32(4))),
  ];
  const listLane = (list: number, lane: number): Code =>
    op.when(
      op.both(
        op.notEqual(op.both(op.get(BITS), op.i32(1 << lane)), op.i32(0)),
        op.less(op.plus(at, op.i32(8 * lane)), op.get(END)),
      ),
      append(list, op.plus(op.shiftRight(at, op.i32(3)), op.i32(lane))),
    );
  const listBits = (list: number, bits: Code): Code => [
    ...op.set(BITS, bits),
    ...op.when(op.get(BITS), [...listLane(list, 0), ...listLane(list, 1)]),
  ];
  /** The open ones of pass 1, to one of two lists: what decides that is computed for them alone. */
  const listOpen = (bits: Code): Code => [
    ...op.set(OPEN, bits),
    ...op.when(op.get(OPEN), [
      ...compile([remote], first, () => []),
      ...listBits(DOUBTFUL, op.both(op.get(OPEN), op.bitmask(first.value(remote.target)))),
      ...listBits(
        UNSETTLED,
        op.both(op.get(OPEN), op.flip(op.bitmask(first.value(remote.target)), op.i32(3))),
      ),
    ]),
  ];
  const forward = (local: number, by: Code): Code => op.set(local, op.plus(op.get(local), by));

  const roughPass: Code = [
    ...op.set(AT, op.get(PART)),
    ...op.set(HAND, op.i32(0)),
    ...op.during(op.less(at, op.get(PART_END)), [
      ...pass(rough, 0),
      ...op.store(hand, CLEAR, first.value('clear')),
      ...op.storeInt(hand, PLACES, at),
      ...op.store(of('t0'), 0, NAN),
      ...op.store(of('t1'), 0, NAN),
      ...listOpen(
        op.flip(op.bitmask(op.or(first.value('clear'), first.value('missed'))), op.i32(3)),
      ),
      ...forward(HAND, op.shiftLeft(op.anyTrue(first.value('clear')), op.i32(4))),
      ...forward(AT, op.i32(PAIR)),
    ]),
    ...op.set(HAND_END, hand),
  ];
  const overHanded = (body: Code): Code => [
    ...op.set(HAND, op.i32(0)),
    ...op.during(op.less(hand, op.get(HAND_END)), [
      ...op.set(AT, op.loadInt(hand, PLACES)),
      ...body,
      ...forward(HAND, op.i32(PAIR)),
    ]),
  ];
  const solved = third.declare('solved');
  const clear = third.declare('clear');
  const body: Code = [
    ...prologue.flat(),
    ...op.set(END, op.shiftLeft(op.get(COUNT), op.i32(3))),
    ...op.set(PART, op.i32(0)),
    ...op.set(DOUBTFUL, op.i32(PLACE.doubtful)),
    ...op.set(UNSETTLED, op.i32(PLACE.unsettled)),
    ...op.during(op.less(op.get(PART), op.get(END)), [
      ...op.set(PART_END, op.plus(op.get(PART), op.i32(8 * HANDED))),
      ...op.when(op.less(op.get(END), op.get(PART_END)), op.set(PART_END, op.get(END))),
      ...roughPass,
      ...overHanded(pass(middle, 1)),
      ...overHanded([
        ...pass(last, 2),
        ...op.set(clear, op.load(hand, CLEAR)),
        ...op.set(solved, op.and(op.get(clear), third.value('settled'))),
        ...op.store(of('t0'), 0, op.select(third.value('t0'), NAN, op.get(solved))),
        ...op.store(of('t1'), 0, op.select(third.value('t1'), NAN, op.get(solved))),
        ...listBits(UNSETTLED, op.bitmask(op.andNot(op.get(clear), op.get(solved)))),
      ]),
      ...op.set(PART, op.get(PART_END)),
    ]),
    ...op.storeInt(
      op.i32(0),
      PLACE.doubtfulBytes,
      op.minus(op.get(DOUBTFUL), op.i32(PLACE.doubtful)),
    ),
    ...op.minus(op.get(UNSETTLED), op.i32(PLACE.unsettled)),
  ];
  return { name, params: COUNT + 1, ints: VECTORS - COUNT - 1, vectors: scope.count(), body };
}

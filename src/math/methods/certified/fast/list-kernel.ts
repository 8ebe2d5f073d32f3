import type { Code } from '../../../wasm/expression.ts';
import { compile, createScope } from '../../../wasm/locals.ts';
import type { Func } from '../../../wasm/module.ts';
import * as op from '../../../wasm/ops.ts';
import { arraysRead, elementOf, type Loop } from '../../../wasm/source.ts';
import { type Input, PARAMS, type Param } from './layout.ts';
import { constantsOf, type Numbers } from './prologue.ts';

/* A stage after the ordinary rays' passes: over a list of rays, two at a time, from wherever they are. */

const LIST = PARAMS.length;
const [COUNT, AT, TO, END, LOW, HIGH, BITS] = [...[1, 2, 3, 4, 5, 6, 7].map((n) => LIST + n)] as [
  number,
  number,
  number,
  number,
  number,
  number,
  number,
];
const VECTORS = LIST + 8;
const NAN = op.constant(Number.NaN);

/** What the stage says of a ray: the names of the conditions under which it has both roots, and of the one under which it misses. */
export interface Verdicts {
  readonly settled: readonly [string, string];
  readonly missed: string | null;
  /** Where no ray of a pair fulfils this condition, what comes after it is not computed. */
  readonly early: string | null;
}

/** `name(…PARAMS, list, count)` settles what it can, moves the others to the front of the list and returns how many bytes these are. The list has room for one more. */
export function listKernel(
  name: string,
  numbers: Numbers,
  { constants, statements }: Loop,
  { settled: conditions, missed, early }: Verdicts,
): Func {
  const scope = createScope(VECTORS);
  const prologue = constantsOf(constants, numbers, scope);
  const at = op.get(AT);
  const address = (array: Param, index: number): Code =>
    op.plus(op.get(PARAMS.indexOf(array)), op.shiftLeft(op.get(index), op.i32(3)));
  const loads = arraysRead(statements).flatMap((array) =>
    op.set(
      scope.declare(elementOf(array)),
      op.gather(address(array as Input, LOW), address(array as Input, HIGH), 0),
    ),
  );
  const settled = scope.declare('answered');
  const roots = { t0: scope.declare('t0'), t1: scope.declare('t1') };
  const write = (array: string, value: Code): Code =>
    op.set(array === 't0' ? roots.t0 : roots.t1, value);
  const split = early ? 1 + statements.findIndex(({ target }) => target === early) : 0;
  const begin = compile(statements.slice(0, split), scope, write);
  const rest = compile(statements.slice(split), scope, write);
  const answer: Code = [
    ...op.set(settled, op.and(scope.value(conditions[0]), scope.value(conditions[1]))),
    ...op.set(roots.t0, op.select(op.get(roots.t0), NAN, op.get(settled))),
    ...op.set(roots.t1, op.select(op.get(roots.t1), NAN, op.get(settled))),
    ...(missed ? op.set(settled, op.or(op.get(settled), scope.value(missed))) : []),
  ];
  const lane = (n: number): Code => {
    const index = n === 0 ? LOW : HIGH;
    return op.when(
      op.both(op.get(BITS), op.i32(1 << n)),
      [
        ...op.storeLane(address('t0', index), 0, op.get(roots.t0), n),
        ...op.storeLane(address('t1', index), 0, op.get(roots.t1), n),
      ],
      op.when(op.less(op.plus(at, op.i32(4 * n)), op.get(END)), [
        ...op.storeInt(op.get(TO), 0, op.get(index)),
        ...op.set(TO, op.plus(op.get(TO), op.i32(4))),
      ]),
    );
  };
  const body: Code = [
    ...prologue,
    ...op.set(AT, op.get(LIST)),
    ...op.set(TO, op.get(LIST)),
    ...op.set(END, op.plus(op.get(LIST), op.shiftLeft(op.get(COUNT), op.i32(2)))),
    // The last of an odd number goes with itself.
    ...op.storeInt(op.get(END), 0, op.loadInt(op.minus(op.get(END), op.i32(4)), 0)),
    ...op.during(op.less(at, op.get(END)), [
      ...op.set(LOW, op.loadInt(at, 0)),
      ...op.set(HIGH, op.loadInt(at, 4)),
      ...loads,
      ...begin,
      ...op.set(BITS, op.i32(0)),
      ...(early
        ? op.when(op.anyTrue(scope.value(early)), [
            ...rest,
            ...answer,
            ...op.set(BITS, op.bitmask(op.get(settled))),
          ])
        : [...rest, ...answer, ...op.set(BITS, op.bitmask(op.get(settled)))]),
      ...lane(0),
      ...lane(1),
      ...op.set(AT, op.plus(at, op.i32(8))),
    ]),
    ...op.minus(op.get(TO), op.get(LIST)),
  ];
  return { name, params: LIST + 2, ints: VECTORS - LIST - 2, vectors: scope.count(), body };
}

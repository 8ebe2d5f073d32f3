import { describe, expect, test } from 'vitest';
import { ARENA, BLOCK, CAPACITY } from '../../../src/math/batch/simd-memory.ts';
import { blockKernel } from '../../../src/math/methods/certified/fast/block-kernel.ts';
import { flowOf, partsOf, scopeOf } from '../../../src/math/methods/certified/fast/flow.ts';
import {
  handed,
  LATTICE_NUMBERS,
  PLACE,
  SCALED_NUMBERS,
} from '../../../src/math/methods/certified/fast/layout.ts';
import { listKernel } from '../../../src/math/methods/certified/fast/list-kernel.ts';
import { certifiedModule } from '../../../src/math/methods/certified/fast/module.ts';
import { type Numbers, numberOf } from '../../../src/math/methods/certified/fast/prologue.ts';
import {
  AT_LATTICE as AT,
  AT_SCALED,
} from '../../../src/math/methods/certified/quadric-numbers.ts';
import { createScope } from '../../../src/math/wasm/locals.ts';
import * as op from '../../../src/math/wasm/ops.ts';
import { loopOf, type Statement } from '../../../src/math/wasm/source.ts';

/* What is read out of a loop's text, and what is said of a text that is none. */

const SOURCE = `

const LIMIT = 3;

export function other(n: number): void {
  for (let i = 0; i < n; i++) {
    const wrong = 1;
  }
}

export function pass(numbers: Float64Array): number {
  const { x: xs } = scratch;
  const first = numbers[AT.first] as number;
  const second = numbers[AT.second] as number;
  const bound = BOUNDS[1] as number;
  const hits = count[HITS] as number;
  for (let i = 0; i < hits; i++) {
    // const hidden = 5;
    const x = xs[i] as number;
    const y = hasY ? (ys[i] as number) : 0;
    const sum = x * first + (zs[i] as number) * y; // const after = 2;
    const long =
      sum -
      second;
    const clear = sum > bound && long < x;
    index[j] = i;
    if (clear) {
      out[j] = Math.abs(sum);
      t0[i] = Number.NaN;
      left += 1;
    } else {
      places[left++] = i;
    }
  }
  const later = numbers[AT.first] as number;
  return left;
}

export const arrow = (numbers: Float64Array): number => {
  const one = numbers[AT.one] as number;
  for (let j = 0; j < 3; j++) {
    const last = xs[j] as number;
  }
};
`;

describe('a loop', () => {
  const { constants, statements } = loopOf(SOURCE, 'pass', true);
  test('constants before it, without counts', () => {
    expect(constants).toEqual([
      { name: 'first', array: 'numbers', key: 'first' },
      { name: 'second', array: 'numbers', key: 'second' },
      { name: 'bound', array: 'BOUNDS', key: '1' },
    ]);
  });
  test('its statements in order; no comment, no index, no answer that is the same for all', () => {
    expect(statements.map(({ target, writes }) => `${target}${writes ? ' written' : ''}`)).toEqual([
      ...['x', 'y', 'sum', 'long', 'clear', 'out written'],
    ]);
    const formulas = statements.map(({ formula }) => formula.replace(/\s+/g, ' '));
    expect(formulas).toEqual([
      ...['xs__', 'ys__', 'x * first + zs__ * y', 'sum - second', 'sum > bound && long < x'],
      'Math.abs(sum)',
    ]);
  });
  test('without y', () => {
    const y = loopOf(SOURCE, 'pass', false).statements.find(({ target }) => target === 'y');
    expect(y?.formula).toBe('0');
  });
  test('of an arrow function', () => {
    const { constants: known, statements: all } = loopOf(SOURCE, 'arrow', true);
    expect([known.map(({ name }) => name), all.map(({ target }) => target)]).toEqual([
      ['one'],
      ['last'],
    ]);
  });
  test('a function that is missing is named, and so is one without a loop', () => {
    expect(() => loopOf(SOURCE, 'pas', true)).toThrow(/^no loop in pas$/);
    expect(() => loopOf(SOURCE, 'LIMIT', true)).toThrow(/^no loop in LIMIT$/);
    expect(() => loopOf('export function flat() {\n  return 1;\n}', 'flat', true)).toThrow(
      /^no loop in flat$/,
    );
  });
});

describe('names', () => {
  const nowhere: Numbers = { inMemory: {}, known: { BOUNDS: [1, 2] } };
  const value = (target: string, formula: string): Statement => ({
    target,
    writes: false,
    formula,
  });
  const codeOf = (statements: readonly Statement[]) => {
    const flow = flowOf([{ constants: [], statements }], [nowhere]);
    const where = { hand: op.i32(0), input: () => null, again: true };
    return partsOf(flow, [], [[]], where, scopeOf(flow, 0).scope).code(0);
  };
  test('one that is not known is named', () => {
    expect(() => codeOf([value('a', 'b + 1')])).toThrow(/^b is read but never written$/);
  });
  test('one that is known already is named', () => {
    expect(() => codeOf([value('a', '1'), value('a', '2')])).toThrow(/^a_0 is known already$/);
  });
  test('what only renames another value costs nothing', () => {
    const plain = codeOf([value('a', '1'), value('c', 'a + a')]);
    expect(codeOf([value('a', '1'), value('b', 'a'), value('c', 'b + a')])).toEqual(plain);
  });
  test('an inner scope sees the outer one, not the other way round, and no local has two names', () => {
    const scope = createScope(7);
    expect(scope.declare('a')).toBe(7);
    const [left, right] = [scope.inner(), scope.inner()];
    expect([left.declare('b'), right.declare('b'), left.declare('a')]).toEqual([8, 9, 10]);
    expect(left.value('b')).toEqual(op.get(8));
    expect(right.value('b')).toEqual(op.get(9));
    expect(right.value('a')).toEqual(op.get(7));
    expect(left.value('a')).toEqual(op.get(10));
    expect(() => scope.value('b')).toThrow(/^b is not known$/);
    expect([scope.count(), left.count()]).toEqual([4, 4]);
  });
  test('a constant that is in no list is named with its key', () => {
    expect(() => numberOf('BOUNDS', '2', nowhere)).toThrow(/^BOUNDS\[2\] is not known$/);
    expect(() => numberOf('LIMITS', '0', nowhere)).toThrow(/^LIMITS\[0\] is not known$/);
  });
  test('an array that is read and never written is named', () => {
    const rough = [value('clear', '1 < 2'), value('missed', '2 < 1'), value('remote', '1 < 2')];
    const loop = (statements: readonly Statement[]) => ({ constants: [], statements });
    const make = (first: readonly Statement[], cuts: readonly (readonly [string, 0])[]) =>
      blockKernel(
        'f',
        [nowhere, nowhere, nowhere],
        [loop(first), loop([value('g', '1 + gs__')]), loop([value('settled', '1 < 2')])],
        cuts,
      );
    expect(() => make(rough, [['missed', 0]])).toThrow(/^gs__ is read but never written$/);
    expect(() => make(rough.slice(0, 2), [['missed', 0]])).toThrow(/^remote is not known$/);
    expect(() => make(rough, [['gone', 0]])).toThrow(/^no gone to cut after$/);
    expect(() => make(rough, [])).toThrow(/^f has no parts$/);
  });
  test("a stage's verdict that it does not reach is named", () => {
    const loop = { constants: [], statements: [value('clear', '1 < 2'), value('x', '1 + 1')] };
    const verdicts = { clear: 'clear', settled: 'sure', missed: null };
    const make = (cuts: readonly string[]) => listKernel('f', nowhere, loop, verdicts, cuts);
    expect(() => make(['clear'])).toThrow(/^sure is read but never written$/);
    expect(() => make([])).toThrow(/^f has no parts$/);
  });
  test('more values than there is room for are refused', () => {
    expect(() => handed(1000)).toThrow(/^no room to hand on 1001 values$/);
  });
});

describe("the kernels' memory", () => {
  test('nothing lies upon anything else', () => {
    const numbers = [
      [LATTICE_NUMBERS, 8 * Object.keys(AT).length],
      [SCALED_NUMBERS, 8 * Object.keys(AT_SCALED).length],
    ] as const;
    const arrays = Object.values(BLOCK).map((at) => [at, 8 * CAPACITY] as const);
    const lists = (['doubtful', 'unsettled'] as const).map(
      (name) => [PLACE[name], 4 * (CAPACITY + 1)] as const,
    );
    const all = [
      ...numbers,
      ...arrays,
      ...lists,
      [PLACE.doubtfulBytes, 4] as const,
      [handed(0), 0] as const,
    ];
    const ordered = all.toSorted(([a], [b]) => a - b);
    ordered.forEach(([at, bytes], k) => {
      expect(at + bytes).toBeLessThanOrEqual(ordered[k + 1]?.[0] ?? ARENA);
    });
  });

  test('what the passes hand on lies before the arrays of rays', () => {
    // Every store's offset is in the module's text; the arrays' begin is the end of all.
    const stores = offsetsOf(certifiedModule());
    expect(stores.length).toBeGreaterThan(20);
    expect(Math.max(...stores) + 8 * 128).toBeLessThanOrEqual(ARENA);
    expect(Math.max(...stores)).toBeGreaterThanOrEqual(handed(10));
  });
});

/** The constant offsets of v128.store. */
function offsetsOf(bytes: Uint8Array): number[] {
  const found: number[] = [];
  for (let k = 0; k + 3 < bytes.length; k++) {
    if (bytes[k] !== 0xfd || bytes[k + 1] !== 11 || bytes[k + 2] !== 3) continue;
    let offset = 0;
    for (let at = k + 3, shift = 0; ; at++, shift += 7) {
      const byte = bytes[at] as number;
      offset += (byte & 0x7f) * 2 ** shift;
      if (byte < 128) break;
    }
    found.push(offset);
  }
  return found;
}

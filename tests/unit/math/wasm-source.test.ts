import { readFileSync } from 'node:fs';
import { describe, expect, test } from 'vitest';
import { blockKernel } from '../../../scripts/kernels/certified/block-kernel.ts';
import { flowOf, partsOf, scopeOf } from '../../../scripts/kernels/certified/flow.ts';
import { fileOf, GENERATED } from '../../../scripts/kernels/certified/generated.ts';
import { listKernel } from '../../../scripts/kernels/certified/list-kernel.ts';
import {
  certifiedModule,
  oneRayText,
  stageSources,
} from '../../../scripts/kernels/certified/module.ts';
import { ONE_RAY } from '../../../scripts/kernels/certified/one-ray.ts';
import { type Numbers, numberOf } from '../../../scripts/kernels/certified/prologue.ts';
import {
  expressionOf,
  loopOf,
  type Source,
  type Statement,
} from '../../../scripts/kernels/certified/source.ts';
import { createScope } from '../../../scripts/kernels/wasm/locals.ts';
import { moduleOf } from '../../../scripts/kernels/wasm/module.ts';
import * as op from '../../../scripts/kernels/wasm/ops.ts';
import {
  ARENA,
  BLOCK,
  bytesOf,
  CAPACITY,
  createSimdMemory,
  IMPORT,
  PAGES,
} from '../../../src/math/batch/simd-memory.ts';
import { CERTIFIED_SIMD } from '../../../src/math/methods/certified/generated/certified-simd.ts';
import { AT_LATTICE as AT, AT_SCALED } from '../../../src/math/methods/certified/numbers.ts';
import {
  handed,
  LATTICE_NUMBERS,
  LONG,
  PARAMS,
  PLACE,
  SCALED_NUMBERS,
} from '../../../src/math/methods/certified/simd.ts';
import { seeded } from '../../../src/math/rng.ts';

/* What is read out of a loop's text, and what is said of a text that is none. */

const SOURCE = `
import { A } from './a.ts';

const LIMIT = 3;

export function other(n: number): void {
  for (let i = 0; i < n; i++) {
    const wrong = 1;
  }
}

export function pass(numbers: Float64Array): number {
  const { x: xs, out } = scratch;
  const first = numbers[AT.first] as number;
  const second = numbers[AT.second] as number;
  const bound = BOUNDS[AT.bound] as number;
  const hits = count[HITS] as number;
  let left = 0;
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
  count[HITS] = left;
  return left;
}

export const arrow = (numbers: Float64Array): number => {
  const one = numbers[AT.one] as number;
  for (let j = 0; j < 3; j++) {
    const last = xs[j] as number;
  }
};
`;
const source = (text: string): Source => ({ file: 'stage.ts', text });

describe('a loop', () => {
  const { constants, statements } = loopOf(source(SOURCE), 'pass', true);
  test('constants before it, without counts', () => {
    expect(constants).toEqual([
      { name: 'first', array: 'numbers', key: 'first' },
      { name: 'second', array: 'numbers', key: 'second' },
      { name: 'bound', array: 'BOUNDS', key: 'bound' },
    ]);
  });
  test('its statements in order; no comment, no index, no answer that is the same for all', () => {
    expect(statements.map(({ target, writes }) => `${target}${writes ? ' written' : ''}`)).toEqual([
      ...['x', 'y', 'sum', 'long', 'clear', 'out written'],
    ]);
    expect(statements.map(({ formula }) => formula)).toEqual(
      ['x__', 'ys__', 'x * first + zs__ * y', 'sum - second', 'sum > bound && long < x']
        .concat('Math.abs(sum)')
        .map(expressionOf),
    );
  });
  test('each says in which line it stands', () => {
    expect(statements.map(({ at }) => at)).toEqual(
      [21, 22, 23, 24, 27, 30].map((line) => `stage.ts:${line}`),
    );
  });
  test('without y', () => {
    const y = loopOf(source(SOURCE), 'pass', false).statements.find(({ target }) => target === 'y');
    expect(y?.formula).toEqual({ op: 'number', value: 0 });
  });
  test('of an arrow function', () => {
    const { constants: known, statements: all } = loopOf(source(SOURCE), 'arrow', true);
    expect([known.map(({ name }) => name), all.map(({ target }) => target)]).toEqual([
      ['one'],
      ['last'],
    ]);
  });
  test('a function that is missing is named, and so is one without a loop', () => {
    const missing = /^stage\.ts: no exported function \w+$/;
    expect(() => loopOf(source(SOURCE), 'pas', true)).toThrow(missing);
    expect(() => loopOf(source(SOURCE), 'LIMIT', true)).toThrow(missing);
    const flat = source('export function flat() {\n}');
    expect(() => loopOf(flat, 'flat', true)).toThrow(/^stage\.ts:1: { has no loop$/);
  });
});

/** A stage with these statements in its loop, in lines 4 and after. */
const stage = (...inLoop: readonly string[]): Source =>
  source(
    [
      'export function pass(numbers: Float64Array): number {',
      '  const first = numbers[AT.first] as number;',
      '  for (let j = 0; j < 3; j++) {',
      ...inLoop,
      '  }',
      '  return first;',
      '}',
    ].join('\n'),
  );

describe('what the compiler does not understand is refused, with file and line', () => {
  const refused: [string, Source, RegExp][] = [
    ['a variable', stage('let x = 1;'), /^stage\.ts:4: let x = 1; is not understood$/],
    ['a call', stage('const x = 1;', 'const y = f(x);'), /^stage\.ts:5: f\(x\) is not/],
    ['an unknown function', stage('const x = Math.cbrt(2);'), /^stage\.ts:4: Math\.cbrt\(2\) is/],
    ['too many operands', stage('const x = Math.abs(1, 2);'), /^stage\.ts:4: Math\.abs\(1, 2\) is/],
    ['a power', stage('const x = 2 ** 3;'), /^stage\.ts:4: 2 \*\* 3 is not understood$/],
    ['an equality', stage('const x = 2 === 3;'), /^stage\.ts:4: 2 === 3 is not understood$/],
    ['an or', stage('const x = 1 < 2 || 2 < 1;'), /^stage\.ts:4: 1 < 2 \|\| 2 < 1 is/],
    ['a choice', stage('const x = first ? 1 : 2;'), /^stage\.ts:4: first \? 1 : 2 is/],
    ['a text', stage("const x = 'a';"), /^stage\.ts:4: 'a' is no number$/],
    ['an element without its type', stage('const x = xs[j];'), /^stage\.ts:4: xs\[j\] is/],
    ['another cast', stage('const x = xs[j] as 5;'), /^stage\.ts:4: xs\[j\] as 5 is/],
    ['a loop in a loop', stage('while (first) {}'), /^stage\.ts:4: while \(first\) {} is/],
    [
      'a condition of no name',
      stage('if (1 < 2) {}'),
      /^stage\.ts:4: 1 < 2 is none of the verdicts/,
    ],
    ['an unknown verdict', stage('if (sure) {}'), /^stage\.ts:4: sure is none of the verdicts/],
    ['a count by two', stage('left += 2;'), /^stage\.ts:4: left \+= 2 is not understood$/],
    ['a change', stage('x = 2;'), /^stage\.ts:4: x = 2 is not understood$/],
    [
      'a slot by its bare number',
      source('export function pass() {\n  const x = B[3] as number;\n  for (;;) {}\n}'),
      /^stage\.ts:2: const x = B\[3\] as number; is not understood$/,
    ],
    ['two loops', stage('}', 'for (;;) {'), /^stage\.ts:5: for \(;;\) { is a second loop$/],
    ['no TypeScript', stage('const = 3;'), /^stage\.ts:4: /],
  ];
  test.each(refused)('%s', (_, text, message) => {
    expect(() => loopOf(text, 'pass', true)).toThrow(message);
    expect(() => loopOf(text, 'pass', true)).toThrow(SyntaxError);
  });
});

describe('the generated file', () => {
  const sources = stageSources();
  test('is what the stages compile to today: else `npm run kernels`', () => {
    expect(readFileSync(GENERATED, 'utf8')).toBe(fileOf(certifiedModule()));
    expect(bytesOf(CERTIFIED_SIMD)).toEqual(certifiedModule());
  });
  test('for one ray, too', () => {
    expect(readFileSync(ONE_RAY, 'utf8')).toBe(oneRayText());
    const { file, text } = sources.units;
    const other = {
      ...sources,
      units: { file, text: text.replaceAll('const remote =', 'const distant =') },
    };
    expect(() => oneRayText(other)).toThrow(/^remote is not known$/);
  });
  test('another name for a value changes no byte', () => {
    const { file, text } = sources.recentred;
    const other = { ...sources, recentred: { file, text: text.replaceAll('overSize', 'sized') } };
    expect(other.recentred.text).not.toBe(text);
    expect(certifiedModule(other)).toEqual(certifiedModule());
  });
  test('a value without a definition is named', () => {
    const { file, text } = sources.refined;
    const other = { ...sources, refined: { file, text: text.replace('const Sp =', 'const Sq =') } };
    expect(() => certifiedModule(other)).toThrow(/^Sp is read but never written$/);
  });
});

test('a small loop, compiled and run: the bits of the same loop in TypeScript', () => {
  const loop = loopOf(
    stage(
      ...[
        'const x = dx[j] as number;',
        'const y = Ex[j] as number;',
        'const clear = x > first && y < 2.5;',
      ],
      ...['const near = Math.sqrt(x) / (y - first) + y * y;', 'const settled = near < 9 * x;'],
      ...['if (settled) {', 't0[j] = near;', 't1[j] = near * x;', '} else places[left++] = i;'],
    ),
    'pass',
    true,
  );
  const first = 0.3;
  const verdicts = { clear: 'clear', settled: 'settled', missed: null };
  const kernel = listKernel(
    'run',
    { inMemory: {}, known: { numbers: { first } } },
    loop,
    verdicts,
    ['clear'],
  );
  const memory = createSimdMemory();
  const { run } = memory.load(moduleOf([kernel], { ...IMPORT, pages: PAGES }));
  const random = seeded(167);
  const { dx, Ex, t0, t1 } = memory.block;
  const count = 101;
  for (let i = 0; i < count; i++) [dx[i], Ex[i]] = [2 * random(), 5 * random() - 2];
  const list = new Int32Array(memory.buffer, PLACE.doubtful, count + 1);
  for (let i = 0; i < count; i++) list[i] = i;
  const places = PARAMS.map((name) => PLACE[name]);
  const left = (run?.(...places, PLACE.doubtful, count) ?? 0) / 4;
  const open = new Set(list.slice(0, left));
  expect([open.size, left > 0 && left < count]).toEqual([left, true]);
  for (let i = 0; i < count; i++) {
    const [x, y] = [dx[i] as number, Ex[i] as number];
    const near = Math.sqrt(x) / (y - first) + y * y;
    const settled = x > first && y < 2.5 && near < 9 * x;
    expect([i, open.has(i)]).toEqual([i, !settled]);
    if (settled) expect([t0[i], t1[i]]).toEqual([near, near * x]);
  }
});

describe('names', () => {
  const nowhere: Numbers = { inMemory: {}, known: { BOUNDS: { least: 1 } } };
  const value = (target: string, formula: string): Statement => ({
    target,
    writes: false,
    formula: expressionOf(formula),
    at: 'stage.ts:1',
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
  test('an inner scope sees the outer one, not vice versa; no local has two names', () => {
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
    expect(() => numberOf('BOUNDS', 'most', nowhere)).toThrow(/^BOUNDS\[most\] is not known$/);
    expect(() => numberOf('LIMITS', 'least', nowhere)).toThrow(/^LIMITS\[least\] is not known$/);
  });
  test('an array that is read and never written is named', () => {
    const rough = ['clear', 'missed', 'beside', 'remote'].map((name) => value(name, '1 < 2'));
    const loop = (statements: readonly Statement[]) => ({ constants: [], statements });
    const make = (first: readonly Statement[], cuts: readonly (readonly [string, 0])[]) =>
      blockKernel(
        'f',
        [nowhere, nowhere, nowhere],
        [loop(first), loop([value('g', '1 + gs__')]), loop([value('settled', '1 < 2')])],
        cuts,
      );
    expect(() => make(rough, [['missed', 0]])).toThrow(/^gs__ is read but never written$/);
    expect(() => make(rough.slice(0, 2), [['missed', 0]])).toThrow(/^beside is not known$/);
    expect(() => make(rough.slice(0, 3), [['missed', 0]])).toThrow(/^remote is not known$/);
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
    const lists = (['doubtful', 'unsettled', 'starting'] as const).map(
      (name) => [PLACE[name], 4 * (LONG + 1)] as const,
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

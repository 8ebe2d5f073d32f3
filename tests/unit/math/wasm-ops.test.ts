import { describe, expect, test } from 'vitest';
import { moduleOf } from '../../../scripts/kernels/wasm/module.ts';
import * as op from '../../../scripts/kernels/wasm/ops.ts';
import { leb, signedLeb } from '../../../scripts/kernels/wasm/ops.ts';
import { integer, seeded } from '../../../src/math/rng.ts';
import { ONE_PAGE } from './compiled.ts';

/*
 * LEB128 by the definition of the WebAssembly Core Specification, section 5.2.2, and by what an
 * engine reads.
 */

const unsignedOf = (bytes: readonly number[]): number =>
  bytes.reduce((sum, byte, k) => sum + (byte & 0x7f) * 2 ** (7 * k), 0);
const signedOf = (bytes: readonly number[]): number =>
  unsignedOf(bytes) - ((bytes.at(-1) as number) & 0x40 ? 2 ** (7 * bytes.length) : 0);
const wellFormed = (bytes: readonly number[]): boolean =>
  bytes.every((byte, k) => byte <= 255 && byte >> 7 === (k < bytes.length - 1 ? 1 : 0));

const around = (limits: readonly number[]): number[] => limits.flatMap((x) => [x - 1, x, x + 1]);

describe('LEB128', () => {
  test('published examples', () => {
    expect(leb(624485)).toEqual([0xe5, 0x8e, 0x26]);
    expect(signedLeb(-123456)).toEqual([0xc0, 0xbb, 0x78]);
    expect([leb(0), signedLeb(0), signedLeb(-1)]).toEqual([[0], [0], [0x7f]]);
    expect([leb(127), leb(128), leb(16383), leb(16384)].map((b) => b.length)).toEqual([1, 2, 2, 3]);
    expect(signedLeb(63)).toEqual([0x3f]);
    expect(signedLeb(64)).toEqual([0xc0, 0]);
    expect(signedLeb(-64)).toEqual([0x40]);
    expect(signedLeb(-65)).toEqual([0xbf, 0x7f]);
  });

  test('numbers without a sign, at the limits of bytes and anywhere (seed 151)', () => {
    const random = seeded(151);
    const some = Array.from({ length: 500 }, () =>
      integer(random, 0, 2 ** integer(random, 1, 32) - 1),
    );
    const limits = around([2 ** 7, 2 ** 14, 2 ** 21, 2 ** 28]);
    for (const x of [...some, ...limits, 0, 2 ** 31 - 1, 2 ** 31, 2 ** 32 - 1]) {
      const bytes = leb(x);
      expect([unsignedOf(bytes), wellFormed(bytes)]).toEqual([x, true]);
      expect(bytes.length).toBe(Math.max(1, Math.ceil(Math.log2(x + 1) / 7)));
    }
  });

  test('32-bit numbers with a sign (seed 152)', () => {
    const random = seeded(152);
    const some = Array.from({ length: 500 }, () =>
      integer(random, 0, 2 ** integer(random, 1, 31) - 1),
    );
    const limits = around([2 ** 6, 2 ** 13, 2 ** 20, 2 ** 27]);
    for (const size of [...some, ...limits, 2 ** 31 - 1]) {
      for (const x of [size, -size, -size - 1]) {
        const bytes = signedLeb(x);
        expect([signedOf(bytes), wellFormed(bytes)]).toEqual([x === 0 ? 0 : x, true]);
        expect(bytes.length).toBeLessThanOrEqual(5);
      }
    }
  });

  test('an engine reads the same numbers', () => {
    const numbers = [0, 1, 63, 64, 127, 128, 8191, 8192, 2 ** 20, 2 ** 27, 2 ** 31 - 1].flatMap(
      (x) => [x, -x, -x - 1],
    );
    const bytes = moduleOf(
      numbers.map((x, k) => ({ name: `f${k}`, params: 0, ints: 0, vectors: 0, body: op.i32(x) })),
      ONE_PAGE,
    );
    const module = new WebAssembly.Module(bytes as BufferSource);
    const memory = new WebAssembly.Memory({ initial: 1 });
    const { exports } = new WebAssembly.Instance(module, { batch: { memory } });
    numbers.forEach((x, k) => {
      expect((exports[`f${k}`] as () => number)()).toBe(x === 0 ? 0 : x);
    });
  });
});

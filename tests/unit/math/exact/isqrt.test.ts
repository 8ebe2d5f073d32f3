import { expect, test } from 'vitest';
import { bitLength, isqrt } from '../../../../src/math/exact/isqrt.ts';
import { integer, seeded } from '../../../../src/math/rng.ts';

test('bitLength on both sides of every power of two up to 2^3000', () => {
  expect(bitLength(0n)).toBe(0);
  for (let k = 1; k <= 3000; k++) {
    expect(bitLength(1n << BigInt(k))).toBe(k + 1);
    expect(bitLength((1n << BigInt(k)) - 1n)).toBe(k);
    expect(bitLength(-(1n << BigInt(k)) + 1n)).toBe(k);
  }
});

test('isqrt of 0 to 10000', () => {
  for (let n = 0; n <= 10000; n++) expect(isqrt(BigInt(n))).toBe(BigInt(Math.floor(Math.sqrt(n))));
});

test('isqrt one below, at and above squares of 1 to 9000 bits, 3000 roots (seed 5)', () => {
  const random = seeded(5);
  for (let i = 0; i < 3000; i++) {
    const root = randomBits(integer(random, 1, i < 2900 ? 300 : 9000), random);
    const n = root * root;
    const right = isqrt(n) === root && isqrt(n - 1n) === root - 1n && isqrt(n + 2n * root) === root;
    if (!right) expect.fail(`${root}`);
  }
});

test('isqrt at all ones and at powers of two, where seeds round up', () => {
  for (let k = 1n; k <= 1200n; k++) {
    const ones = (1n << k) - 1n;
    expect(isqrt(ones * ones - 1n)).toBe(ones - 1n);
    expect(isqrt(ones * ones)).toBe(ones);
    expect(isqrt((1n << (2n * k)) - 1n)).toBe(ones);
  }
});

test('a negative number has none', () => {
  expect(() => isqrt(-1n)).toThrow('n ≥ 0, got -1');
});

function randomBits(size: number, random: () => number): bigint {
  let n = 1n;
  for (let i = 1; i < size; i++) n = (n << 1n) | (random() < 0.5 ? 0n : 1n);
  return n;
}

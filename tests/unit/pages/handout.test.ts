import { encode } from 'uqr';
import { expect, test } from 'vitest';
import { CODE, codeOf } from '../../../src/pages/handout/link-code.ts';

const linkOf = (bytes: number): string => 'https://example.org/#/'.padEnd(bytes, 'x');

test('the longest link that has a code is the longest that such a code holds', () => {
  expect(codeOf(linkOf(CODE.mostBytes))).not.toBeTypeOf('string');
  expect(codeOf(linkOf(CODE.mostBytes + 1))).toBe(
    `No QR code: this link has ${CODE.mostBytes + 1} bytes, and one that phones read from paper ` +
      `holds ${CODE.mostBytes}.`,
  );
  expect(() => encode(linkOf(CODE.mostBytes + 1), CODE.options)).toThrow();
});

test('bytes count, and not characters', () => {
  const link = `https://example.org/#/${'é'.repeat(CODE.mostBytes / 2)}`;
  expect(link.length).toBeLessThan(CODE.mostBytes);
  expect(codeOf(link)).toMatch(/^No QR code: this link has \d+ bytes/);
});

test('a module is 0.3 mm at least', () => {
  const modules = codeOf(linkOf(CODE.mostBytes));
  if (typeof modules === 'string') throw new Error(modules);
  expect(CODE.millimetres / modules.length).toBeGreaterThan(0.3);
});

test('the path of a file on this device is of no use to another one', () => {
  expect(codeOf('file:///home/me/graze.html#/lesson/ray')).toMatch(/opened from a file/);
});

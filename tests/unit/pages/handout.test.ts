import { encode } from 'uqr';
import { expect, test } from 'vitest';
import { QR_CODE, qrRows } from '../../../src/pages/handout/qr-code.ts';

const linkOf = (bytes: number): string => 'https://example.org/#/'.padEnd(bytes, 'x');

test('the longest link that has a code is the longest that such a code holds', () => {
  expect(qrRows(linkOf(QR_CODE.mostBytes))).not.toBeTypeOf('string');
  expect(qrRows(linkOf(QR_CODE.mostBytes + 1))).toBe(
    `No QR code: this link has ${QR_CODE.mostBytes + 1} bytes, and one that phones read from ` +
      `paper holds ${QR_CODE.mostBytes}.`,
  );
  expect(() => encode(linkOf(QR_CODE.mostBytes + 1), QR_CODE.options)).toThrow();
});

test('bytes count, and not characters', () => {
  const link = `https://example.org/#/${'é'.repeat(QR_CODE.mostBytes / 2)}`;
  expect(link.length).toBeLessThan(QR_CODE.mostBytes);
  expect(qrRows(link)).toMatch(/^No QR code: this link has \d+ bytes/);
});

test('a module is 0.3 mm at least', () => {
  const modules = qrRows(linkOf(QR_CODE.mostBytes));
  if (typeof modules === 'string') throw new Error(modules);
  expect(QR_CODE.millimetres / modules.length).toBeGreaterThan(0.3);
});

test('the path of a file on this device is of no use to another one', () => {
  expect(qrRows('file:///home/me/graze.html#/lesson/ray')).toMatch(/opened from a file/);
});

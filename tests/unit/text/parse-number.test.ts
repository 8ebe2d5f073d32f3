import fc from 'fast-check';
import { describe, expect, it } from 'vitest';
import { display, displayAll, shortest } from '../../../src/text/format.ts';
import { hintOn, parseNumber } from '../../../src/text/parse.ts';
import { anyDouble, SEED } from './doubles.ts';

const read = (text: string) => {
  const parsed = parseNumber(text);
  return parsed.ok ? parsed.value : parsed.reason;
};

describe('parseNumber: what people type', () => {
  it.each<[string, number]>([
    ['3', 3],
    [' 3 ', 3],
    ['-0', -0],
    ['+5', 5],
    ['.5', 0.5],
    ['5.', 5],
    ['1e7', 1e7],
    ['1E-7', 1e-7],
    ['−3', -3],
    ['0,5', 0.5],
    ['−0,5 + 1,25', 0.75],
    ['1/3', 1 / 3],
    ['sqrt(2)', Math.SQRT2],
    ['Math.sqrt(2)', Math.SQRT2],
    ['√2', Math.SQRT2],
    ['√(1+1)', Math.SQRT2],
    ['√√16', 2],
    ['3√4', Number.NaN],
    ['√2/2', Math.SQRT2 / 2],
    ['√3^2', Math.sqrt(3) ** 2],
    ['pi', Math.PI],
    ['2·π', 2 * Math.PI],
    ['2 × 3', 6],
    ['-2^-40', -(2 ** -40)],
    ['2^3^2', 512],
    ['2**10', 1024],
    ['-2^2', -4],
    ['(-2)^2', 4],
    ['2·10^-3', 0.002],
    ['2·10⁻³', 0.002],
    ['−10⁷', -1e7],
    ['1e-7*1e7', 1],
    ['8 - 2 - 1', 5],
    ['abs(-3) + cos(0) + exp(0) + ln(1)', 5],
    ['-(-(3))', 3],
    ['0*5', 0],
    ['0/5', 0],
    ['9007199254740993', 9007199254740992],
    ['5e-324', 5e-324],
    ['1.7976931348623157e308', Number.MAX_VALUE],
    ['0e999', 0],
    ['-0^1', 0],
    ['sqrt 2^2', 2],
    ['2^sqrt(4)^2', 16],
    ['2^-sqrt 4', 0.25],
    ['sin(30 deg)', 0.5],
    ['sin(-30°)', -0.5],
    ['cos(120°)', -0.5],
    ['tan 45°', 1],
    ['tan(135 deg)', -1],
    ['tan(60°)^2', Math.sqrt(3) ** 2],
    ['cos(450 deg)', 0],
    ['90 deg', Math.PI / 2],
    ['sin(0.5 rad)', Math.sin(0.5)],
    ['tan(10 deg)', Math.tan(10 * (Math.PI / 180))],
  ])('%s', (text, value) => {
    if (Number.isNaN(value)) expect(read(text)).toBe(`'${text}' is not a number`);
    else expect(read(text)).toBe(value);
  });
});

describe('parseNumber: reasons', () => {
  it.each([
    ['', 'type a number, such as 1/3 or sqrt(2)'],
    [' \t', 'type a number, such as 1/3 or sqrt(2)'],
    ['abc', "'abc' is not a number"],
    ['1/', "'1/' is not a number"],
    ['1 2', "'1 2' is not a number"],
    ['1,234,567', "'1,234,567' is not a number"],
    ['1/0', "'1/0' is infinite"],
    ['-1/0', "'-1/0' is infinite"],
    ['ln(0)', "'ln(0)' is infinite"],
    ['0^-1', "'0^-1' is infinite"],
    ['Infinity', "'Infinity' is infinite"],
    ['tan(90°)', "'tan(90°)' is infinite"],
    ['∞', "'∞' is infinite"],
    ['0/0', "'0/0' has no real value"],
    ['sqrt(-1)', "'sqrt(-1)' has no real value"],
    ['1e400', "'1e400' is beyond the largest double"],
    ['-1e400', "'-1e400' is beyond the largest double"],
    ['1 + 1e400', "'1e400' is beyond the largest double"],
    ['10^400', "'10^400' is beyond the largest double"],
    ['1e300/1e-300', "'1e300/1e-300' is beyond the largest double"],
    ['exp(1000)', "'exp(1000)' is beyond the largest double"],
    ['1e308+1e308', "'1e308+1e308' is beyond the largest double"],
    ['1e-400', "'1e-400' is below the smallest double"],
    ['2^-1080', "'2^-1080' is below the smallest double"],
    ['exp(-1000)', "'exp(-1000)' is below the smallest double"],
    ['1e-200*1e-200', "'1e-200*1e-200' is below the smallest double"],
    ['1e-300/1e300', "'1e-300/1e300' is below the smallest double"],
    ['x'.repeat(50), `'${'x'.repeat(31)}…' is not a number`],
    ['1'.repeat(201), `'${'1'.repeat(31)}…' is longer than 200 characters`],
  ])('%j: %s', (text, reason) => {
    expect(parseNumber(text)).toEqual({ ok: false, reason });
  });

  it('takes an infinity only from those who ask, and NaN from nobody', () => {
    const lenient = (text: string) => parseNumber(text, { allowInfinity: true });
    expect(lenient('-Infinity')).toEqual({ ok: true, value: Number.NEGATIVE_INFINITY });
    expect(lenient('1/0')).toEqual({ ok: true, value: Number.POSITIVE_INFINITY });
    expect(lenient('1/Infinity')).toEqual({ ok: true, value: 0 });
    for (const text of ['NaN', 'Infinity - Infinity', '0/0', '1e400', '1e-400'])
      expect(lenient(text).ok).toBe(false);
  });
});

describe('hintOn: angles without a unit', () => {
  it.each([
    ['tan(30)', 'tan is taken in radians; tan(30 deg) in degrees'],
    ['1 + 2·sin 60', 'sin is taken in radians; sin(60 deg) in degrees'],
    ['sqrt(cos(1/3))', 'cos is taken in radians; cos((1/3) deg) in degrees'],
  ])('%s', (text, hint) => {
    expect(hintOn(text)).toBe(hint);
    expect(read(hint.slice(hint.indexOf(';') + 2, hint.indexOf(' in degrees')))).not.toBe(
      read(text),
    );
  });

  it.each(['tan(30°)', 'tan(0.5 rad)', 'tan(pi/6)', 'sin(0)', '30', 'sqrt(2)', 'tan(', 'abc'])(
    'says nothing on %s',
    (text) => {
      expect(hintOn(text)).toBeNull();
    },
  );
});

describe('parseNumber: hostile texts', () => {
  const hostile = [
    'constructor',
    '__proto__',
    'prototype',
    'toString',
    'hasOwnProperty',
    'valueOf',
    '__defineGetter__',
    'constructor.constructor("return 1")()',
    'sqrt.constructor',
    '(1).constructor',
    '1 .toFixed',
    'pi.x',
    'sqrt',
    'random()',
    'fac(5)',
    '5!',
    'min(1,2)',
    'max(1)',
    'if(1,2,3)',
    'roundTo(1)',
    'gamma(3)',
    'hypot(3;4)',
    'x = 5',
    'x',
    'f(x) = x',
    'f(x) = x; f(2)',
    '1; 2',
    '1;',
    '[1]',
    '[1][0]',
    '{}',
    '"1"',
    "'1'",
    '`1`',
    '1 == 1',
    '1 < 2',
    'true',
    'false',
    'null',
    'undefined',
    'NaN',
    'not 1',
    '1 and 1',
    '1 ? 2 : 3',
    '1 || 2',
    '1 in 2',
    '5 % 3',
    'length 3',
    'alert(1)',
    'globalThis',
    'this',
    '() => 1',
    '0x10',
    '0b11',
    '1_000',
    '1n',
    '1/*2*/+1',
    '1//2',
    '--',
    '(',
    ')',
    '()',
    'sqrt()',
    'sqrt(1, 2)',
    '2(3)',
    'pi(3)',
    '1.2.3',
    '1e',
    'e5',
    '1e+',
    '.',
    ',',
    '+',
    '<script>',
    '\u0000',
    '١٢',
    '𝟙',
    '½',
    'E',
    'PI2',
    'ln',
    'ln()',
    '(sqrt)(4)',
    'sqrt√sqrt',
    'deg',
    'deg 3',
    '3 deg deg',
    'sin(30)°',
    '^2',
    '10^',
    '10^^2',
    '·3',
    '²',
    '5 ()',
  ];

  it.each(hostile)('refuses %j', (text) => {
    const parsed = parseNumber(text, { allowInfinity: true });
    expect(parsed).toEqual({ ok: false, reason: expect.stringMatching(/^'.+' is not a number$/s) });
  });

  it(`any text gives a number or a short reason, and changes nothing (seed ${SEED})`, () => {
    const alphabet = [
      ...'0123456789.,+-*/^()e√π·−²⁻ ',
      'sqrt',
      'pi',
      'constructor',
      '__proto__',
      '=',
      ';',
      '[',
      '"',
    ];
    const text = fc
      .array(fc.constantFrom(...alphabet), { maxLength: 40 })
      .map((parts) => parts.join(''));
    fc.assert(
      fc.property(fc.oneof(text, fc.string({ unit: 'binary' })), (line) => {
        const parsed = parseNumber(line);
        if (parsed.ok) expect(Number.isFinite(parsed.value)).toBe(true);
        else expect(parsed.reason.length).toBeLessThan(90);
      }),
      { seed: SEED, numRuns: 5000 },
    );
    expect(Object.keys(Object.prototype)).toEqual([]);
  });

  it('survives 100 open brackets and 199 minus signs', () => {
    expect(read(`${'('.repeat(99)}1${')'.repeat(99)}`)).toBe(1);
    expect(read(`${'-'.repeat(198)}1`)).toBe(1);
    expect(parseNumber('√('.repeat(100)).ok).toBe(false);
  });
});

describe('parseNumber: round trips', () => {
  it(`reads back the bits of shortest and of displayAll (seed ${SEED})`, () => {
    fc.assert(
      fc.property(anyDouble, (x) => {
        expect(read(shortest(x))).toBe(x);
        expect(read(displayAll(x))).toBe(x);
      }),
      { seed: SEED, numRuns: 4000, examples: [[-0], [Number.MAX_VALUE], [5e-324], [1e21], [1e-7]] },
    );
  });

  it(`reads what display shows as the same six digits (seed ${SEED})`, () => {
    fc.assert(
      fc.property(anyDouble, (x) => {
        // The smallest doubles have fewer than six digits of room: 4.94066e-324 reads back as
        // itself all the same.
        expect(read(display(x))).toBe(
          Math.abs(x) < 1e-300 ? read(display(x)) : Number(x.toPrecision(6)),
        );
      }),
      { seed: SEED, numRuns: 2000 },
    );
  });
});

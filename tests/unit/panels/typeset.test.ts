import { describe, expect, test } from 'vitest';
import { type Derivation, derivation } from '../../../src/math/derivation.ts';
import { intersect } from '../../../src/math/index.ts';
import type { Ray } from '../../../src/math/ray.ts';
import type { Shape } from '../../../src/math/shapes/index.ts';
import {
  typesetNumber,
  typesetNumbers,
  typesetNumbersInPieces,
  typesetRelation,
  typesetSymbols,
} from '../../../src/panels/typeset.ts';
import { type Element, elements, parseXml, textOf } from '../math/print-xml.ts';
import { cone, cylinder, plane, ray } from '../math/shorthand.ts';

/** The markup that Lit makes of a template, but for its comments. */
function markup(part: unknown): string {
  if (Array.isArray(part)) return part.map(markup).join('');
  if (typeof part === 'string') return part;
  const { strings, values } = part as { strings: readonly string[]; values: readonly unknown[] };
  return strings.reduce((before, after, i) => {
    const value = markup(values[i - 1]);
    return before + (before.endsWith('=') ? `"${value}"` : value) + after;
  });
}

const parsed = (m: unknown): Element => parseXml(`<math>${markup(m)}</math>`);

/**
 * What stands on the page, in a line: raised with ^, lowered with _, roots and fractions with √{}
 * and {}/{}.
 */
function reading(element: Element): string {
  const parts = elements(element).map(reading);
  const [a = '', b = '', c = ''] = parts;
  switch (element.name) {
    case 'mfrac':
      return `{${a}}/{${b}}`;
    case 'msup':
      return `${a}^${b}`;
    case 'msub':
      return `${a}_${b}`;
    case 'msubsup':
      return `${a}_${b}^${c}`;
    case 'msqrt':
      return `√{${parts.join('')}}`;
    case 'mi':
    case 'mn':
    case 'mo':
      return textOf(element);
    default:
      return parts.join('');
  }
}

const read = (m: unknown): string => reading(parsed(m));

const explain = (shape: Shape, r: Ray): Derivation =>
  derivation(shape, r, intersect(shape, r, 'textbook'));

/** Each line as the algebra shows it. */
const lines = ({ steps, numbers }: Derivation): Record<string, [symbols: string, put: string]> =>
  Object.fromEntries(
    steps.map(({ id, expr, worked }) => [
      id,
      [read(typesetSymbols(expr)), read(typesetNumbers(expr, numbers, { worked, digits: 6 }))],
    ]),
  );

const line = ({ steps }: Derivation, id: string) => {
  const step = steps.find((one) => one.id === id);
  if (!step) throw new Error(`no line ${id}`);
  return step.expr;
};

const CONE = explain(cone([0, 3, 0], 0.5), ray([3, 1, 1], [-0.8, -0.2, -0.3]));
const PLANE = explain(plane([1, 1, -0.5], [0, -1, 0]), ray([3, 1, 1], [-0.8, -0.2, -0.3]));

describe('the lines of the algebra', () => {
  test('of a cone', () => {
    expect(lines(CONE)).toEqual({
      A: ['d_x^2+d_z^2−c^2d_y^2', '(−0.8)^2+(−0.3)^2−0.5^2(−0.2)^2'],
      B: [
        '2d_x(E_x−V_x)+2d_z(E_z−V_z)−2c^2d_y(E_y−V_y)',
        '2(−0.8)(3−0)+2(−0.3)(1−0)−2·0.5^2(−0.2)(1−3)',
      ],
      C: ['(E_x−V_x)^2+(E_z−V_z)^2−c^2(E_y−V_y)^2', '(3−0)^2+(1−0)^2−0.5^2(1−3)^2'],
      D: ['B^2−4AC', '(−5.6)^2−4·0.72·9'],
      t: ['{−B±√{D}}/{2A}', '{5.6±2.33238}/{1.44}'],
    });
  });

  test('of a plane', () => {
    expect(lines(PLANE)).toEqual({
      'N.(E-P)': ['N·(E−P)', '(1,1,−0.5)·(3−0,1−(−1),1−0)'],
      'N.d': ['N·d', '(1,1,−0.5)·(−0.8,−0.2,−0.3)'],
      t: ['{−N·(E−P)}/{N·d}', '{−4.5}/{−0.85}'],
    });
  });

  test('the surface and what becomes of it', () => {
    expect(read(typesetRelation(CONE.surface))).toBe('(x−V_x)^2+(z−V_z)^2=c^2(y−V_y)^2');
    expect(read(typesetSymbols(CONE.f))).toBe('At^2+Bt+C');
    expect(read(typesetRelation(PLANE.surface))).toBe('N·(X−P)=0');
    expect(read(typesetSymbols(PLANE.f))).toBe('(N·d)t+N·(E−P)');
  });
});

describe('in pieces', () => {
  const pieces = (of: Derivation, id: string) =>
    typesetNumbersInPieces(line(of, id), of.numbers, 4);

  test('a sum is broken before each sign, a dot product before its dot', () => {
    expect(pieces(CONE, 'A').map(read)).toEqual(['(−0.8)^2', '+(−0.3)^2', '−0.5^2(−0.2)^2']);
    expect(pieces(PLANE, 'N.(E-P)').map(read)).toEqual(['(1,1,−0.5)', '·(3−0,1−(−1),1−0)']);
  });

  test('signs and dots inside of a term do not break it', () => {
    const far = explain(cylinder([0, 0, 0], 2), ray([1e9, 0.1, 1], [-1, 0.3, 1e-9]));
    expect(pieces(far, 'C').map(read)).toEqual(['(1·10^9−0)^2', '+(1−0)^2', '−2^2']);
  });

  test('anything else is one piece', () => {
    expect(pieces(CONE, 't').map(read)).toEqual(['{−(−5.6)±√{5.44}}/{2·0.72}']);
  });

  test('a sign that begins a line still stands between two operands', () => {
    const [, second] = pieces(CONE, 'A').map((m) => elements(parsed(m))[0]);
    expect(second).toMatchObject({ name: 'mo', attributes: { form: 'infix' } });
  });
});

describe('symbols, and the numbers in their places', () => {
  /** Name, class and symbol of what lights up, from the outside in. */
  const lit = (element: Element): string[] => {
    const { class: cls, 'data-symbol': symbol } = element.attributes;
    const own = cls === undefined ? [] : [`${reading(element)}: ${cls}, ${symbol}`];
    return [...own, ...elements(element).flatMap(lit)];
  };
  const both = (of: Derivation, id: string) => [
    lit(parsed(typesetSymbols(line(of, id)))),
    lit(parsed(typesetNumbers(line(of, id), of.numbers, { worked: false, digits: 6 }))),
  ];

  test('have the same colours and names', () => {
    expect(both(CONE, 'A')).toEqual([
      ['d_x^2: sym sym-d, d', 'd_z^2: sym sym-d, d', 'c: sym sym-shape, c', 'd_y^2: sym sym-d, d'],
      ['−0.8: sym sym-d, d', '−0.3: sym sym-d, d', '0.5: sym sym-shape, c', '−0.2: sym sym-d, d'],
    ]);
  });

  test('the coefficient C is not the centre C', () => {
    expect(both(CONE, 'D')).toEqual([
      ['B: sym, coefficient-B', 'A: sym, coefficient-A', 'C: sym, coefficient-C'],
      ['−5.6: sym, coefficient-B', '0.72: sym, coefficient-A', '9: sym, coefficient-C'],
    ]);
    const { surface } = explain(cylinder([0, 0, 0], 2), ray([5, 0, 0], [-1, 0, 0]));
    expect(lit(parsed(typesetRelation(surface)))).toContain('C_x: sym sym-shape, C');
  });
});

test.each([
  [3, '3'],
  [-0.25, '−0.25'],
  [-0, '0'],
  [1e21, '1·10^21'],
  [-1.5e-9, '−1.5·10^−9'],
  [1 / 3, '0.333333'],
  [Number.NEGATIVE_INFINITY, '−∞'],
  [Number.NaN, 'no value'],
])('%d is typeset as %s', (x, text) => {
  expect(read(typesetNumber(x))).toBe(text);
});

import * as fc from 'fast-check';
import { describe, expect, test } from 'vitest';
import { float64 } from '../../../src/math/arithmetic/float64.ts';
import {
  DISCRIMINANT,
  DOUBLE_ROOT,
  F_OF_T,
  LINEAR_ROOT,
  ROOTS,
} from '../../../src/math/formula/common.ts';
import { evaluate } from '../../../src/math/formula/evaluate.ts';
import {
  comp,
  dot,
  type Expr,
  minus,
  negative,
  num,
  over,
  plus,
  plusMinus,
  root,
  scalar,
  squared,
  times,
  vec,
  vecMinus,
} from '../../../src/math/formula/expr.ts';
import { type Names, printCode } from '../../../src/math/formula/print/code-notation.ts';
import { GLSL, PYTHON, TYPESCRIPT } from '../../../src/math/formula/print/languages.ts';
import { LATEX, latexText } from '../../../src/math/formula/print/latex.ts';
import { inNumbers, inSymbols, numberPiece } from '../../../src/math/formula/print/leaves.ts';
import { MATHML, mathmlDocument } from '../../../src/math/formula/print/mathml.ts';
import { readLatex } from './print-reader.ts';
import { TREE_VALUES, trees } from './print-trees.ts';
import { asLatex, parseXml } from './print-xml.ts';

const names: Names = { scalar: (id) => id, vector: (id) => id };
const typescript = (e: Expr): string => printCode(e, TYPESCRIPT, names);
const latex = (e: Expr): string => inSymbols(e, LATEX);
const [a, b, c] = [scalar('a'), scalar('b'), scalar('c')];
const cases = (list: readonly [Expr, string][]) =>
  list.map(([expr, text]) => [text, expr] as const);

describe('LaTeX, as people write it', () => {
  test.each(
    cases([
      [DISCRIMINANT, 'B^{2} - 4AC'],
      [ROOTS, '\\frac{-B \\pm \\sqrt{D}}{2A}'],
      [DOUBLE_ROOT, '\\frac{-B}{2A}'],
      [LINEAR_ROOT, '\\frac{-C}{B}'],
      [F_OF_T, 'At^{2} + Bt + C'],
      [times(num(2), comp('d', 'x'), minus(comp('E', 'x'), comp('V', 'x'))), '2d_x(E_x - V_x)'],
      [squared(comp('d', 'x')), 'd_x^2'],
      [times(dot(vec('N'), vec('d')), scalar('t')), '(N \\cdot d)t'],
      [dot(vec('N'), vecMinus(vec('E'), vec('P'))), 'N \\cdot (E - P)'],
      [negative(dot(vec('N'), vec('d'))), '-N \\cdot d'],
      [minus(a, plus(b, c)), 'a - (b + c)'],
      [minus(a, negative(b)), 'a - (-b)'],
      [plusMinus(a, negative(b)), 'a \\pm (-b)'],
      [negative(negative(a)), '-(-a)'],
      [times(a, num(2), num(3)), 'a \\cdot 2 \\cdot 3'],
      [times(num(2), over(num(1), b)), '2 \\cdot \\frac{1}{b}'],
      [squared(over(a, b)), '\\left(\\frac{a}{b}\\right)^{2}'],
      [squared(squared(a)), '(a^{2})^{2}'],
      [times(num(2), root(a), b), '2\\sqrt{a}b'],
    ]),
  )('%s', (text, expr) => {
    expect(latex(expr)).toBe(text);
  });

  test('numbers: true powers of ten, infinities, no number', () => {
    const write = (x: number) => numberPiece(x, LATEX).m;
    expect(write(-1.5e-7)).toBe('-1.5 \\cdot 10^{-7}');
    expect(write(5.5085977)).toBe('5.50860');
    expect(write(-Infinity)).toBe('-\\infty');
    expect(write(Number.NaN)).toBe('\\text{no value}');
    expect(write(-0)).toBe('0');
  });

  test('words: nothing but ASCII, specials escaped', () => {
    expect(latexText('t₁₂ = −1.2 · 10⁻⁷ & 5% \\x{}_^~#$')).toBe(
      '\\text{t$_{12}$ = $-$1.2 $\\cdot$ 10$^{-7}$ \\& 5\\% ' +
        '\\textbackslash{}x\\{\\}\\_\\textasciicircum{}\\textasciitilde{}\\#\\$}',
    );
  });
});

describe('code, in the order of the tree', () => {
  test.each(
    cases([
      [DISCRIMINANT, 'B * B - 4 * A * C'],
      [ROOTS, '(-B + Math.sqrt(D)) / (2 * A)'],
      [minus(a, minus(b, c)), 'a - (b - c)'],
      [plus(plus(a, b), c), 'a + b + c'],
      [plus(a, plus(b, c)), 'a + (b + c)'],
      [times(a, times(b, c)), 'a * (b * c)'],
      [times(a, over(b, c)), 'a * (b / c)'],
      [over(times(a, b), c), 'a * b / c'],
      [over(a, times(b, c)), 'a / (b * c)'],
      [times(squared(a), squared(b)), 'a * a * (b * b)'],
      [negative(squared(a)), '-(a * a)'],
      [negative(negative(a)), '-(-a)'],
      [negative(num(-2)), '-(-2)'],
      [minus(a, negative(b)), 'a - -b'],
      [
        dot(vec('N'), vecMinus(vec('E'), vec('P'))),
        'N[0] * (E[0] - P[0]) + N[1] * (E[1] - P[1]) + N[2] * (E[2] - P[2])',
      ],
    ]),
  )('%s', (text, expr) => {
    expect(typescript(expr)).toBe(text);
  });

  test('the other root, and a subtree that has a name', () => {
    expect(printCode(ROOTS, TYPESCRIPT, names, { branch: -1 })).toBe(
      '(-B - Math.sqrt(D)) / (2 * A)',
    );
    const product = times(a, b);
    const known = new Map([[product, 'p']]);
    expect(printCode(negative(product), TYPESCRIPT, names, { known })).toBe('-p');
  });

  test('Python and GLSL: floats stay floats, GLSL has dot products', () => {
    expect(printCode(DISCRIMINANT, PYTHON, names)).toBe('B * B - 4.0 * A * C');
    expect(printCode(num(1e21), PYTHON, names)).toBe('1e+21');
    expect(printCode(num(-0), GLSL, names)).toBe('-0.0');
    expect(() => printCode(num(Infinity), GLSL, names)).toThrow('no literal for Infinity');
    const offset = dot(vec('N'), vecMinus(vec('E'), vecMinus(vec('P'), vec('d'))));
    expect(printCode(offset, GLSL, names)).toBe('dot(N, E - (P - d))');
  });
});

/** Doubles that are equal to the last bit; all NaN are one. */
const same = (x: number, y: number, what: string): void => {
  if (!Object.is(x, y)) throw new Error(`${x} instead of ${y}: ${what}`);
};
const SEED = 20240607;

describe(`printed and read back: 2000 trees of any form (seed ${SEED})`, {
  timeout: 60_000,
}, () => {
  const forAll = (check: (e: Expr, value: number, branch: 1 | -1) => void): void =>
    fc.assert(
      fc.property(trees, fc.constantFrom<(1 | -1)[]>(1, -1), (e, branch) =>
        check(e, evaluate(e, float64, TREE_VALUES, branch), branch),
      ),
      { seed: SEED, numRuns: 2000 },
    );
  const { scalars, vectors } = TREE_VALUES;
  const symbols = { ...scalars, ...vectors };
  const run = (code: string): number =>
    new Function(...Object.keys(symbols), `return ${code};`)(...Object.values(symbols));
  const mathml = (m: string): string => asLatex(parseXml(mathmlDocument(m)));

  test('TypeScript has the value of the tree, every bit of it', () => {
    forAll((e, value, branch) => {
      const code = printCode(e, TYPESCRIPT, names, { branch });
      same(run(code), value, code);
    });
  });

  test('LaTeX in symbols', () => {
    forAll((e, value, branch) => {
      const text = latex(e);
      same(readLatex(text, TREE_VALUES, branch), value, text);
    });
  });

  test('LaTeX with the numbers put in', () => {
    forAll((e, value, branch) => {
      const text = inNumbers(e, LATEX, TREE_VALUES, { worked: false, digits: 6 });
      same(readLatex(text, TREE_VALUES, branch), value, text);
    });
  });

  test('MathML in symbols and in numbers', () => {
    forAll((e, value, branch) => {
      const inLetters = mathml(inSymbols(e, MATHML));
      same(readLatex(inLetters, TREE_VALUES, branch), value, inLetters);
      const put = mathml(inNumbers(e, MATHML, TREE_VALUES, { worked: false, digits: 6 }));
      same(readLatex(put, TREE_VALUES, branch), value, put);
    });
  });
});

import { A, B, C, D, DISCRIMINANT, F_OF_T, LINEAR_ROOT, ROOTS, T as t } from './formula/common.ts';
import { derivative, halved } from './formula/derivative.ts';
import { comp, type Expr, minus, num, over, plus, scalar, squared, times } from './formula/expr.ts';
import {
  asZero,
  expanded,
  type Product,
  substituteRay,
  summed,
  termsOf,
  withoutT,
  withT,
} from './formula/ray-substitution.ts';
import type { CurvedFormula } from './shapes/axial-quadric.ts';
import type { ShapeDefinition } from './shapes/define.ts';
import type { Shape } from './shapes/index.ts';
import { definitionOf } from './shapes/lookup.ts';
import type { FlatFormula } from './shapes/planar.ts';
import { AXES, type Axis } from './vec3.ts';

/** One term of a side of a line, and which of the products of the expanded line are in it. */
export interface WalkPart {
  readonly sign: 1 | -1;
  readonly expr: Expr;
  /** From 0, in the order of the step `expand`; none where it is made of other letters. */
  readonly products: readonly number[];
}

/** One line of a step: left = right, or left ≤ right. A side without a part is 0. */
export interface WalkLine {
  readonly left: readonly WalkPart[];
  readonly relation: '=' | '≤';
  readonly right: readonly WalkPart[];
}

/** What stands beside one power of t, and the letter that it gets. */
export interface WalkColumn {
  readonly power: number;
  readonly letter: 'A' | 'B' | 'C';
  readonly parts: readonly WalkPart[];
}

type WalkStepId =
  | 'surface'
  | 'put-in'
  | 'expand'
  | 'collect'
  | 'coefficients'
  | 'complete'
  | 'roots'
  | 'normal'
  | 't'
  | 'figure';

/** One step of the walk from a surface's equation to the roots and the normal. */
export interface WalkStep {
  readonly id: WalkStepId;
  readonly name: string;
  /** What was done to get here from the step before. */
  readonly why: string;
  readonly lines: readonly WalkLine[];
  /** The powers of t side by side, the highest first, where the terms are collected. */
  readonly columns?: readonly WalkColumn[];
}

const ZERO: Expr = { op: 'number', value: 0 };
const T2: Expr = { op: 'square', of: t };
const LETTERS = ['C', 'B', 'A'] as const;

/** f(t) = A(t + B/2A)² − D/4A, for A ≠ 0. */
export const squareCompleted = (): Expr =>
  minus(times(A, squared(plus(t, over(B, times(num(2), A))))), over(D, times(num(4), A)));

/**
 * A side of a line as one tree.
 *
 * @param parts of the line's `left` or `right`; none are 0.
 * @example
 * inSymbols(walkSide([]), LATEX); // → '0'
 */
export const walkSide = (parts: readonly WalkPart[]): Expr => summed(parts);

/** A sum's terms as parts that come from no product. */
const plain = (expr: Expr): WalkPart[] =>
  termsOf(expr, 1).map((term) => ({ ...term, products: [] }));

const is = (left: Expr, right: Expr): WalkLine => ({
  left: plain(left),
  relation: '=',
  right: plain(right),
});

const isZero = (left: readonly WalkPart[]): WalkLine => ({ left, relation: '=', right: [] });

/**
 * The derivation of a shape of the registry, made from its surface's equation.
 *
 * @param shape its present parameters decide which trees it has.
 * @param linear true for a ray with A = 0, whose root is −C/B.
 * @example
 * const cone = { kind: 'cone', vertex: [0, 0, 0], slope: 1 } as const;
 * walkOf(cone, false).slice(0, 4).map(({ name }) => name);
 * // → ['surface', 'put in', 'expand', 'collect']
 */
export const walkOf = (shape: Shape, linear: boolean): readonly WalkStep[] =>
  walkBy(definitionOf(shape), shape, linear);

/**
 * The derivation made from the shape's surface: the ray put in, expanded, collected by powers of t,
 * the coefficients, the roots, the normal; of a flat shape in dot products to t and the figure's
 * conditions.
 */
export function walkBy<S extends { readonly kind: string }>(
  { surface, formula }: Pick<ShapeDefinition<S>, 'surface' | 'formula'>,
  shape: S,
  linear: boolean,
): readonly WalkStep[] {
  const own = formula(shape);
  const zero = asZero(surface);
  const put = substituteRay(zero);
  const products = expanded(put);
  const from = (i: number): number[] => numbersOf(products, (p) => p.from === i);
  const [left, right] = [termsOf(surface.left, 1), termsOf(surface.right, 1)];
  const start: WalkStep[] = [
    {
      id: 'surface',
      name: 'surface',
      why: 'A point (x, y, z) lies on the surface where this holds.',
      lines: [
        {
          left: left.map((term, i) => ({ ...term, products: from(i) })),
          relation: '=',
          right: right.map((term, i) => ({ ...term, products: from(left.length + i) })),
        },
      ],
    },
    {
      id: 'put-in',
      name: 'put in',
      why: 'The points of the ray are R(t) = E + t d: it takes the place of the point.',
      lines: [isZero(outerTerms(put).map((term, i) => ({ ...term, products: from(i) })))],
    },
    {
      id: 'expand',
      name: 'expand',
      why: 'Every square and product is multiplied out; what holds no t stays together.',
      lines: [isZero(products.map((p, i) => ({ sign: p.sign, expr: withT(p), products: [i] })))],
    },
  ];
  return own.family === 'flat'
    ? [...start, ...flat(own)]
    : [...start, ...curved(own, columnsOf(products), zero, linear)];
}

const outerTerms = (expr: Expr) => (expr.op === 'sum' ? expr.terms : termsOf(expr, 1));

const numbersOf = (products: readonly Product[], wanted: (p: Product) => boolean): number[] =>
  products.flatMap((p, i) => (wanted(p) ? [i] : []));

function columnsOf(products: readonly Product[]): WalkColumn[] {
  return [2, 1, 0].map((power) => ({
    power,
    letter: LETTERS[power] ?? 'C',
    parts: products.flatMap((p, i) =>
      p.power === power ? [{ sign: p.sign, expr: withoutT(p), products: [i] }] : [],
    ),
  }));
}

/** t²(…) + t(…) + (…), each bracket one part. */
function byPowers(columns: readonly WalkColumn[]): WalkPart[] {
  return columns.flatMap(({ power, parts }) => {
    const own = walkSide(parts);
    const inT = power === 0 ? own : times(power === 1 ? t : T2, own);
    return parts.length > 0
      ? [{ sign: 1 as const, expr: inT, products: parts.flatMap((p) => p.products) }]
      : [];
  });
}

function curved(
  formula: CurvedFormula,
  columns: readonly WalkColumn[],
  zero: Expr,
  linear: boolean,
): WalkStep[] {
  const square = linear
    ? {
        name: 'A = 0',
        why: 'Without t² there is no square to complete: f is a straight line, or constant.',
        lines: [is(plus(times(B, t), C), ZERO)],
      }
    : {
        name: 'square',
        why: 'Completed to a square: f turns at t = −B/2A, at the height −D/4A.',
        lines: [is(F_OF_T, squareCompleted()), is(D, DISCRIMINANT)],
      };
  return [
    {
      id: 'collect',
      name: 'collect',
      why: 'Each term goes to the power of t that it carries.',
      lines: [isZero(byPowers(columns))],
      columns,
    },
    {
      id: 'coefficients',
      name: 'A, B, C',
      why: 'The three sums are the coefficients of f(t) = At² + Bt + C.',
      lines: columns.map(({ letter, parts }) => ({
        left: plain(scalar(letter)),
        relation: '=',
        right: parts.length > 0 ? parts : plain(formula[letter]),
      })),
    },
    { id: 'complete', ...square },
    {
      id: 'roots',
      name: 'roots',
      why: linear
        ? 'A straight line is zero once where B ≠ 0; where B = 0 it is zero everywhere or nowhere.'
        : 'f is 0 where the square is D/4A²: if D ≥ 0, at √D/|2A| to both sides of −B/2A.',
      lines: [is(t, linear ? LINEAR_ROOT : ROOTS)],
    },
    {
      id: 'normal',
      name: 'normal',
      why: 'N is half the gradient of F = left − right: nudge one coordinate, hold the others.',
      lines: AXES.map((axis) => is(comp('N', axis), half(zero, axis))),
    },
  ];
}

/** Half the derivative; 0 where the equation does not hold the coordinate. */
function half(zero: Expr, axis: Axis): Expr {
  const whole = derivative(zero, axis);
  return whole ? halved(whole) : ZERO;
}

function flat({ t: root, bound }: FlatFormula): WalkStep[] {
  const last: WalkStep = {
    id: 't',
    name: 't',
    why: 'One root where N·d ≠ 0; where N·d = 0 the ray is parallel to the plane.',
    lines: [is(t, root)],
  };
  if (!bound) return [last];
  const figure: WalkStep = {
    id: 'figure',
    name: 'figure',
    why: 'The point of the plane counts where every condition of the figure holds.',
    lines: bound.conditions.map(({ left, relation, right }) => ({
      left: plain(left),
      relation,
      right: plain(right),
    })),
  };
  return [last, figure];
}

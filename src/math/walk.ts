import { DISCRIMINANT, F_OF_T, LINEAR_ROOT, ROOTS } from './formula/common.ts';
import { derivative, halved } from './formula/derivative.ts';
import { comp, type Expr, minus, num, over, plus, scalar, squared, times } from './formula/expr.ts';
import {
  asZero,
  collected,
  expanded,
  type Product,
  rayPutIn,
  writtenOut,
} from './formula/ray-put-in.ts';
import type { CurvedFormula } from './shapes/axial-quadric.ts';
import type { Formula } from './shapes/define.ts';
import type { Shape } from './shapes/index.ts';
import { definitionOf } from './shapes/lookup.ts';
import type { FlatFormula } from './shapes/planar.ts';
import { AXES, type Axis } from './vec3.ts';

/** One line of a step: left = right, or left ≤ right. */
export interface WalkLine {
  readonly left: Expr;
  readonly relation: '=' | '≤';
  readonly right: Expr;
}

/** One step of the walk from a surface's equation to the roots and the normal. */
export interface WalkStep {
  readonly name: string;
  /** What was done to get here from the step before. */
  readonly why: string;
  readonly lines: readonly WalkLine[];
}

const ZERO = num(0);
const t = scalar('t');
const T2 = squared(t);
const [A, B, C, D] = ['A', 'B', 'C', 'D'].map(scalar) as [Expr, Expr, Expr, Expr];

/** f(t) = A(t + B/2A)² − D/4A, for A ≠ 0. */
export const SQUARE_COMPLETED: Expr = minus(
  times(A, squared(plus(t, over(B, times(num(2), A))))),
  over(D, times(num(4), A)),
);

/**
 * The derivation of a shape, made from its surface's equation: the ray put in, expanded, collected
 * by powers of t, the coefficients, the roots, the normal. `linear`: for A = 0.
 *
 * @param shape its present parameters decide which trees it has.
 * @param linear true for a ray with A = 0, whose root is −C/B.
 * @example
 * const cone = { kind: 'cone', vertex: [0, 0, 0], slope: 1 } as const;
 * walkOf(cone, false).slice(0, 4).map(({ name }) => name);
 * // → ['surface', 'put in', 'expand', 'collect']
 */
export function walkOf(shape: Shape, linear: boolean): readonly WalkStep[] {
  const { surface } = definitionOf(shape);
  const formula: Formula = definitionOf(shape).formula(shape);
  const zero = asZero(surface);
  const put = rayPutIn(zero);
  const products = expanded(put);
  const is = (left: Expr, right: Expr = ZERO): WalkLine => ({ left, relation: '=', right });
  return [
    {
      name: 'surface',
      why: 'A point (x, y, z) lies on the surface where this holds.',
      lines: [{ ...surface, relation: '=' }],
    },
    {
      name: 'put in',
      why: 'The points of the ray are R(t) = E + t d: x, y and z are replaced by its components.',
      lines: [is(put)],
    },
    {
      name: 'expand',
      why: 'Every square and product is multiplied out; what holds no t stays together.',
      lines: [is(writtenOut(products))],
    },
    {
      name: 'collect',
      why: 'Each term goes to the power of t that it carries.',
      lines: [is(byPowers(products))],
    },
    ...(formula.family === 'curved' ? curved(formula, zero, linear) : flat(formula)),
  ];
}

/** t²(…) + t(…) + …, without the powers that no term carries. */
function byPowers(products: readonly Product[]): Expr {
  const inT = [(own: Expr) => own, (own: Expr) => times(t, own), (own: Expr) => times(T2, own)];
  const powers = [2, 1, 0].filter((power) => products.some((p) => p.power === power));
  return plus(...powers.map((power) => (inT[power] ?? times)(collected(products, power))));
}

function curved(formula: CurvedFormula, zero: Expr, linear: boolean): WalkStep[] {
  const is = (left: Expr, right: Expr): WalkLine => ({ left, relation: '=', right });
  const square: WalkStep = linear
    ? {
        name: 'A = 0',
        why: 'Without t² there is no square to complete: f is a straight line, or constant.',
        lines: [is(plus(times(B, t), C), ZERO)],
      }
    : {
        name: 'square',
        why: 'Completed to a square: f turns at t = −B/2A, at the height −D/4A; roots need D ≥ 0.',
        lines: [is(F_OF_T, SQUARE_COMPLETED), is(D, DISCRIMINANT)],
      };
  return [
    {
      name: 'A, B, C',
      why: 'The three sums are the coefficients of f(t) = At² + Bt + C.',
      lines: [is(A, formula.A), is(B, formula.B), is(C, formula.C)],
    },
    square,
    {
      name: 'roots',
      why: linear
        ? 'A straight line is zero once where B ≠ 0; where B = 0 it is zero everywhere or nowhere.'
        : 'The square must be D/4A²: its two roots, to both sides of −B/2A.',
      lines: [is(t, linear ? LINEAR_ROOT : ROOTS)],
    },
    {
      name: 'normal',
      why: 'N is half the gradient of F = left − right: move along one axis and hold the others.',
      lines: AXES.map((axis) => is(comp('N', axis), half(zero, axis))),
    },
  ];
}

/** Half the derivative; 0 where the equation does not hold the coordinate. */
function half(zero: Expr, axis: Axis): Expr {
  const whole = derivative(zero, axis);
  return whole ? halved(whole) : ZERO;
}

function flat({ rate, offset, t: root, bound }: FlatFormula): WalkStep[] {
  return [
    {
      name: 'N·d and N·(E − P)',
      why: 'The two sums are dot products: f(t) = t N·d plus how far E is off the plane.',
      lines: [{ left: plus(times(t, rate), offset), relation: '=', right: ZERO }],
    },
    {
      name: 't',
      why: 'One root where N·d ≠ 0; where N·d = 0 the ray is parallel to the plane.',
      lines: [{ left: t, relation: '=', right: root }],
    },
    ...(bound
      ? [
          {
            name: 'figure',
            why: 'The point of the plane counts where every condition of the figure holds.',
            lines: bound.conditions,
          },
        ]
      : []),
  ];
}

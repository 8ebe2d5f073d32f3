import type { QuadraticAnswer } from './intersection.ts';
import { InvalidInput, quote, requireFinite } from './invalid-input.ts';
import { QUADRATIC_SOLVERS } from './methods/quadratic-solvers.ts';

/**
 * Real roots of A t² + B t + C = 0, ascending; a double root once. (0, 0, 0) is 'contained': every
 * t is a root.
 *
 * @param A any finite number, as B and C; 0 makes the equation linear. A t², B t and C have one
 *   unit.
 * @param solver the `id` of one of METHODS, whose own solver is used. By 'certified' and 'exact'
 *   the roots are correctly rounded for every finite triple.
 * @returns roots in the unit of B/A.
 * @throws InvalidInput on NaN, infinity and an unknown method.
 * @see NUMERICS.md, section 1: t = (−B ± √D) / 2A; section 4: what is promised of it.
 * @example
 * solveQuadratic(1, -3, 2); // → { class: 'two', roots: [1, 2] }
 * solveQuadratic(1, -2e8, 1).roots; // → [5e-9, 200000000]
 * solveQuadratic(1, -2e8, 1, 'textbook').roots; // → [0, 200000000]
 * solveQuadratic(1, 0, Number.NaN); // throws InvalidInput: C must be a finite number, got NaN
 */
export function solveQuadratic(
  A: number,
  B: number,
  C: number,
  solver = 'certified',
): QuadraticAnswer {
  const solve = Object.hasOwn(QUADRATIC_SOLVERS, solver) ? QUADRATIC_SOLVERS[solver] : undefined;
  if (!solve) throw new InvalidInput(`unknown method ${quote(solver)}`);
  requireFinite('A', A);
  requireFinite('B', B);
  requireFinite('C', C);
  return solve(A, B, C);
}

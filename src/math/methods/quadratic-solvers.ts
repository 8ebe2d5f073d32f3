import { doubleDouble } from '../arithmetic/double-double.ts';
import { exact } from '../arithmetic/exact.ts';
import { float32 } from '../arithmetic/float32.ts';
import { float64 } from '../arithmetic/float64.ts';
import { interval } from '../arithmetic/interval.ts';
import type { QuadraticAnswer } from '../intersection.ts';
import { stableSolver, textbookSolver } from './solvers.ts';
import { solveDoubles } from './tree-answer.ts';

type Solve = (A: number, B: number, C: number) => QuadraticAnswer;

const byStable: Solve = (A, B, C) =>
  solveDoubles(A, B, C, { arithmetic: float64, solver: stableSolver, decidedBy: 'formula' });
const exactly: Solve = (A, B, C) =>
  solveDoubles(A, B, C, { arithmetic: exact, solver: textbookSolver, decidedBy: 'exact' });

/**
 * How each method solves a quadratic, by the method's id. This table is apart from METHODS so that
 * `solveQuadratic` does not load the code for shapes.
 */
export const QUADRATIC_SOLVERS: Readonly<Record<string, Solve>> = {
  textbook32: (A, B, C) =>
    solveDoubles(A, B, C, { arithmetic: float32, solver: textbookSolver, decidedBy: 'formula' }),
  textbook: (A, B, C) =>
    solveDoubles(A, B, C, { arithmetic: float64, solver: textbookSolver, decidedBy: 'formula' }),
  stable: byStable,
  moment: byStable,
  compensated: (A, B, C) =>
    solveDoubles(A, B, C, {
      arithmetic: doubleDouble(),
      solver: stableSolver,
      decidedBy: 'double-double',
    }),
  interval: (A, B, C) =>
    solveDoubles(A, B, C, { arithmetic: interval(), solver: stableSolver, decidedBy: 'formula' }),
  certified: exactly,
  exact: exactly,
};

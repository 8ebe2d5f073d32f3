import type { Arithmetic } from '../arithmetic/arithmetic.ts';
import { doubleDouble } from '../arithmetic/double-double.ts';
import { exact } from '../arithmetic/exact.ts';
import { float32 } from '../arithmetic/float32.ts';
import { float64 } from '../arithmetic/float64.ts';
import { interval } from '../arithmetic/interval.ts';
import type { DecidedBy, QuadraticAnswer } from '../intersection.ts';
import { type Solver, stableSolver, textbookSolver } from './solvers.ts';
import { solveDoubles } from './tree-answer.ts';

type Solve = (A: number, B: number, C: number) => QuadraticAnswer;

const by =
  <T>(arithmetic: Arithmetic<T>, solver: Solver, decidedBy: DecidedBy = 'formula'): Solve =>
  (A, B, C) =>
    solveDoubles(A, B, C, { arithmetic, solver, decidedBy });

const byStable: Solve = /* @__PURE__ */ by(float64, stableSolver);
const exactly: Solve = /* @__PURE__ */ by(exact, textbookSolver, 'exact');

/**
 * The `solve` of every method by its id, beside METHODS: who solves a quadratic alone does not load
 * what meets shapes.
 */
export const SOLVING: Readonly<Record<string, Solve>> = {
  textbook32: /* @__PURE__ */ by(float32, textbookSolver),
  textbook: /* @__PURE__ */ by(float64, textbookSolver),
  stable: byStable,
  moment: byStable,
  compensated: /* @__PURE__ */ by(doubleDouble, stableSolver, 'double-double'),
  interval: /* @__PURE__ */ by(interval, stableSolver),
  certified: exactly,
  exact: exactly,
};

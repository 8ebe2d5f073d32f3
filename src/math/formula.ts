/** Door: formulas as trees, the arithmetics to evaluate them in, and how to write them. */

export type { Arithmetic } from './arithmetic/arithmetic.ts';
export { exact } from './arithmetic/exact.ts';
export { float64 } from './arithmetic/float64.ts';
export { asSurd, type Ratio, ratios } from './arithmetic/ratios.ts';
export type { TypedNumber } from './arithmetic/typed.ts';
export { closestApproach } from './closest.ts';
export {
  type ConditionStep,
  type Derivation,
  type DerivationStep as Step,
  derivation,
  walkLength,
} from './derivation.ts';
export {
  components,
  DISCRIMINANT,
  DOUBLE_ROOT,
  LINEAR_ROOT,
  POINT,
  ROOTS,
} from './formula/common.ts';
export {
  alongAxes,
  evaluate,
  evaluateTriple,
  lift,
  mapped,
  squaredNorm,
  type Triple,
  type Values,
  withScalars,
  withVector,
} from './formula/evaluate.ts';
export {
  comp,
  type Expr,
  type ExprTriple,
  minus,
  negative,
  norm,
  num,
  over,
  plus,
  plusMinus,
  type Relation,
  root,
  scalar,
  squared,
  type Term,
  times,
  type VectorExpr,
  vec,
  vecMinus,
} from './formula/expr.ts';
export { type CodeSyntax, type Names, printCode } from './formula/print/code-notation.ts';
export { GLSL, PYTHON, TYPESCRIPT } from './formula/print/languages.ts';
export { LATEX, latexText } from './formula/print/latex.ts';
export {
  inNumbers,
  inSymbols,
  numberPiece,
  numberTriple,
  partsPiece,
} from './formula/print/leaves.ts';
export type { Marks, Sign as PrintedSign } from './formula/print/math-notation.ts';
export { MATHML, mathmlDocument, mathmlText } from './formula/print/mathml.ts';
export { type Notation, print, type WrittenTerm } from './formula/print/printer.ts';
export {
  asPrinted,
  isWritable,
  recomputed,
  reproduces,
  type Written,
} from './formula/recompute.ts';
export { type Level, levelOf } from './level.ts';
export { courseForm, type Form } from './methods/forms.ts';
export {
  type Solver,
  STABLE_Q,
  STABLE_ROOTS,
  solveBy,
  textbookSolver,
} from './methods/solvers.ts';
export { valuesOf } from './methods/tree-method.ts';
export type { CurvedFormula } from './shapes/axial-quadric.ts';
export { all, type FlatFormula, whichHold, withPoint } from './shapes/planar.ts';
export {
  type WalkColumn,
  type WalkLine,
  type WalkPart,
  type WalkStep,
  walkOf,
  walkSide,
} from './walk.ts';

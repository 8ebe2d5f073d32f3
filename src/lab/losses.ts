import { type Expr, exact } from '../math/formula.ts';
import type { Ray, Shape } from '../math/index.ts';
import type { Method } from '../math/shapes.ts';
import { absorbedBy, type Cause, causeOf, inputsOf, overflows } from './causes.ts';
import { MOST_DIGITS } from './digits.ts';
import { plainText } from './plain-text.ts';
import { formatOf, operationsOf } from './steps.ts';
import type { Operation } from './trace.ts';

/** A line of "where did the digits go?". */
export interface StepLoss extends Operation {
  /** In plain text: what is computed. */
  readonly text: string;
  /** Right digits that the step lost, compared with the worst of its inputs; 0 if none. */
  readonly lost: number;
  /** Cause of the loss; null if it lost less than half a digit and stayed in range. */
  readonly cause: Cause | null;
}

export interface Losses {
  readonly steps: readonly StepLoss[];
  /** The step that lost most digits; null where none lost half a digit. */
  readonly worst: StepLoss | null;
}

/** Loss in digits below which no cause is given: each rounding loses a little. */
const WORTH_TELLING = 0.5;

/**
 * The steps that a person would write down, in order, each once, with the digits that each one has
 * lost.
 */
export function lossesOf(method: Method, shape: Shape, ray: Ray): Losses {
  const all = operationsOf(method, shape, ray);
  const format = formatOf(method);
  const absorbed = new Set(all.flatMap(absorbedBy));
  const seen = new Set<string>();
  const steps: StepLoss[] = [];
  for (const operation of all) {
    if (absorbed.has(operation) || isTrivial(operation)) continue;
    const text = plainText(operation.expr);
    const key = operation.letter === null ? text : `${plainText(operation.letter)} = ${text}`;
    // Both roots have the letter t, and each has a line.
    if (seen.has(key)) continue;
    seen.add(key);
    const lost = lostBy(operation);
    // An exact number cannot overflow, although the double that shows it may.
    const leaves = format !== exact.id && overflows(operation);
    const cause = lost > WORTH_TELLING || leaves ? causeOf(operation, format) : null;
    steps.push({ ...operation, text, lost, cause });
  }
  const worst = steps.reduce<StepLoss | null>(
    (most, step) => (step.lost > (most?.lost ?? WORTH_TELLING) ? step : most),
    null,
  );
  return { steps, worst };
}

/** Steps that get no line: a change of sign, a product with a number (2A), an unrounded input. */
function isTrivial({ expr, letter, inputs, digits }: Operation): boolean {
  if (inputs.length === 0) return digits === null || digits >= MOST_DIGITS;
  if (letter !== null) return false;
  // The choice of the smaller root.
  if (inputs.every((input) => input.letter?.op === 'scalar' && input.letter.id === 't'))
    return true;
  if (expr.op === 'negative') return true;
  return expr.op === 'product' && expr.factors.length === 2 && expr.factors.some(isNumber);
}

const isNumber = ({ op }: Expr): boolean => op === 'number';

function lostBy(operation: Operation): number {
  if (operation.digits === null) return 0;
  const before = Math.min(MOST_DIGITS, ...inputsOf(operation).map(({ digits }) => digits ?? 0));
  return Math.max(0, before - operation.digits);
}

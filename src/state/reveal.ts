import type { Derivation } from '../math/formula.ts';

interface Derived {
  readonly derivation: Derivation;
}

/** Number of lines to reveal one by one: each step, the conditions, the verdict, the hits. */
export function lineCount({ derivation }: Derived): number {
  return derivation.steps.length + (derivation.conditions.length > 0 ? 1 : 0) + 2;
}

/** Which parts of the result are shown when `revealed` lines are; null shows all. */
export function shownLines(
  model: Derived,
  revealed: number | null,
): { steps: number; conditions: boolean; verdict: boolean; hits: boolean } {
  const lines = lineCount(model);
  const shown = revealed ?? lines;
  const { steps, conditions } = model.derivation;
  const afterSteps = steps.length + (conditions.length > 0 ? 1 : 0);
  return {
    steps: Math.min(shown, steps.length),
    conditions: shown > steps.length && conditions.length > 0,
    verdict: shown > afterSteps,
    hits: shown > afterSteps + 1,
  };
}

/**
 * The derivation with the general line of t while that line is hidden: the line of this ray, or its
 * absence, would show the class.
 */
export function knownLines(derivation: Derivation, shown: number): Derivation {
  const before = derivation.steps.filter(({ id }) => id !== derivation.unknown.id);
  if (shown >= before.length) return derivation;
  return { ...derivation, steps: [...before, derivation.unknown] };
}

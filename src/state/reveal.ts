import type { Derivation } from '../math/formula.ts';

interface Derived {
  readonly derivation: Derivation;
}

/**
 * The lines that can be revealed one after another: each step, the conditions, the verdict, the
 * hits.
 */
export function lineCount({ derivation }: Derived): number {
  return derivation.steps.length + (derivation.conditions.length > 0 ? 1 : 0) + 2;
}

/** What is shown of the result when `revealed` lines of it are; null shows all. */
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
    conditions: shown > steps.length || conditions.length === 0,
    verdict: shown > afterSteps,
    hits: shown > afterSteps + 1,
  };
}

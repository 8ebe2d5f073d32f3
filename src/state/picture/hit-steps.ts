import { derivation, type Step } from '../../math/derivation.ts';
import type { Values } from '../../math/formula/evaluate.ts';
import type { Expr } from '../../math/formula/expr.ts';
import { intersect } from '../../math/intersect.ts';
import { InvalidInput } from '../../math/invalid-input.ts';
import type { Ray } from '../../math/ray.ts';
import type { Shape } from '../../math/shapes/index.ts';
import { definitionOf } from '../../math/shapes/lookup.ts';
import { hitSentence, hitWords, verdictWords } from '../words.ts';

export interface SurfaceStep {
  readonly step: Step;
  readonly numbers: Values<number>;
}

export interface SurfaceSteps {
  readonly title: string;
  readonly f: Expr;
  readonly lines: readonly SurfaceStep[];
  readonly verdict: string;
}

/** The course's algebra of one ray and the whole shape; null for a ray that the math module refuses (an overflowed direction). */
export function surfaceSteps(shape: Shape, ray: Ray, method: string): SurfaceSteps | null {
  try {
    const found = intersect(shape, ray, method);
    const { f, steps, numbers } = derivation(shape, ray, found);
    const roots = hitWords(found).map(hitSentence);
    return {
      title: definitionOf(shape).named(shape).name,
      f,
      lines: steps.filter(({ value }) => value !== null).map((step) => ({ step, numbers })),
      verdict: [verdictWords(found, shape, ray).text, ...roots].join('; '),
    };
  } catch (error) {
    if (error instanceof InvalidInput) return null;
    throw error;
  }
}

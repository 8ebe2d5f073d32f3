import { derivation, type Expr, type Step, type Values } from '../../math/formula.ts';
import { InvalidInput, intersect, type Shape } from '../../math/index.ts';
import { definitionOf } from '../../math/shapes.ts';
import { type PutIn, putInSideBySide, valuesAsResults } from '../put-in.ts';
import { verdictWords } from '../verdict-words.ts';
import { type RootFate, type RootFilter, rootFates } from './root-fates.ts';

export interface SurfaceStep {
  readonly step: Step;
  readonly numbers: Values<number>;
  /** Null if one of the numbers is not finite. */
  readonly put: PutIn | null;
}

interface SurfaceSteps {
  readonly title: string;
  readonly f: Expr;
  readonly lines: readonly SurfaceStep[];
  readonly verdict: string;
  readonly roots: readonly RootFate[];
}

/**
 * The course's algebra of one ray and the whole shape, with the fate of each root. Null for a ray
 * that the math module refuses, as one whose direction overflowed.
 */
export function surfaceSteps(
  shape: Shape,
  meeting: RootFilter,
  method: string,
): SurfaceSteps | null {
  const { ray, between } = meeting;
  try {
    const found = intersect(shape, ray, method);
    const { f, steps, numbers } = derivation(shape, ray, found);
    const { name } = definitionOf(shape).named(shape);
    const verdict = verdictWords(found, shape, ray).text;
    return {
      title: name,
      f,
      lines: steps.flatMap((step) => {
        const { expr, worked, value } = step;
        if (value === null) return [];
        const results = valuesAsResults([value], undefined);
        return [{ step, numbers, put: putInSideBySide([{ expr, results }], numbers, worked) }];
      }),
      verdict: between ? `the whole ${name}: ${verdict}` : verdict,
      roots: rootFates(found, meeting),
    };
  } catch (error) {
    if (error instanceof InvalidInput) return null;
    throw error;
  }
}

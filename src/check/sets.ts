import type { ShapeKind } from '../math/shapes.ts';

/** An exercise of a set: how often it comes up, and for which shapes in turn. */
interface Turn {
  readonly exercise: string;
  readonly times: number;
  readonly kinds: readonly ShapeKind[];
}

/** What a seed draws from. */
interface QuestionSet {
  /** Shapes that "all shapes" means for own programs. */
  readonly shapes: readonly ShapeKind[];
  readonly turns: readonly Turn[];
}

const FLAT = ['plane', 'circle', 'square'] as const;
const ROUND = ['cylinder', 'cone', 'hyperboloid'] as const;
const CURVED = [...ROUND, 'sphere', 'paraboloid'] as const;

/**
 * A set is frozen once a release has posed it: the same set and seed pose the same questions for
 * ever. What is new goes into a set of its own, with the next number; a link names its set.
 */
export const SETS: Readonly<Record<string, QuestionSet>> = {
  1: {
    shapes: ['plane', 'cylinder', 'cone', 'hyperboloid', 'circle', 'square'],
    turns: [
      { exercise: 'flat', times: 3, kinds: FLAT },
      { exercise: 'coefficients', times: 1, kinds: ROUND },
      { exercise: 'discriminant', times: 1, kinds: ROUND },
      { exercise: 'roots', times: 1, kinds: ROUND },
      { exercise: 'first', times: 1, kinds: ROUND },
      { exercise: 'point', times: 1, kinds: ROUND },
      { exercise: 'parallel', times: 1, kinds: FLAT },
      { exercise: 'nappes', times: 1, kinds: ['cone'] },
      { exercise: 'normal', times: 1, kinds: ROUND },
      { exercise: 'shadow', times: 1, kinds: ROUND },
      { exercise: 'linear', times: 1, kinds: ROUND },
      { exercise: 'crossing', times: 1, kinds: ROUND },
      { exercise: 'tangent', times: 1, kinds: ROUND },
      { exercise: 'digits', times: 1, kinds: ROUND },
    ],
  },
  2: {
    shapes: [
      ...(['plane', 'cylinder', 'cone', 'hyperboloid', 'circle', 'square'] as const),
      ...(['sphere', 'paraboloid'] as const),
    ],
    turns: [
      { exercise: 'flat', times: 3, kinds: FLAT },
      { exercise: 'coefficients', times: 2, kinds: CURVED },
      { exercise: 'discriminant', times: 1, kinds: CURVED },
      { exercise: 'roots', times: 1, kinds: CURVED },
      { exercise: 'first', times: 1, kinds: CURVED },
      { exercise: 'point', times: 1, kinds: CURVED },
      { exercise: 'parallel', times: 1, kinds: FLAT },
      { exercise: 'nappes', times: 1, kinds: ['cone'] },
      { exercise: 'normal', times: 1, kinds: CURVED },
      { exercise: 'shadow', times: 1, kinds: CURVED },
      { exercise: 'linear', times: 1, kinds: [...ROUND, 'paraboloid'] },
      { exercise: 'crossing', times: 1, kinds: CURVED },
      { exercise: 'tangent', times: 1, kinds: CURVED },
      { exercise: 'digits', times: 1, kinds: ROUND },
    ],
  },
};

/** What a link without a set means. */
export const FIRST_SET = '1';
export const LATEST_SET = '2';

export function setOf(id: string): QuestionSet {
  const found = Object.hasOwn(SETS, id) ? SETS[id] : undefined;
  if (!found) throw new RangeError(`no question set ${id}`);
  return found;
}

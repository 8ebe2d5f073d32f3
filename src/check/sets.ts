import { SHAPES } from '../math/index.ts';
import type { ShapeKind } from '../math/shapes.ts';
import { EXERCISES, findExercise } from './exercises/index.ts';

/** An exercise of a set: how often it comes up, and for which shapes in turn. */
interface Turn {
  readonly exercise: string;
  readonly times: number;
  readonly kinds: readonly ShapeKind[];
}

/** The exercises and shapes from which a seed makes a session. */
interface QuestionSet {
  /** Shapes that "all shapes" means for own programs. */
  readonly shapes: readonly ShapeKind[];
  readonly turns: readonly Turn[];
}

const FLAT = ['plane', 'circle', 'square'] as const;
const ROUND = ['cylinder', 'cone', 'hyperboloid'] as const;
const CURVED = [...ROUND, 'sphere', 'paraboloid'] as const;

/**
 * A set is frozen once a release has it: set and seed pose the same questions for ever, and a link
 * names its set. New shapes and exercises go into a new set, with the next number. Until then new
 * sessions use the newest set with their names added to its id (`setOf`).
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

/** The set of a link that names none. */
export const FIRST_SET = '1';

const KINDS: readonly ShapeKind[] = SHAPES.map(({ kind }) => kind);
const isKind = (name: string): name is ShapeKind => KINDS.some((kind) => kind === name);

/**
 * The set of this id, and what its id adds: `2,torus,gap` is set 2 with the shape torus in every
 * exercise that can be posed about it, and the exercise gap at the end.
 *
 * @throws RangeError for an unknown set or name, and for a name that the set has already.
 */
export function setOf(id: string): QuestionSet {
  const [number = '', ...added] = id.split(',');
  const found = Object.hasOwn(SETS, number) ? SETS[number] : undefined;
  if (!found) throw new RangeError(`no question set ${number}`);
  const has = (name: string): boolean =>
    found.shapes.some((kind) => kind === name) ||
    found.turns.some(({ exercise }) => exercise === name);
  const wrong = added.find(
    (name, i) => has(name) || added.indexOf(name) < i || !(isKind(name) || findExercise(name)),
  );
  if (wrong !== undefined) throw new RangeError(`set ${number} cannot have ${wrong} added`);
  const newKinds = added.filter(isKind);
  const shapes = [...found.shapes, ...newKinds];
  const kindsOf = (exercise: string): readonly ShapeKind[] => findExercise(exercise)?.kinds ?? [];
  return {
    shapes,
    turns: [
      ...found.turns.map(({ kinds, ...turn }) => ({
        ...turn,
        kinds: [...kinds, ...newKinds.filter((kind) => kindsOf(turn.exercise).includes(kind))],
      })),
      ...added
        .filter((name) => !isKind(name))
        .map((exercise) => ({
          exercise,
          times: 1,
          kinds: shapes.filter((kind) => kindsOf(exercise).includes(kind)),
        })),
    ],
  };
}

export const isSet = (id: string): boolean => {
  try {
    return setOf(id).turns.every(({ kinds }) => kinds.length > 0);
  } catch {
    return false;
  }
};

/** The set id of new sessions: the newest set, with the shapes and exercises that it lacks. */
export const LATEST_SET = [
  '2',
  ...KINDS.filter((kind) => !SETS[2]?.shapes.includes(kind)),
  ...EXERCISES.map(({ id }) => id).filter(
    (id) => !SETS[2]?.turns.some(({ exercise }) => exercise === id),
  ),
].join(',');

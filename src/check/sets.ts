import { SHAPES } from '../math/index.ts';
import { quote, type ShapeKind } from '../math/shapes.ts';
import type { Level } from './exercises/define.ts';
import { EXERCISES, findExercise } from './exercises/index.ts';

/** An exercise of a set: how often it comes up, and for which shapes in turn. */
interface SetEntry {
  readonly exercise: string;
  readonly times: number;
  readonly kinds: readonly ShapeKind[];
}

/** The exercises and shapes from which a seed makes a session. */
export interface QuestionSet {
  /** Shapes that "all shapes" means for own programs. */
  readonly shapes: readonly ShapeKind[];
  readonly turns: readonly SetEntry[];
  /** Whether topics are shuffled, and right answers spread over their classes. */
  readonly spread?: true;
  /** The level of all questions; absent: they rise from 1 to 3. */
  readonly level?: Level;
  /** Whether hints and solutions are not offered. */
  readonly withoutHints?: true;
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
  3: {
    shapes: [
      ...(['plane', 'cylinder', 'cone', 'hyperboloid', 'circle', 'square'] as const),
      ...(['sphere', 'paraboloid'] as const),
    ],
    spread: true,
    turns: [
      { exercise: 'flat', times: 2, kinds: FLAT },
      { exercise: 'pixel', times: 1, kinds: [...FLAT, ...CURVED] },
      { exercise: 'coefficients', times: 2, kinds: CURVED },
      { exercise: 'side', times: 1, kinds: CURVED },
      { exercise: 'discriminant', times: 2, kinds: CURVED },
      { exercise: 'graph', times: 1, kinds: CURVED },
      { exercise: 'roots', times: 1, kinds: CURVED },
      { exercise: 'first', times: 1, kinds: CURVED },
      { exercise: 'cut', times: 1, kinds: CURVED },
      { exercise: 'order', times: 1, kinds: CURVED },
      { exercise: 'point', times: 1, kinds: CURVED },
      { exercise: 'parallel.2', times: 1, kinds: FLAT },
      { exercise: 'nappes.2', times: 1, kinds: ['cone'] },
      { exercise: 'normal', times: 1, kinds: CURVED },
      { exercise: 'shadow', times: 1, kinds: CURVED },
      { exercise: 'effect', times: 1, kinds: [...ROUND, ...FLAT] },
      { exercise: 'linear', times: 1, kinds: [...ROUND, 'paraboloid'] },
      { exercise: 'crossing.2', times: 1, kinds: CURVED },
      { exercise: 'tangent', times: 1, kinds: CURVED },
      { exercise: 'digits.2', times: 1, kinds: CURVED },
      { exercise: 'method', times: 1, kinds: CURVED },
    ],
  },
};

/** The set of a link that names none. */
export const FIRST_SET = '1';
const LAST_SET = '3';

const KINDS: readonly ShapeKind[] = SHAPES.map(({ kind }) => kind);
const isKind = (name: string): name is ShapeKind => KINDS.some((kind) => kind === name);

/** Most questions of a set that is made of exercises. */
export const MOST_QUESTIONS = 60;

/*
 * The id of a set, all of it in one text:
 *
 *   2                                            a numbered set
 *   2,torus,gap                                  and what it adds
 *   roots*3,nappes.2                             exercises, and how often each comes
 *   roots*3;shapes=cone,sphere;level=2;hints=off and what is chosen beside
 *
 * A link has what is chosen beside under keys of its own. An exercise of an id without a number is
 * its first version for ever: 'nappes' and 'nappes.2' are two, so a set is frozen by its text.
 */
export const CHOSEN = ['shapes', 'level', 'hints'] as const;
type ChosenKey = (typeof CHOSEN)[number];
export type Chosen = Readonly<Partial<Record<ChosenKey, string>>>;

/** Whether the id is that of a numbered set, and not of exercises that somebody chose. */
export const isNumbered = (id: string): boolean => /^\d/.test(id);

/** The id of a set from its parts. */
export const setId = (base: string, chosen: Chosen = {}): string =>
  [base, ...CHOSEN.flatMap((key) => (chosen[key] ? [`${key}=${chosen[key]}`] : []))].join(';');

/** The parts of a set's id. */
export function partsOf(id: string): { readonly base: string; readonly chosen: Chosen } {
  const [base = '', ...rest] = id.split(';');
  const pairs = rest.map((part) => {
    const at = part.indexOf('=');
    return [part.slice(0, at), part.slice(at + 1)] as const;
  });
  return { base, chosen: Object.fromEntries(pairs) };
}

/**
 * The set of this id.
 *
 * @throws RangeError with what is wrong with it, for people.
 */
export function setOf(id: string): QuestionSet {
  const { base, chosen } = partsOf(id);
  for (const key of Object.keys(chosen)) {
    if (!CHOSEN.some((one) => one === key)) throw new RangeError(`a set has no ${quote(key)}`);
  }
  const isFrozen = isNumbered(base);
  const set = isFrozen ? numbered(base) : ofExercises(base, chosen.shapes);
  if (isFrozen && (chosen.shapes !== undefined || chosen.level !== undefined)) {
    throw new RangeError(`set ${base} has its own shapes and levels`);
  }
  return { ...set, ...levelOf(chosen.level), ...hintsOf(chosen.hints) };
}

function levelOf(text: string | undefined): { readonly level?: Level } {
  if (text === undefined) return {};
  if (!/^[123]$/.test(text)) throw new RangeError(`the level is 1, 2 or 3, not ${quote(text)}`);
  return { level: Number(text) as Level };
}

function hintsOf(text: string | undefined): { readonly withoutHints?: true } {
  if (text === undefined) return {};
  if (text !== 'off') throw new RangeError(`hints can be off, not ${quote(text)}`);
  return { withoutHints: true };
}

/** `2,torus,gap`: set 2, the shape torus in every exercise that can be posed about it, and gap. */
function numbered(base: string): QuestionSet {
  const [number = '', ...added] = base.split(',');
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
  return {
    ...found,
    shapes,
    turns: [
      ...found.turns.map(({ kinds, ...turn }) => ({
        ...turn,
        kinds: [...kinds, ...newKinds.filter((kind) => kindsOf(turn.exercise).includes(kind))],
      })),
      ...added.filter((name) => !isKind(name)).map((exercise) => turnOf(exercise, 1, shapes)),
    ],
  };
}

const kindsOf = (exercise: string): readonly ShapeKind[] => findExercise(exercise)?.kinds ?? [];

/** @throws RangeError if the exercise cannot be posed about any of these shapes. */
function turnOf(exercise: string, times: number, shapes: readonly ShapeKind[]): SetEntry {
  const kinds = shapes.filter((kind) => kindsOf(exercise).includes(kind));
  if (kinds.length === 0) {
    throw new RangeError(`${exercise} cannot be asked about ${shapes.join(' or ')}`);
  }
  return { exercise, times, kinds };
}

/** Shapes of a link that names none: those that there were when such sets began. */
const FIRST_SHAPES: readonly ShapeKind[] = [...FLAT, ...CURVED];

function ofExercises(base: string, named: string | undefined): QuestionSet {
  const shapes = named === undefined ? FIRST_SHAPES : namedShapes(named);
  const turns = base.split(',').map((item) => {
    const [, id = '', times = '1'] = /^([^*]*)(?:\*(.*))?$/.exec(item) ?? [];
    if (!findExercise(id)) throw new RangeError(`there is no exercise ${quote(id)}`);
    const count = Number(times);
    if (!/^\d{1,2}$/.test(times) || count < 1) {
      throw new RangeError(`${quote(item)} does not say how often, as roots*3 does`);
    }
    return turnOf(id, count, shapes);
  });
  const twice = turns.find(
    ({ exercise }, i) => turns.findIndex((t) => t.exercise === exercise) < i,
  );
  if (twice) throw new RangeError(`${twice.exercise} comes twice: write how often behind *`);
  const count = turns.reduce((sum, { times }) => sum + times, 0);
  if (count > MOST_QUESTIONS) {
    throw new RangeError(`a set has up to ${MOST_QUESTIONS} questions, not ${count}`);
  }
  return { shapes, turns, spread: true };
}

function namedShapes(text: string): readonly ShapeKind[] {
  const names = text.split(',');
  const wrong = names.find((name, i) => !isKind(name) || names.indexOf(name) < i);
  if (wrong !== undefined) throw new RangeError(`${quote(wrong)} is no shape, or named twice`);
  return names.filter(isKind);
}

/** Why this is the id of no set; '' if it is one. */
export function setProblem(id: string): string {
  try {
    setOf(id);
    return '';
  } catch (error) {
    if (error instanceof RangeError) return error.message;
    throw error;
  }
}

export const isSet = (id: string): boolean => setProblem(id) === '';

/** The set id of new sessions: the newest set, with the shapes and exercises that it lacks. */
export const LATEST_SET = [
  LAST_SET,
  ...KINDS.filter((kind) => !SETS[LAST_SET]?.shapes.includes(kind)),
  ...EXERCISES.map(({ id }) => id).filter(
    (id) => !SETS[LAST_SET]?.turns.some(({ exercise }) => exercise === id),
  ),
].join(',');

/** What a set is called in sentences and tables: "set 2", "roots*3". */
export const setName = (id: string): string => {
  const { base } = partsOf(id);
  return isNumbered(base) ? `set ${base}` : base;
};

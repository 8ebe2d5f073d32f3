import { integer, type Random, seeded } from '../math/rng.ts';
import type { ShapeKind } from '../math/shapes.ts';
import { type Posed, pose } from './compose.ts';
import type { Level } from './exercises/define.ts';
import { shuffled } from './exercises/draw.ts';
import { findExercise } from './exercises/index.ts';
import { FIRST_SET, type QuestionSet, setOf } from './sets.ts';

interface PlannedQuestion {
  readonly exercise: string;
  readonly kind: ShapeKind;
  readonly level: Level;
  /** Classes of the exercise's spread, the wanted one first. */
  readonly wanted: readonly string[];
}

const levelAt = (i: number, count: number): Level =>
  i * 3 < count ? 1 : i * 3 < 2 * count ? 2 : 3;

/** The questions of a session, easy ones first. The seed decides the shape of each. */
export function plan(seed: number, set: string = FIRST_SET): readonly PlannedQuestion[] {
  const found = setOf(set);
  const slots = found.spread ? spreadSlots(seed, found) : slotsInTurn(seed, found);
  return slots.map((slot, i) => ({ ...slot, level: found.level ?? levelAt(i, slots.length) }));
}

type Unlevelled = Omit<PlannedQuestion, 'level'>;

function slotsInTurn(seed: number, { turns }: QuestionSet): Unlevelled[] {
  const random = seeded(seed);
  let turn = integer(random, 0, 2);
  return turns.flatMap(({ exercise, times, kinds }) =>
    Array.from({ length: times }, () => {
      turn++;
      return { exercise, kind: kinds[turn % kinds.length] as ShapeKind, wanted: [] };
    }),
  );
}

/** Tells the numbers of a plan from those of its questions. */
const PLANNED = 0x5bd1e995;

/**
 * Shapes and classes of answers are dealt out for each exercise, all before any comes again; then
 * the questions are shuffled.
 */
function spreadSlots(seed: number, { turns }: QuestionSet): Unlevelled[] {
  const random = seeded(Math.imul(seed, 0x9e3779b1) ^ PLANNED);
  const slots = turns.flatMap(({ exercise, times, kinds }) => {
    const shapes = dealer(random, kinds);
    const { classes = [], without = {} } = findExercise(exercise)?.spread ?? {};
    const dealt = dealer(random, classes);
    return Array.from({ length: times }, (): Unlevelled => {
      const [kind] = shapes() as [ShapeKind, ...ShapeKind[]];
      const wanted = dealt().filter((one) => !without[kind]?.includes(one));
      return { exercise, kind, wanted };
    });
  });
  return shuffled(random, slots);
}

/** Gives the cards in turn, each before the others that were not due; shuffled for each round. */
function dealer<T>(random: Random, cards: readonly T[]): () => readonly T[] {
  let left: readonly T[] = [];
  return () => {
    if (left.length === 0) left = shuffled(random, cards);
    const [next, ...others] = left;
    left = others;
    const rest = cards.filter((card) => card !== next);
    return next === undefined ? [] : [next, ...shuffled(random, rest)];
  };
}

/** Question `index` (from 0) of the session. */
export function question(seed: number, index: number, set: string = FIRST_SET): Posed {
  const slot = plan(seed, set)[index];
  const exercise = findExercise(slot?.exercise ?? '');
  if (!slot || !exercise) throw new RangeError(`no question ${index + 1}`);
  // An odd factor spreads the seeds of neighbouring sessions and questions over 32 bits.
  const own = Math.imul(seed * 64 + index + 1, 0x9e3779b1);
  return pose(exercise, slot.kind, own, slot.level, slot.wanted);
}

/** Largest seed that is made from a name; seeds have up to nine digits. */
const SEEDS = 1_000_000_000;

/**
 * The seed of a student's own numbers, from a name or number and the seed of all. Case, accents as
 * they are composed, and blanks do not matter.
 *
 * @example
 * studentSeed(41, ' Ada  LOVELACE') === studentSeed(41, 'ada lovelace'); // → true
 */
export function studentSeed(seed: number, name: string): number {
  const plain = plainName(name);
  if (plain === '') return seed;
  let h = Math.imul(seed ^ 0x811c9dc5, 0x01000193);
  for (const c of plain) h = Math.imul(h ^ (c.codePointAt(0) ?? 0), 0x01000193);
  h = Math.imul(h ^ (h >>> 16), 0x85ebca6b);
  h = Math.imul(h ^ (h >>> 13), 0xc2b2ae35);
  return ((h ^ (h >>> 16)) >>> 0) % SEEDS;
}

const plainName = (name: string): string =>
  name.normalize('NFKC').trim().replace(/\s+/g, ' ').toLowerCase();

import { integer, seeded } from '../math/rng.ts';
import type { ShapeKind } from '../math/shapes.ts';
import { type Posed, pose } from './compose.ts';
import type { Level } from './exercises/define.ts';
import { EXERCISES } from './exercises/index.ts';
import { FIRST_SET, setOf } from './sets.ts';

interface Slot {
  readonly exercise: string;
  readonly kind: ShapeKind;
  readonly level: Level;
}

const levelAt = (i: number, count: number): Level =>
  i * 3 < count ? 1 : i * 3 < 2 * count ? 2 : 3;

/** The questions of a session, easy ones first. The seed decides the shape of each. */
export function plan(seed: number, set: string = FIRST_SET): readonly Slot[] {
  const random = seeded(seed);
  let turn = integer(random, 0, 2);
  const slots = setOf(set).turns.flatMap(({ exercise, times, kinds }) =>
    Array.from({ length: times }, () => {
      turn++;
      return { exercise, kind: kinds[turn % kinds.length] as ShapeKind };
    }),
  );
  return slots.map((slot, i) => ({ ...slot, level: levelAt(i, slots.length) }));
}

/** Question `index` (from 0) of the session. */
export function question(seed: number, index: number, set: string = FIRST_SET): Posed {
  const slot = plan(seed, set)[index];
  const exercise = EXERCISES.find(({ id }) => id === slot?.exercise);
  if (!slot || !exercise) throw new RangeError(`no question ${index + 1}`);
  // An odd factor spreads the seeds of neighbouring sessions and questions over 32 bits.
  return pose(exercise, slot.kind, Math.imul(seed * 64 + index + 1, 0x9e3779b1), slot.level);
}

import type { MeasureRequest } from '../../lab/session.ts';
import type { SweepRequest } from '../../lab/sweep.ts';
import type { AccuracySettings } from '../../state/accuracy/settings.ts';

/**
 * Enough rays for the share of 9 in 10 to mean something, and few enough for the exact method to
 * pass them in 10 ms.
 */
const SHAPES = 6;
const COUNT = 512;
/** No processor knows so many branches by heart. */
const TIMED = 61_440;

/** What the page does by itself: some seconds. */
const BRIEF = {
  budget: { least: COUNT, most: 20 },
  plan: { rounds: 4, least: 4, steps: 20, warmUp: 1 },
};
/**
 * On demand: until the best quarter of the rounds is within 2 % of the best, after which further
 * ones would hardly change a figure that is shown.
 */
const LONGER = {
  budget: { least: COUNT, most: 60 },
  plan: { rounds: 15, least: 10, steps: 100, warmUp: 2, settles: { rounds: 7, spread: 0.02 } },
};

export const measureRequest = (
  { family, dial, seed, order }: AccuracySettings,
  longer: boolean,
): MeasureRequest => ({
  family,
  seed,
  order,
  shapes: SHAPES,
  count: COUNT,
  timed: TIMED,
  difficulty: dial ?? undefined,
  ...(longer ? LONGER : BRIEF),
});

const SWEEP_COUNT = 128;
/** Every whole power of ten, for the usual dial from 0 to 12. */
const SWEEP_POINTS = 13;

export const sweepRequest = ({ hard, seed }: AccuracySettings): SweepRequest => ({
  family: hard,
  seed,
  shapes: SHAPES,
  count: SWEEP_COUNT,
  points: SWEEP_POINTS,
});

type Rays = Pick<MeasureRequest, 'family' | 'seed' | 'difficulty' | 'order'>;

/** Whether what was measured is what is asked for now. */
export const sameRays = (a: Rays | null, b: Rays): boolean =>
  a !== null &&
  a.family === b.family &&
  a.seed === b.seed &&
  a.difficulty === b.difficulty &&
  a.order === b.order;

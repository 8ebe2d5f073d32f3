import type { MeasureRequest } from '../../lab/session.ts';
import type { SweepRequest } from '../../lab/sweep.ts';
import type { AccuracySettings } from '../../state/accuracy/settings.ts';

/**
 * Enough rays for the share of 9 in 10 to mean something, and few enough for the exact method to
 * pass them in 10 ms.
 */
const SHAPES = 6;
const COUNT = 512;
/** Rays of each shape that are timed: more than a branch predictor can learn. */
const TIMED = 61_440;

/** Plan of the measurement that the page starts by itself; takes some seconds. */
const BRIEF = {
  budget: { least: COUNT, most: 20 },
  plan: { rounds: 4, least: 4, steps: 20, warmUp: 1 },
};
/**
 * Plan of a measurement on demand: until the lower quartile of the rounds is within 2 % of the best
 * one. Further rounds would hardly change a shown figure.
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
/** Points of a sweep: every power of ten of a dial from 0 to 12. */
const SWEEP_POINTS = 13;

export const sweepRequest = ({ hard, seed }: AccuracySettings): SweepRequest => ({
  family: hard,
  seed,
  shapes: SHAPES,
  count: SWEEP_COUNT,
  points: SWEEP_POINTS,
});

type Rays = Pick<MeasureRequest, 'family' | 'seed' | 'difficulty' | 'order'>;

/** Whether two requests are about the same rays. */
export const sameRays = (a: Rays | null, b: Rays): boolean =>
  a !== null &&
  a.family === b.family &&
  a.seed === b.seed &&
  a.difficulty === b.difficulty &&
  a.order === b.order;

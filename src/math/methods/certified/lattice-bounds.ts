import type { Answers, Rays } from '../../batch/batch.ts';
import { LARGEST_LENGTH, type Lattice } from './lattice.ts';

/*
 * Pass 1: is it hit, and roughly where. u = 2^-53. D = b² − AC, in halves, is off by 27u·Q at most, Q = Am·Cm (class-quadric.ts, with
 * Am = x² + y² + z² and Cm = |p|² + ρ, which are no smaller than there since |a| ≤ 1). In units nothing overflows, and what underflows is
 * far below SMALLEST.
 *
 * D > CLEAR·Q: √D is known to 27u·2^13 < 2^-35 of itself. Then |b|/√D < 2^7, so that the rounding of the rough roots, a few u(|b| + √D)/|A|, is
 * below 2^-42 of their distance, and this is known to 2^-34.
 * |A| > LEAST·Am: |δA| ≤ 3u·Am + u|A| (squares u, their sum u; a·y² 3u; the difference), so A is known to 200u, and not 0.
 */
const CLEAR = 2 ** -20;
const CERTAIN = 28 * 2 ** -53;
const SMALLEST = 2 ** -100;
const LEAST = 2 ** -6;
const LARGEST_SQUARE = LARGEST_LENGTH ** 2;
/** Some component of d has then at least 2^3 units, so that t·d shows it when t is too large to be cut. */
const SMALLEST_SQUARE = 2 ** 8;

/** The relative error of a step in lattice-solve.ts is (4 Am/|A| + 14)u at most, and more by what g is off; pass 1 has Am/|A| at hand. */
export const SLACK_A = 4 * 2 ** -53;
export const SLACK = 14 * 2 ** -53;

/** What pass 1 leaves goes to recentred.ts if its roots are this much (squared) nearer to each other than to E, or nothing is known of them; else to refined.ts at once. A matter of speed only. */
const FARTHER = 2 ** 10;

/** The loops take their bounds from here: of a module's constants a bundler makes variables, which V8 looks up at each use. */
export const BOUNDS = Float64Array.of(
  CLEAR,
  CERTAIN,
  SMALLEST,
  LEAST,
  LARGEST_SQUARE,
  SMALLEST_SQUARE,
  SLACK_A,
  SLACK,
  FARTHER,
);

export type CoarsePass = (
  lattice: Lattice,
  rays: Rays,
  out: Answers,
  from: number,
  to: number,
) => void;

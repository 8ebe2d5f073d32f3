import type { Answers, Rays } from '../../batch/batch.ts';
import type { Lattice } from './lattice.ts';

/*
 * Pass 1: is it hit, and roughly where. u = 2^-53. D = b² − AC, in halves, is off by 27u·Q at most, Q = Am·Cm (class-quadric.ts). Where Am is neither
 * tiny nor huge, what underflows is far below `smallest`; what overflows fails the comparisons.
 *
 * D > CLEAR·Q: √D is known to 27u·2^19 < 2^-29 of itself, and |b|/√D ≤ 2^10.
 * |A| > LEAST·Am: |δA| ≤ 3u·Am + u|A| (squares u, their sum u; a·y² 3u; the difference), so A is known to 200u, and not 0.
 *
 * So the middle of the rough roots, off by 5u√Q/|A| and by what 1/A is off, is known to 2^-36 of their distance and each of them to 2^-28.9. That is less than
 * 2^-7 units of t, since pass 3 asks of both points to be within 2^24 units of the centre and |d| has at least 2^4, so their distance is below
 * 2^21: the whole number next to a rough root is at most 0.51 units from the root.
 *
 * Where A·D overflows, 1/(A·D) is 0, and so is half the distance of the rough roots: pass 3 asks
 * for a gap between them, and leaves such a ray open.
 */
const CLEAR = 2 ** -20;
const CERTAIN = -28 * 2 ** -53;
const LEAST = 2 ** -6;

/** The relative error of a step in lattice-solve.ts is (4 Am/|A| + 14)u at most, and more by what g is off; pass 1 has Am/|A| at hand. */
const SLACK_A = 4 * 2 ** -53;
const SLACK = 14 * 2 ** -53;

/** What pass 1 leaves open goes to recentred.ts if b² is that many times D, its roots much nearer to each other than to E; else to refined.ts at once. A matter of speed only. */
const FARTHER = 2 ** 10;

/** The loops take their bounds from here: of a module's constants a bundler makes variables, which V8 looks up at each use. */
export const BOUNDS = Float64Array.of(CLEAR, CERTAIN, LEAST, SLACK_A, SLACK, FARTHER);

export type CoarsePass = (
  lattice: Lattice,
  rays: Rays,
  out: Answers,
  from: number,
  to: number,
) => void;

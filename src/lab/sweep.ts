import { type Dial, FAMILIES, type Family } from '../math/families.ts';
import { METHODS } from '../math/index.ts';
import { batchesOf, type Sample } from './plan.ts';
import { qualityOf } from './quality.ts';
import { familyOf } from './session.ts';
import { type Summary, summaryOf } from './summary.ts';
import type { Judgement } from './verdict.ts';

/** A sweep: a family with a dial, at `points` values of the dial. */
export interface SweepRequest extends Omit<Sample, 'difficulty'> {
  readonly family: string;
  readonly points: number;
}

/** Every method at one difficulty. */
export interface SweepPoint {
  readonly difficulty: number;
  readonly rows: readonly { readonly id: string; readonly quality: Summary }[];
}

interface DialFamily extends Family {
  readonly dial: Dial;
}

/** The families that have a dial. */
export const DIAL_FAMILIES: readonly DialFamily[] = FAMILIES().filter(
  (family): family is DialFamily => family.dial !== null,
);

/** Values of the dial from one end of its range to the other, evenly spaced. */
export function difficulties({ range: [from, to] }: Dial, points: number): number[] {
  return Array.from({ length: points }, (_, i) => from + ((to - from) * i) / (points - 1));
}

/**
 * One difficulty after the other, each on rays drawn from the same seed.
 *
 * @throws InvalidInput for an unknown family.
 */
export function* sweepSession(request: SweepRequest): Generator<SweepPoint, void> {
  const family = familyOf(request.family);
  if (!family.dial) return;
  for (const difficulty of difficulties(family.dial, request.points)) {
    const batches = batchesOf(family, { ...request, difficulty });
    const rows = METHODS.map((method) => ({
      id: method.id,
      quality: summaryOf(qualityOf(method, batches), batches),
    }));
    yield { difficulty, rows };
  }
}

/** A method's line through a sweep. */
interface MethodLine {
  readonly id: string;
  /** The points up to the last difficulty at which 9 of 10 rays have a right digit. */
  readonly points: readonly { readonly difficulty: number; readonly quality: Summary }[];
  /** The first difficulty at which a verdict is wrong or undecided. */
  readonly firstFailure?: Failure;
  /** Where the line ends: from here on more than one ray in ten fails. */
  readonly end?: Failure;
}

export interface Failure {
  readonly difficulty: number;
  /** The commonest judgement of the failing rays. */
  readonly reason: Exclude<Judgement, 'right'>;
  readonly share: number;
  readonly quality: Summary;
}

export function linesOf(points: readonly SweepPoint[]): MethodLine[] {
  const [first] = points;
  return (first?.rows ?? []).map(({ id }) => lineOf(id, points));
}

function lineOf(id: string, points: readonly SweepPoint[]): MethodLine {
  const own = points.flatMap(({ difficulty, rows }) => {
    const row = rows.find((one) => one.id === id);
    return row ? [{ difficulty, quality: row.quality }] : [];
  });
  const failing = own.filter(({ quality }) => quality.wrong + quality.undecided > 0);
  const last = own.findIndex(({ quality }) => !(quality.digits > 0) && failureShare(quality) > 0);
  const [firstFailing] = failing;
  const end = last < 0 ? undefined : own[last];
  return {
    id,
    points: (last < 0 ? own : own.slice(0, last)).filter(({ quality }) => quality.digits >= 0),
    ...(firstFailing && { firstFailure: failureOf(firstFailing) }),
    ...(end && { end: failureOf(end) }),
  };
}

const failureShare = ({ wrong, undecided, rays }: Summary): number => (wrong + undecided) / rays;

function failureOf({ difficulty, quality }: MethodLine['points'][number]): Failure {
  const { judged } = quality;
  const reasons = ['misses', 'invents', 'misnames', 'undecided'] as const;
  const reason = reasons.reduce((most, one) => (judged[one] > judged[most] ? one : most));
  return { difficulty, reason, share: failureShare(quality), quality };
}

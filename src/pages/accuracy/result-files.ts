import type { Columns, MeasuredRow, Timing } from '../../lab/session.ts';
import type { SweepPoint } from '../../lab/sweep.ts';
import type { Target } from '../../math/batch.ts';
import { METHODS } from '../../math/index.ts';
import type { Column } from '../../state/accuracy/column.ts';
import type { RayModel } from '../../state/accuracy/ladder.ts';
import { type AccuracySettings, TARGETS } from '../../state/accuracy/settings.ts';
import { csv } from '../../text/csv.ts';

/** All results, with their provenance. */
export interface Findings {
  readonly provenance: string;
  readonly settings: AccuracySettings;
  /** Null while its results are hidden: the files then have the measured rays alone. */
  readonly ray: RayModel | null;
  /** The rows that the plot shows. */
  readonly column: Column;
  /** The results of this machine; undefined before a measurement. */
  readonly columns: Columns | undefined;
  readonly sweep: readonly SweepPoint[];
}

/** Columns about the method on one ray, and about the measured rays of the family. */
const OF_THIS_RAY = ['verdict', 'judgement', 't1', 't1 digits', 't2', 't2 digits'];
const OF_THE_FAMILY = [
  ...['rays', 'wrong', 'undecided', 'digits in 9 rays of 10', 'digits in the worst ray'],
  'most ulps',
];
const OF_A_TARGET = [
  ...['ns', 'ns of 1 round in 4 at most', 'ns of 3 rounds in 4 at most'],
  'times textbook',
];
const QUESTIONS = ['both roots', 'a verdict alone'];

const headOf = ({ family, order }: AccuracySettings): readonly string[] => [
  'method',
  ...OF_THIS_RAY.map((name) => `this ray: ${name}`),
  ...OF_THE_FAMILY.map((name) => `${family} rays: ${name}`),
  ...TARGETS.flatMap(({ title }) =>
    QUESTIONS.flatMap((asked) =>
      OF_A_TARGET.map((name) => `${family} rays ${order} ${title} ${asked}: ${name}`),
    ),
  ),
];

/** CSV with one line per method; cells without a measurement are empty. */
export function toCsv({ settings, ray, columns }: Findings): string {
  const lines = METHODS.map(({ id }) => {
    const row = ray?.rows.find(({ method }) => method.id === id);
    const [first, second] = row?.roots ?? [];
    const rowIn = (target: Target): MeasuredRow | undefined =>
      columns?.[target].find((row) => row.id === id);
    const quality = rowIn('typescript')?.quality;
    return [
      ...[id, row?.found.class, row?.judgement, first?.t, first?.digits, second?.t, second?.digits],
      ...[quality?.rays, quality?.wrong, quality?.undecided],
      ...[quality?.digits, quality?.leastDigits, quality?.mostUlps],
      ...TARGETS.flatMap((target) => {
        const row = rowIn(target.id);
        return [...timeCells(row?.roots), ...timeCells(row?.classes)];
      }),
    ].map((x) => (Number.isNaN(x) ? '' : x));
  });
  return csv([headOf(settings), ...lines]);
}

const timeCells = (timing: Timing | undefined) => [
  timing?.ns.value,
  timing?.ns.low,
  timing?.ns.most,
  timing?.times.value,
];

/** JSON has no infinities and no NaN: they are written as strings. */
export function toJson({ ray, ...rest }: Findings): string {
  const thisRay = ray?.rows.map(({ method, found, judgement, roots }) => ({
    method: method.id,
    verdict: found.class,
    judgement,
    roots: roots.map(({ t, digits, ulps, pointError }) => ({ t, digits, ulps, pointError })),
  }));
  return `${JSON.stringify({ ...rest, thisRay }, finite, 2)}\n`;
}

const finite = (_: string, value: unknown): unknown =>
  typeof value === 'number' && !Number.isFinite(value) ? String(value) : value;

import { MOST_DIGITS } from './digits.ts';
import { BASE_METHOD, type MeasuredRow, type Timing } from './session.ts';

/** A whole number with a thin space between its thousands. */
export const grouped = (n: number): string => String(n).replace(/\B(?=(\d{3})+$)/g, '\u202f');

/** A multiple as the table writes it, three figures at most: 1.06, 12.3, 220. */
export const multiple = (x: number): string =>
  x >= 99.95 ? String(Math.round(x)) : String(Number(x.toPrecision(3)));

type Question = 'classes' | 'roots';

const medianOf = (timing: Timing | undefined): number => timing?.ratio.median ?? Number.NaN;

/** The cheapest method for the question among those that are good enough; null if none is measured. */
function cheapest(
  rows: readonly MeasuredRow[],
  question: Question,
  good: (row: MeasuredRow) => boolean,
): MeasuredRow | null {
  return rows
    .filter((row) => good(row) && row[question])
    .reduce<MeasuredRow | null>(
      (best, row) => (best && medianOf(best[question]) <= medianOf(row[question]) ? best : row),
      null,
    );
}

const isCorrect = ({ quality }: MeasuredRow): boolean =>
  quality.wrong === 0 && quality.undecided === 0;
/** One of the two doubles around the exact root: at most one step from the nearest. */
const isFaithful = (row: MeasuredRow): boolean => isCorrect(row) && !(row.quality.mostUlps > 1);

/** What the plot above it says, in plain words and with the table's own numbers. Empty until a time is measured. */
export function sentenceOf(rows: readonly MeasuredRow[], titleOf: (id: string) => string): string {
  const base = rows.find(({ id }) => id === BASE_METHOD);
  if (!base?.roots) return '';
  return [`On these rays, ${errorsOf(base)}`, priceOf(rows, titleOf)].filter(Boolean).join(' ');
}

function errorsOf({ quality }: MeasuredRow): string {
  const { wrong, undecided, rays, leastDigits } = quality;
  const failures = [
    ...(wrong > 0 ? [`misjudges ${grouped(wrong)} of ${grouped(rays)}`] : []),
    ...(undecided > 0 ? [`cannot tell for ${grouped(undecided)}`] : []),
  ];
  if (failures.length > 0) return `the textbook formula ${failures.join(' and ')}.`;
  if (leastDigits >= MOST_DIGITS) return 'the textbook formula is right to the last digit.';
  return 'the textbook formula has every verdict right.';
}

function priceOf(rows: readonly MeasuredRow[], titleOf: (id: string) => string): string {
  const verdicts = cheapest(rows, 'classes', isCorrect);
  // Where no ray has a root, there is none to be faithful.
  const anyRoot = rows.some(({ quality }) => !Number.isNaN(quality.digits));
  const roots = anyRoot ? cheapest(rows, 'roots', isFaithful) : null;
  const times = (row: MeasuredRow, question: Question): string =>
    `${multiple(medianOf(row[question]))} times the textbook formula (${titleOf(row.id)})`;
  const parts = [
    ...(verdicts ? [`right verdicts for all of them cost ${times(verdicts, 'classes')}`] : []),
    ...(roots ? [`faithful roots ${times(roots, 'roots')}`] : []),
  ];
  if (parts.length === 0) return '';
  const text = parts.join('; ');
  return `${text.charAt(0).toUpperCase()}${text.slice(1)}.`;
}

import { MOST_DIGITS } from './digits.ts';
import { BUSY, type Price, spreadOf } from './price.ts';
import { BASE_METHOD, type MeasuredRow } from './session.ts';

/** A whole number with a thin space between its thousands. */
export const grouped = (n: number): string => String(n).replace(/\B(?=(\d{3})+$)/g, '\u202f');

/** A price as it is shown: 0.92, 19.3, 102, 4 250. */
export const priceText = ({ value }: Price): string =>
  value >= 1000 ? grouped(value) : String(value);

/** A verdict alone, or both roots with it. */
export type Question = 'classes' | 'roots';

/**
 * The cheapest method for the question among those that are good enough; null if none is measured.
 */
function cheapest(
  rows: readonly MeasuredRow[],
  question: Question,
  good: (row: MeasuredRow) => boolean,
): MeasuredRow | null {
  const least = (row: MeasuredRow): number => row[question]?.ns.least ?? Number.NaN;
  return rows
    .filter((row) => good(row) && row[question])
    .reduce<MeasuredRow | null>(
      (best, row) => (best && least(best) <= least(row) ? best : row),
      null,
    );
}

const isCorrect = ({ quality }: MeasuredRow): boolean =>
  quality.wrong === 0 && quality.undecided === 0;
/** One of the two doubles around the exact root: at most one step from the nearest. */
const isFaithful = (row: MeasuredRow): boolean => isCorrect(row) && !(row.quality.mostUlps > 1);

/**
 * What the plot says, in plain words and with the table's own numbers, for the question that is
 * shown. Empty until a time is measured.
 */
export function sentenceOf(
  rows: readonly MeasuredRow[],
  question: Question,
  titleOf: (id: string) => string,
): string {
  const base = rows.find(({ id }) => id === BASE_METHOD);
  if (!base?.[question]) return '';
  const parts = [errorsOf(base), priceWords(rows, question, titleOf), busyWords(rows, question)];
  return parts.filter(Boolean).join(' ');
}

function errorsOf({ quality }: MeasuredRow): string {
  const { wrong, undecided, rays, leastDigits } = quality;
  const failures = [
    ...(wrong > 0 ? [`misjudges ${grouped(wrong)} of ${grouped(rays)}`] : []),
    ...(undecided > 0 ? [`cannot tell for ${grouped(undecided)}`] : []),
  ];
  if (failures.length > 0) return `On these rays, the textbook formula ${failures.join(' and ')}.`;
  if (leastDigits >= MOST_DIGITS)
    return 'On these rays, the textbook formula is right to the last digit.';
  return 'On these rays, the textbook formula has every verdict right.';
}

function priceWords(
  rows: readonly MeasuredRow[],
  question: Question,
  titleOf: (id: string) => string,
): string {
  const found = cheapest(rows, question, question === 'roots' ? isFaithful : isCorrect);
  const times = found?.[question]?.times;
  if (!found || !times) return '';
  // Where no ray has a root, there is none to be faithful.
  const anyRoot = rows.some(({ quality }) => !Number.isNaN(quality.digits));
  const what =
    question === 'classes'
      ? 'right verdicts alone, without roots,'
      : anyRoot
        ? 'faithful roots for all of them'
        : 'right answers for all of them, both roots asked for,';
  if (found.id === BASE_METHOD)
    return `It is the cheapest method, too, with ${what.replace(/,$/, '')}.`;
  const price =
    times.value <= 1
      ? 'no more than'
      : `${times.figures < 3 ? 'about ' : ''}${priceText(times)} times as much as`;
  return `${capital(what)} cost ${price} the textbook formula’s (${titleOf(found.id)}).`;
}

/** A reader who knows that something else was running will not take the last figure at its word. */
function busyWords(rows: readonly MeasuredRow[], question: Question): string {
  const spread = spreadOfRows(rows, question);
  if (!(spread > BUSY)) return '';
  return `The machine was busy; one round in four took at least ${Math.round(100 * spread)} % longer than the best.`;
}

/** How far the rounds of the least steady method spread; −∞ before there is a time. */
export const spreadOfRows = (rows: readonly MeasuredRow[], question: Question): number =>
  Math.max(...rows.flatMap((row) => (row[question] ? [spreadOf(row[question].ns)] : [])));

const capital = (text: string): string => `${text.charAt(0).toUpperCase()}${text.slice(1)}`;

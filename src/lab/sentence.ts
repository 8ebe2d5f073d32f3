import { MOST_DIGITS } from './digits.ts';
import { BUSY, type Price, spreadOf } from './price.ts';
import { BASE_METHOD, type MeasuredRow } from './session.ts';

/** A whole number with a thin space between its thousands. */
export const grouped = (n: number): string => String(n).replace(/\B(?=(\d{3})+$)/g, '\u202f');

/** A price as it is shown: 0.92, 19.3, 102, 4 250. */
export const priceText = ({ value }: Price): string =>
  value >= 1000 ? grouped(value) : String(value);

/** What a method is asked: the class alone, or class and both roots. */
export type Question = 'classes' | 'roots';

const isCorrect = ({ quality }: MeasuredRow): boolean =>
  quality.wrong === 0 && quality.undecided === 0;
/**
 * Whether each root is one of the two doubles around the exact one, at most 1 ulp from the nearest.
 */
const isFaithful = (row: MeasuredRow): boolean => isCorrect(row) && !(row.quality.mostUlps > 1);

type TitleOf = (id: string) => string;

/** The cheapest method for the question that satisfies `good`; null if none is measured. */
function cheapest(
  rows: readonly MeasuredRow[],
  question: Question,
  good: (row: MeasuredRow) => boolean,
): MeasuredRow | null {
  const low = (row: MeasuredRow): number => row[question]?.ns.low ?? Number.NaN;
  const known = rows.filter((row) => good(row) && row[question]);
  const found = known.reduce<MeasuredRow | null>(
    (best, row) => (best && low(best) <= low(row) ? best : row),
    null,
  );
  // If the spread of its rounds reaches the textbook's price, it is not shown to be cheaper.
  const base = known.find(({ id }) => id === BASE_METHOD);
  const most = found?.[question]?.times.most ?? Number.NaN;
  return base && !(most < 1) ? base : found;
}

/**
 * A sentence on what right answers cost on the rays of these rows, with the numbers of the table.
 * Empty until both questions have a time. No row may be emulated. `lead` says what the prices are
 * of, `rays` on which rays the verdicts are counted.
 */
export function headlineOf(
  rows: readonly MeasuredRow[],
  titleOf: TitleOf,
  lead = '',
  rays = 'rays',
): string {
  const words = answerOf(rows, titleOf, rays);
  return words && lead ? `${lead}, ${words.charAt(0).toLowerCase()}${words.slice(1)}` : words;
}

function answerOf(rows: readonly MeasuredRow[], titleOf: TitleOf, rays: string): string {
  const base = rows.find(({ id }) => id === BASE_METHOD);
  if (!base?.classes || !base.roots) return '';
  const verdict = cheapest(rows, 'classes', isCorrect);
  if (!verdict) return `No method that is measured here is right about all of these ${rays}.`;
  const first =
    verdict.id === BASE_METHOD
      ? `The textbook formula is right about all of these ${rays}, ` +
        'and nothing right is clearly cheaper'
      : `A verdict that is right for all of these ${rays} costs ` +
        priceWords(verdict, 'classes', titleOf);
  // Without a root on any ray the sentence ends here.
  if (!rows.some(({ quality }) => !Number.isNaN(quality.digits))) return `${first}.`;
  const roots = cheapest(rows, 'roots', isFaithful);
  if (!roots) return `${first}; no method gives both roots to the last digit.`;
  if (roots.id === BASE_METHOD) return `${first}, with both roots to the last digit, too.`;
  const same = roots.id === verdict.id;
  return (
    `${first}; both roots, faithful to the last digit, cost ` +
    `${priceWords(roots, 'roots', same ? null : titleOf)}.`
  );
}

/** “about 1.2 times the textbook formula (certified)”, both for the same question. */
function priceWords(row: MeasuredRow, question: Question, titleOf: TitleOf | null): string {
  const times = row[question]?.times;
  if (!times) return '';
  const { value, figures } = times;
  const about = figures < 3 ? 'about ' : '';
  const price =
    value === 1
      ? `${about}as much as the textbook formula`
      : value < 1
        ? `less than the textbook formula, ${about}${priceText(times)} of its price`
        : `${about}${priceText(times)} times the textbook formula`;
  return titleOf ? `${price} (${titleOf(row.id)})` : price;
}

/**
 * Sentences on what the textbook formula gets wrong on these rays, what the cheapest method does,
 * and whether the machine was busy. Empty while nothing is counted.
 */
export function detailsOf(
  rows: readonly MeasuredRow[],
  question: Question,
  titleOf: TitleOf,
): string {
  const base = rows.find(({ id }) => id === BASE_METHOD);
  if (!base) return '';
  return [errorsOf(base), cheapestWords(rows, question, titleOf), busyWords(rows, question)]
    .filter(Boolean)
    .join(' ');
}

function errorsOf({ quality }: MeasuredRow): string {
  const words = failuresOf(quality);
  const these = `On these ${grouped(quality.rays)} rays`;
  if (words) return `${these} the textbook formula ${words}.`;
  if (quality.leastDigits >= MOST_DIGITS)
    return `${these} the textbook formula is right to the last digit.`;
  return `${these} the textbook formula has every verdict right.`;
}

function failuresOf({ wrong, undecided }: MeasuredRow['quality']): string {
  return [
    ...(wrong > 0 ? [`misjudges ${grouped(wrong)}`] : []),
    ...(undecided > 0 ? [`cannot tell for ${grouped(undecided)}`] : []),
  ].join(' and ');
}

function cheapestWords(rows: readonly MeasuredRow[], question: Question, titleOf: TitleOf): string {
  const found = cheapest(rows, question, () => true);
  const times = found?.[question]?.times;
  if (!found || !times || !(times.value < 1)) return '';
  const words = failuresOf(found.quality);
  const does = words || 'has every verdict right';
  const asked = question === 'roots' ? 'both roots' : 'a verdict alone';
  const cheapestIs =
    `The cheapest for ${asked} is ${titleOf(found.id)}, ${priceText(times)} of textbook’s ` +
    `price: it ${does}.`;
  return [cheapestIs, listedWords(rows, found, titleOf)].filter(Boolean).join(' ');
}

/** Share of the rays from which on listing them is told as a part of the price. */
const TOLD = 0.01;

/**
 * Why the cheaper method may be so: false tangents are listed like true ones. '' where the textbook
 * lists hardly more rays.
 */
function listedWords(rows: readonly MeasuredRow[], found: MeasuredRow, titleOf: TitleOf): string {
  const base = rows.find(({ id }) => id === BASE_METHOD);
  if (!base || !(base.quality.listed - found.quality.listed > TOLD * base.quality.rays)) return '';
  const own = found.quality.listed === 0 ? 'none' : grouped(found.quality.listed);
  return (
    'What is neither a plain hit nor a miss to a method, a tangent above all, is listed ray by ' +
    `ray, right or not, and that is in its price: the textbook formula lists ` +
    `${grouped(base.quality.listed)}, ${titleOf(found.id)} ${own}.`
  );
}

/** A sentence that the machine was busy, so that the last figure may be wrong; '' if it was not. */
function busyWords(rows: readonly MeasuredRow[], question: Question): string {
  const spread = spreadOfRows(rows, question);
  if (!(spread > BUSY)) return '';
  return (
    `The machine was busy; one round in four took at least ${Math.round(100 * spread)} % ` +
    `longer than the best quarter.`
  );
}

/** Largest spread of any method's rounds; −∞ before there is a time. */
export const spreadOfRows = (rows: readonly MeasuredRow[], question: Question): number =>
  Math.max(...rows.flatMap((row) => (row[question] ? [spreadOf(row[question].ns)] : [])));

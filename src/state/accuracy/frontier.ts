import { digitCount } from '../../lab/digits.ts';
import type { Price } from '../../lab/price.ts';
import { grouped, priceText, type Question } from '../../lab/sentence.ts';
import { BASE_METHOD, type MeasuredRow, type Timing } from '../../lab/session.ts';
import { findMethod } from '../../math/shapes.ts';
import { display } from '../../text/format.ts';
import { type Column, isEmulated, targetTitle } from './column.ts';
import type { Cost, Worth } from './settings.ts';

export interface FrontierMark {
  readonly id: string;
  /** Label beside the mark, and the text after it in lighter type. */
  readonly name: string;
  readonly note: string;
  /** Name, price and quality in words, for screen readers. */
  readonly words: string;
  readonly cost: Price;
  /** Larger is better. */
  readonly worth: number;
  /** The price was measured on another machine. */
  readonly isFaint: boolean;
  /** The mark takes no part in the frontier, since its price cannot be compared. */
  readonly isApart: boolean;
}

export interface FrontierModel {
  readonly marks: readonly FrontierMark[];
  readonly chosen: string;
  readonly costTitle: string;
  /** Nanoseconds per unit of cost, for the second scale; null if unknown. */
  readonly unit: number | null;
  /** Whether grid lines follow the second scale (ns) instead of the first (multiples). */
  readonly gridByUnit: boolean;
  readonly worthTitle: string;
  /** The worths that the axis shows, from the worst to the best, and their labels. */
  readonly worthTicks: readonly { readonly value: number; readonly label: string }[];
}

/** Which cost belongs to a measure of worth: the class alone is cheaper than the roots. */
export const questionOf = (worth: Worth): Question => (worth === 'wrong' ? 'classes' : 'roots');

export const titleOf = (id: string): string => findMethod(id)?.title ?? id;

/** The plot of digits against time. Null before there is a price, or if no ray has a root. */
export function frontierOf(
  { rows, target, isFaint }: Omit<Column, 'why'>,
  { worth, cost }: { readonly worth: Worth; readonly cost: Cost },
  chosen: string,
): FrontierModel | null {
  const question = questionOf(worth);
  const marks = rows.flatMap((row) => {
    const timing = row[question];
    const value = worthOf(row, worth);
    if (!timing || Number.isNaN(value)) return [];
    const { id } = row;
    const emulated = isEmulated(id, target);
    return [
      {
        id,
        name: `${titleOf(id)} ${priceText(timing.times)}`,
        note: `${emulated ? ', emulated' : ''}${failures(row)}`,
        words: wordsOf(row, timing, { emulated, isFaint }),
        cost: timing.times,
        worth: value,
        isFaint,
        isApart: emulated,
      },
    ];
  });
  if (marks.length === 0) return null;
  const base = rows.find(({ id }) => id === BASE_METHOD);
  const unit = isFaint ? null : (base?.[question]?.ns.value ?? null);
  return {
    marks,
    chosen,
    costTitle: `price: time ÷ textbook’s, ${QUESTION_WORDS[question]}, ${targetTitle(target)}`,
    unit,
    gridByUnit: cost === 'ns' && unit !== null,
    worthTitle: WORTH_TITLES[worth],
    worthTicks: worth === 'wrong' ? shareTicks(marks) : DIGIT_TICKS,
  };
}

export const QUESTION_WORDS: Readonly<Record<Question, string>> = {
  classes: 'verdict only',
  roots: 'both roots',
};

const WORTH_TITLES: Readonly<Record<Worth, string>> = {
  digits: 'digits right, in 9 rays of 10',
  worst: 'digits right, in the worst ray',
  wrong: 'wrong verdicts, or none',
};

const DIGIT_TICKS = [0, 4, 8, 12, 16].map((value) => ({ value, label: String(value) }));

/** Larger is better, so a share of failures is negated. */
function worthOf({ quality }: MeasuredRow, worth: Worth): number {
  if (worth === 'wrong') return 0 - (quality.wrong + quality.undecided) / quality.rays;
  return worth === 'digits' ? quality.digits : quality.leastDigits;
}

/** Ticks of the failure axis: 0 % on top, then round shares down to the worst one. */
function shareTicks(marks: readonly { readonly worth: number }[]) {
  const worst = Math.max(0.001, ...marks.map(({ worth }) => -worth));
  const step =
    [0.0005, 0.001, 0.002, 0.005, 0.01, 0.02, 0.05, 0.1, 0.2, 0.25].find((s) => worst / s <= 4) ??
    0.25;
  return Array.from({ length: Math.ceil(worst / step - 1e-9) + 1 }, (_, i) => ({
    value: 0 - i * step,
    label: `${display(100 * i * step, 3)} %`,
  }));
}

function failures({ quality }: MeasuredRow): string {
  const { wrong, undecided } = quality;
  const parts = [
    ...(wrong > 0 ? [`${grouped(wrong)} wrong`] : []),
    ...(undecided > 0 ? [`${grouped(undecided)} undecided`] : []),
  ];
  return parts.length > 0 ? `: ${parts.join(', ')}` : '';
}

function wordsOf(
  { id, quality }: MeasuredRow,
  { ns, times }: Timing,
  { emulated, isFaint }: { readonly emulated: boolean; readonly isFaint: boolean },
): string {
  const digits = Number.isNaN(quality.digits)
    ? 'no roots to compare'
    : `${digitCount(quality.digits)} digits right in 9 rays of 10, ` +
      `${digitCount(quality.leastDigits)} in the worst`;
  const wrong =
    `${grouped(quality.wrong)} of ${grouped(quality.rays)} verdicts wrong, ` +
    `${grouped(quality.undecided)} undecided`;
  const price = `${priceText(times)} times textbook${emulated ? ', emulated' : ''}`;
  const time = isFaint
    ? `${price} for typical rays where this page was built`
    : `${priceText(ns)} ns a ray, ${price}`;
  return `${titleOf(id)}: ${digits}; ${wrong}; ${time}`;
}

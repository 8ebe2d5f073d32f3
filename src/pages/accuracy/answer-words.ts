import { detailsOf, headlineOf, type Question } from '../../lab/sentence.ts';
import type { Order } from '../../lab/timed.ts';
import { findFamily } from '../../math/families.ts';
import { type Column, comparable, isEmulated, targetTitle } from '../../state/accuracy/column.ts';
import { titleOf } from '../../state/accuracy/frontier.ts';
import { dialWords } from '../../state/accuracy/hardness.ts';
import type { AccuracySettings } from '../../state/accuracy/settings.ts';
import { familyName } from './family-name.ts';
import type { Measuring } from './measuring.ts';

/** The settings that choose the rays. */
type Asked = Pick<AccuracySettings, 'family' | 'order' | 'dial'>;

/** The start of the sentence: on which rays its prices were measured. */
function leadOf(isFaint: boolean, order: Order): string {
  const met = order === 'sorted' ? 'with hits first' : 'in random order';
  if (isFaint) return `By the reference prices of typical rays ${met}`;
  return met.charAt(0).toUpperCase() + met.slice(1);
}

/** Explanation of faint marks. */
export const REFERENCE_WORDS =
  'Faint: reference prices of typical rays, from the bench of this build, until this device has ' +
  'measured. Each price is the lower quartile of its rounds.';

/** The page's first sentence and the details below it, made from the numbers shown. */
export function answerWords(
  column: Column,
  question: Question,
  { family, order, dial }: Asked,
): { readonly headline: string; readonly details: string } {
  const rows = comparable(column);
  const own = findFamily(family)?.dial;
  const hard = own ? ` (${dialWords(own, dial)})` : '';
  const rays = `“${familyName(family)}” rays${hard}`;
  const headline = headlineOf(rows, titleOf, leadOf(column.isFaint, order), rays);
  // Reference prices were measured elsewhere, so their spread does not show whether this machine
  // is busy.
  const known = column.isFaint ? rows.map(({ id, quality }) => ({ id, quality })) : rows;
  const details = detailsOf(known, question, titleOf);
  return { headline, details: [details, ...apartWords(column)].filter(Boolean).join(' ') };
}

/** Sentences on methods whose prices cannot be compared. */
function apartWords({ rows, target }: Column): string[] {
  const named = (found: Column['rows']): string => found.map(({ id }) => titleOf(id)).join(' and ');
  const emulated = rows.filter((row) => isEmulated(row.id, target));
  const isPriced = rows.some(({ roots }) => roots);
  const missing = isPriced ? rows.filter(({ roots }) => !roots) : [];
  return [
    ...(isPriced && emulated.length > 0
      ? [`Emulated here, so without a price of its own: ${named(emulated)}.`]
      : []),
    ...(missing.length > 0
      ? [`Without a price in ${targetTitle(target)}: ${named(missing)}.`]
      : []),
  ];
}

/** The text in place of a plot that cannot be drawn. */
export function emptyWords({ rows }: Column, { found, failed }: Measuring): string {
  if (!found) return failed ? 'Nothing was counted.' : 'Verdicts are being counted …';
  return rows.some(({ roots }) => roots)
    ? 'No ray of this family has a root to have digits: look at the wrong verdicts instead.'
    : 'Not measured yet.';
}

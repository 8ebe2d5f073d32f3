import { type Price, rounded } from '../../lab/price.ts';
import type { Measured, MeasuredRow, Timing } from '../../lab/session.ts';
import type { Quartiles } from '../../lab/stats.ts';
import type { Order } from '../../lab/timed.ts';
import type { Target } from '../../math/batch.ts';
import type { Column } from '../../state/accuracy/column.ts';
import type { AccuracySettings } from '../../state/accuracy/settings.ts';

/** Multiples of the textbook in the same target and order, by method: quartiles of rounds. */
type Ratios = Readonly<Record<string, Quartiles>>;
type Ladder = Readonly<Record<Target, Readonly<Record<Order, Ratios>>>>;

/** What `npm run bench -- ladder` measured of typical rays where this page was built. */
interface ReferencePrices {
  readonly both: Ladder;
  readonly classes: Ladder;
}

/**
 * The rows to show, in the chosen target if it is available. Reference prices are shown only until
 * this machine has measured, so that a column never mixes machines.
 */
export function columnOf(
  { target: asked, order }: Pick<AccuracySettings, 'target' | 'order'>,
  found: Measured | null,
  reference: ReferencePrices,
): Column {
  const isMissing = asked === 'simd' && found !== null && !found.simd;
  const target = isMissing ? 'typescript' : asked;
  const why = isMissing ? found.noSimd : '';
  const rows = found?.columns[target] ?? [];
  if (rows.some(isPriced)) return { target, rows, isFaint: false, why };
  const [roots, classes] = [reference.both, reference.classes].map((by) => by[target][order]);
  const faint = rows.map((row) => ({ ...row, ...timingsOf(roots?.[row.id], classes?.[row.id]) }));
  return { target, rows: faint, isFaint: faint.some(isPriced), why };
}

const isPriced = ({ roots, classes }: MeasuredRow): boolean => Boolean(roots ?? classes);

function timingsOf(
  both: Quartiles | undefined,
  alone: Quartiles | undefined,
): Pick<MeasuredRow, 'roots' | 'classes'> {
  return { ...(both && { roots: timingOf(both) }), ...(alone && { classes: timingOf(alone) }) };
}

/** A reference price; its ns are unknown here, so the multiple is used for both fields. */
function timingOf({ low, high }: Quartiles): Timing {
  const times: Price = { value: rounded(low, 2), figures: 2, low, most: high };
  return { ns: times, times };
}

import type { Quartiles } from '../../src/lab/stats.ts';
import type { Method } from '../../src/math/shapes.ts';
import { type Form, nameOf, type Prices, ratioOf, TARGETS, type Target } from './prices.ts';
import { ORDERS, type Order } from './rays.ts';

/** Ratios to textbook in the same target and order, by method. */
type Ratios = Readonly<Record<string, Quartiles>>;

/** What the Accuracy page draws until it has measured for itself. */
export interface ReferencePrices {
  readonly date: string;
  readonly version: string;
  readonly rays: number;
  readonly rounds: number;
  /** Both roots. A target without textbook's own kernel has no ratios. */
  readonly both: Readonly<Record<Target, Readonly<Record<Order, Ratios>>>>;
  /** "Is it hit?", to textbook's own answer to that. */
  readonly classes: Readonly<Record<Target, Readonly<Record<Order, Ratios>>>>;
}

export function referencePrices(
  prices: Prices,
  methods: readonly Method[],
  about: Pick<ReferencePrices, 'date' | 'version' | 'rounds'>,
): ReferencePrices {
  const { date, version, rounds } = about;
  const table = (form: Form): ReferencePrices['both'] =>
    keyed(TARGETS, (target) =>
      keyed(ORDERS, (order) => ratios(prices, methods, target, order, form)),
    );
  return {
    date,
    version,
    rays: prices.rays,
    rounds,
    both: table('both'),
    classes: table('classes'),
  };
}

function ratios(
  { times }: Prices,
  methods: readonly Method[],
  target: Target,
  order: Order,
  form: Form,
): Ratios {
  const base = nameOf('textbook', target, form);
  const found = methods.map(({ id }): [string, Quartiles | null] => [
    id,
    ratioOf(times[order], nameOf(id, target, form), base),
  ]);
  const kept = found.filter((entry): entry is [string, Quartiles] => entry[1] !== null);
  return Object.fromEntries(kept.map(([id, q]) => [id, short(q)]));
}

/** Four digits: the quartiles lie further apart. */
const digits = (x: number): number => Number(x.toPrecision(4));
const short = ({ low, median, high }: Quartiles): Quartiles => ({
  low: digits(low),
  median: digits(median),
  high: digits(high),
});

const keyed = <K extends string, V>(keys: readonly K[], of: (key: K) => V): Record<K, V> =>
  Object.fromEntries(keys.map((key) => [key, of(key)])) as Record<K, V>;

import type { Quality } from '../../src/lab/quality.ts';
import { type Quartiles, quantile } from '../../src/lab/stats.ts';
import type { Family } from '../../src/math/families.ts';
import type { Method } from '../../src/math/shapes.ts';
import type { Compared } from './objects.ts';
import type { Beside } from './others.ts';
import { type Form, nameOf, type Prices, ratioOf, TARGETS, type Target } from './prices.ts';
import { ORDERS, type Order } from './rays.ts';

/** What was measured of one family: each method's mistakes, and its times. */
export interface Measured {
  readonly family: Pick<Family, 'id' | 'title' | 'idea'>;
  readonly quality: ReadonlyMap<string, Quality>;
  readonly prices: Prices;
  /** Rays that a method's loops leave to the method itself; null: it has no loops. */
  readonly left: ReadonlyMap<string, number | null>;
  readonly rays: number;
}

export const MARKS = ['<!-- bench -->', '<!-- /bench -->'] as const;

const row = (cells: readonly string[]): string => `| ${cells.join(' | ')} |`;

export function table(head: readonly string[], rows: readonly (readonly string[])[]): string[] {
  return [row(head), row(head.map((_, i) => (i === 0 ? '---' : '---:'))), ...rows.map(row)];
}

const MISSING = '–';

/** Three figures: the quartiles lie further apart. */
const figures = (x: number): string => (x >= 100 ? x.toFixed(0) : x.toPrecision(3));
const median = (q: Quartiles | null): string => (q ? figures(q.median) : MISSING);
export const spread = (q: Quartiles | null): string =>
  q ? `${figures(q.median)} (${figures(q.low)}–${figures(q.high)})` : MISSING;

/** 0, a few units, or a rounded power: what fits into a cell. */
const short = (x: number): string =>
  x < 1000 ? x.toFixed(0) : x.toExponential(1).replace('+', '');

const ulpsOf = ({ ulps }: Quality, share: number): string =>
  ulps.length ? short(quantile(ulps, share)) : MISSING;

const microseconds = ({ times, rays }: Prices, id: string, order: Order): string => {
  const all = [...(times[order].get(id) ?? [])].sort((a, b) => a - b);
  return all.length ? `${((quantile(all, 0.5) / rays) * 1000).toPrecision(3)} µs` : MISSING;
};

/** Both targets in both orders: the cells of one line. */
const cells = (of: (target: Target, order: Order) => string): string[] =>
  TARGETS.flatMap((target) => ORDERS.map((order) => of(target, order)));

/** textbook32 in TypeScript rounds each operation to float32 by a call: no price of float32. */
const isEmulated = (id: string, target: Target): boolean =>
  id === 'textbook32' && target === 'typescript';

const toTextbook = (
  { times }: Prices,
  id: string,
  target: Target,
  order: Order,
  form: Form,
): Quartiles | null =>
  ratioOf(times[order], nameOf(id, target, form), nameOf('textbook', target, form));

const shareOf = (part: number | null, all: number): string =>
  part === null ? MISSING : percent(part, all);

/** One family in full, in the order that it is drawn in. */
export function familyTable({ family, quality, prices, left, rays }: Measured): string[] {
  const rows = [...quality].map(([id, q]) => [
    id,
    ...TARGETS.map((target) =>
      isEmulated(id, target) ? MISSING : spread(toTextbook(prices, id, target, 'random', 'both')),
    ),
    `${q.wrong}`,
    `${q.undecided}`,
    ulpsOf(q, 0.999),
    ulpsOf(q, 1),
    shareOf(left.get(id) ?? null, rays),
  ]);
  const head =
    'method,SIMD,TypeScript,wrong class,undecided,ulps: 99.9 %,max,left by the loops'.split(',');
  return [`### ${family.title}`, '', family.idea, '', ...table(head, rows), ''];
}

/** The rest of what was measured on many rays. */
export interface Ladder {
  readonly typical: Prices;
  readonly onSurface: Prices;
  readonly methods: readonly Method[];
  readonly measured: readonly Measured[];
}

const HEAD = [
  'ratio to textbook in the same column',
  'SIMD, random',
  'SIMD, sorted',
  'TypeScript, random',
  'TypeScript, sorted',
];

/**
 * The ladder at one look: what both roots cost by each method, and how often it is wrong on all the
 * families together. Stands in docs/bench.md and, from the same run, in the README.
 */
export function headline({ typical, onSurface, methods, measured }: Ladder): string[] {
  const total = measured.reduce((sum, { rays }) => sum + rays, 0);
  const rows = methods.map(({ id }) => {
    const all = measured.map(({ quality }) => quality.get(id) as Quality);
    const share = (count: (q: Quality) => number): string =>
      percent(
        all.reduce((sum, q) => sum + count(q), 0),
        total,
      );
    const ulps = all.flatMap((q) => q.ulps).sort((a, b) => a - b);
    return [
      id,
      ...cells((target, order) =>
        isEmulated(id, target) ? MISSING : median(toTextbook(typical, id, target, order, 'both')),
      ),
      share((q) => q.wrong),
      share((q) => q.undecided),
      ulps.length ? short(quantile(ulps, 0.999)) : MISSING,
    ];
  });
  const more = (what: string, prices: Prices, form: Form): string[] => [
    what,
    ...cells((target, order) => median(toTextbook(prices, 'certified', target, order, form))),
    ...['', '', ''],
  ];
  const head = [
    ...HEAD,
    `wrong class, all ${measured.length} families`,
    'undecided',
    'ulps: 99.9 %',
  ];
  return [
    MARKS[0],
    '',
    ...table(head, [
      ...rows,
      more('certified, class only', typical, 'classes'),
      more('certified, first hit at t ≥ 0', typical, 'first'),
      more('certified, rays that start on a surface', onSurface, 'both'),
    ]),
    '',
    MARKS[1],
  ];
}

/** What compares across columns, and what is no ratio. */
export function besides({ typical }: Ladder): string[] {
  const each = (of: (order: Order) => string): string => ORDERS.map(of).join(', sorted ');
  const across = (order: Order, id: string, base: string): string =>
    spread(ratioOf(typical.times[order], id, base));
  const textbook = nameOf('textbook', 'typescript', 'both');
  const certified = nameOf('certified', 'simd', 'both');
  const emulated = nameOf('textbook32', 'typescript', 'both');
  const exact = nameOf('exact', 'typescript', 'both');
  return [
    `* certified in SIMD to textbook in TypeScript: random ` +
      `${each((o) => across(o, certified, textbook))}`,
    `* textbook32 in TypeScript is emulated (Math.fround at each operation), to ` +
      `textbook: random ${each((o) => across(o, emulated, textbook))}`,
    `* exact, a ray: random ${each((o) => microseconds(typical, exact, o))}`,
    `* textbook in TypeScript, a ray: random ${each((o) => microseconds(typical, textbook, o))}`,
    '',
  ];
}

/** Every ratio again with its quartiles. */
export function quartilesTable({ typical, onSurface, methods }: Ladder): string[] {
  const line = (what: string, prices: Prices, id: string, form: Form): string[] => [
    what,
    ...cells((target, order) =>
      isEmulated(id, target) ? MISSING : spread(toTextbook(prices, id, target, order, form)),
    ),
  ];
  return table(HEAD, [
    ...methods.map(({ id }) => line(id, typical, id, 'both')),
    ...methods
      .filter(({ id }) => typical.times.random.has(nameOf(id, 'typescript', 'classes')))
      .map(({ id }) => line(`${id}, class only`, typical, id, 'classes')),
    ...methods.map(({ id }) => line(`${id}, first hit at t ≥ 0`, typical, id, 'first')),
    line('certified, rays that start on a surface', onSurface, 'certified', 'both'),
  ]);
}

export const objectLines = (compared: readonly Compared[]): string[] =>
  table(
    ['`intersect`, one ray at a time, input checked, t and class read', 'ratio'],
    compared.map((one) => [one.what, spread(one)]),
  );

export const otherLines = (beside: readonly Beside[]): string[] =>
  table(
    ['first hit at t ≥ 0, to textbook’s batch in TypeScript', 'ratio', 'wrong verdicts', 'rays'],
    beside.map((one) => [one.what, spread(one), `${one.wrong}`, `${one.rays}`]),
  );

const percent = (part: number, all: number): string =>
  part === 0 ? '0' : `${((100 * part) / all).toPrecision(2)} %`;

/**
 * The text with what stands between the two marks replaced. Throws RangeError where they are
 * missing.
 */
export function betweenMarks(
  text: string,
  lines: readonly string[],
  marks: readonly [string, string] = MARKS,
): string {
  const from = text.indexOf(marks[0]);
  const to = text.indexOf(marks[1]);
  if (from < 0 || to < from) throw new RangeError(`no ${marks.join(' … ')} in the text`);
  return text.slice(0, from) + lines.join('\n') + text.slice(to + marks[1].length);
}

import { priceOf } from '../../src/lab/price.ts';
import type { Quality } from '../../src/lab/quality.ts';
import type { Times } from '../../src/lab/run.ts';
import { quantile, quartiles } from '../../src/lab/stats.ts';
import type { Family } from '../../src/math/families.ts';

/** What was measured of one family: for each method its times, both ways, and its mistakes. */
export interface Measured {
  readonly family: Pick<Family, 'id' | 'title' | 'idea'>;
  readonly roots: Times;
  readonly classes: Times;
  readonly quality: ReadonlyMap<string, Quality>;
  readonly rays: number;
}

export const MARKS = ['<!-- bench -->', '<!-- /bench -->'] as const;

/** To textbook: of the best rounds (quartiles, round by round). */
export function ratios(times: Times, id: string): string {
  const base = times.get('textbook') ?? [];
  const { low, high } = quartiles((times.get(id) ?? []).map((x, k) => x / (base[k] ?? 1)));
  return `${ratioOf(times, id)} (${low.toFixed(2)}–${high.toFixed(2)})`;
}

const leastOf = (times: Times, id: string): number => priceOf(times.get(id) ?? []).least;

const ratioOf = (times: Times, id: string): string =>
  (leastOf(times, id) / leastOf(times, 'textbook')).toFixed(2);

export const nanoseconds = (times: Times, id: string, rays: number): string =>
  Math.round((leastOf(times, id) / rays) * 1e6).toString();

const row = (cells: readonly string[]): string => `| ${cells.join(' | ')} |`;

function table(head: readonly string[], rows: readonly (readonly string[])[]): string[] {
  return [row(head), row(head.map((_, i) => (i === 0 ? '---' : '---:'))), ...rows.map(row)];
}

/** 0, a few units, or a rounded power: what fits into a cell. */
const short = (x: number): string =>
  x < 1000 ? x.toFixed(0) : x.toExponential(1).replace('+', '');

const ulpsOf = ({ ulps }: Quality, share: number): string =>
  ulps.length ? short(quantile(ulps, share)) : '–';

/** One family in full. */
export function familyTable({ family, roots, classes, quality, rays }: Measured): string[] {
  const rows = [...quality].map(([id, q]) => [
    id,
    ratios(roots, id),
    nanoseconds(roots, id, rays),
    ratios(classes, id),
    nanoseconds(classes, id, rays),
    `${q.wrong}`,
    `${q.undecided}`,
    ulpsOf(q, 0.999),
    ulpsOf(q, 1),
  ]);
  const head = 'method,both roots,ns,class only,ns,wrong class,undecided,ulps: 99.9 %,max'.split(
    ',',
  );
  return [`### ${family.title}`, '', family.idea, '', ...table(head, rows), ''];
}

/**
 * The ladder at one look: what each method costs on ordinary rays and on a mix with 1 % hard ones,
 * and how often it is wrong on all the families together. Stands in docs/bench.md and, from the
 * same run, in the README.
 */
export function headline(measured: readonly Measured[]): string[] {
  const of = (id: string): Measured | undefined => measured.find(({ family }) => family.id === id);
  const price = (id: string, form: 'roots' | 'classes', method: string): string => {
    const found = of(id);
    return found ? ratioOf(found[form], method) : '–';
  };
  const methods = [...(measured[0]?.quality.keys() ?? [])];
  const total = measured.reduce((sum, { rays }) => sum + rays, 0);
  const rows = methods.map((id) => {
    const all = measured.map(({ quality }) => quality.get(id) as Quality);
    const share = (count: (q: Quality) => number): string =>
      percent(
        all.reduce((sum, q) => sum + count(q), 0),
        total,
      );
    const ulps = all.flatMap((q) => q.ulps).sort((a, b) => a - b);
    return [
      id,
      price('typical', 'roots', id),
      price('typical', 'classes', id),
      price('mix', 'roots', id),
      price('mix', 'classes', id),
      share((q) => q.wrong),
      share((q) => q.undecided),
      ulps.length ? short(quantile(ulps, 0.999)) : '–',
      ulps.length ? short(ulps.at(-1) ?? 0) : '–',
    ];
  });
  const head = [
    'method',
    'typical rays: both roots',
    'class only',
    '1 % hard rays: both roots',
    'class only',
    `wrong class, all ${measured.length} families`,
    'undecided',
    'ulps: 99.9 %',
    'max',
  ];
  return [MARKS[0], '', ...table(head, rows), '', MARKS[1]];
}

const percent = (part: number, all: number): string =>
  part === 0 ? '0' : `${((100 * part) / all).toPrecision(2)} %`;

/**
 * The text with what stands between the two marks replaced. Throws RangeError where they are
 * missing.
 */
export function betweenMarks(text: string, lines: readonly string[]): string {
  const from = text.indexOf(MARKS[0]);
  const to = text.indexOf(MARKS[1]);
  if (from < 0 || to < from) throw new RangeError(`no ${MARKS.join(' … ')} in the text`);
  return text.slice(0, from) + lines.join('\n') + text.slice(to + MARKS[1].length);
}

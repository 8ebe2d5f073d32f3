import type { scaleLog } from 'd3-scale';
import { grouped } from '../lab/sentence.ts';
import { type Field, labelSize, type PlotTick } from './plot.ts';

/** Least px per power of ten with ticks at 1, 2 and 5. */
const DENSE = 150;
/** Least distance between two labels, in em. */
const APART = 0.4;

/**
 * Ticks of an axis of costs at 1, 2 and 5 times each power of ten of a unit; only at 1, or at every
 * second or third power, where labels would be too near to each other.
 *
 * @param x scale from multiples of the textbook's cost to px.
 * @param unit what the cost 1 is, in ns; 1 for the multiples themselves.
 */
export function costTicks(
  x: ReturnType<typeof scaleLog<number>>,
  unit: number,
  { width, em }: Pick<Field, 'width' | 'em'>,
): PlotTick[] {
  const [from = 1, to = 1] = x.domain().map((value) => value * unit);
  const decades = Math.log10(to / from);
  const [left = 0, right = 0] = x.range();
  const first = Math.floor(Math.log10(from));
  const powers = Array.from({ length: Math.ceil(decades) + 2 }, (_, k) => first + k);
  const made = (steps: readonly number[], every: number): PlotTick[] =>
    powers
      .filter((power) => power % every === 0)
      .flatMap((power) => steps.map((step) => Number(`${step}e${power}`)))
      .filter((value) => value >= from && value <= to)
      .map((value) => ({
        at: x(value / unit),
        label: `${value >= 1 ? grouped(value) : value}${unit === 1 ? '' : ' ns'}`,
      }))
      .filter(({ at, label }) => at + labelSize(label, em).width / 2 <= width);
  const half = ({ label }: PlotTick): number => labelSize(label, em).width / 2;
  const isApart = (ticks: readonly PlotTick[]): boolean =>
    ticks.every((tick, i) => {
      const before = ticks[i - 1];
      return !before || tick.at - half(tick) >= before.at + half(before) + APART * em;
    });
  const dense = (right - left) / decades > DENSE ? [made([1, 2, 5], 1)] : [];
  const choices = [...dense, made([1], 1), made([1], 2), made([1], 3)];
  return choices.find(isApart) ?? [];
}

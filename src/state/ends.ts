import type { Shape } from '../math/index.ts';
import { definitionOf } from '../math/shapes.ts';
import { display } from '../text/format.ts';
import { type Action, applied, type Edit, type EndsValue } from './actions.ts';
import type { Between } from './heights.ts';

/** An end of a shape, by the height that it is at. */
export type End = 'low' | 'high';

export const CAP_NAMES: Readonly<Record<End, string>> = { low: 'lower cap', high: 'upper cap' };

/** A height of an end, like the parameters that shapes declare. */
export const END_PARAMS = [
  { symbol: 'low', title: 'lower end', range: [-5, 5], step: 0.1 },
  { symbol: 'high', title: 'upper end', range: [-5, 5], step: 0.1 },
] as const;

/** Sets one of the heights, 0 the lower one; nothing where there are no ends any more. */
export const endAction = (i: 0 | 1, edit: Edit<number>): Action => ({
  type: 'ends',
  value(now) {
    if (!now) return now;
    const [low, high] = now.between;
    const y = applied(edit, now.between[i]);
    return { ...now, between: i === 0 ? [y, high] : [low, y] };
  },
});

/** Why these are no heights, quoting them; null if they are. */
export function endsRefusal([low, high]: Between): string | null {
  if (!Number.isFinite(low) || !Number.isFinite(high)) return 'a height must be a finite number';
  if (low < high) return null;
  return `low must be below high, got ${display(low, 17)} and ${display(high, 17)}`;
}

/** Ends about the shape's point, as far off as the shape is large. */
export function someEnds(shape: Shape): EndsValue {
  const { at, size } = definitionOf(shape).anchor(shape);
  const half = size > 0 && Number.isFinite(size) ? size : 1;
  // Far off both may round to one double.
  const [low, high] = [at[1] - half, at[1] + half];
  return { between: low < high ? [low, high] : [-1, 1], caps: false };
}

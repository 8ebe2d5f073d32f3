import { findShape } from '../math/shapes/lookup.ts';
import { display, displayTriple } from '../text/format.ts';
import { subscript } from '../text/scripts.ts';
import type { ExploreModel } from './derive.ts';
import { paramValue } from './state.ts';

/**
 * What a listener should hear of a change: the value first, the consequence second. "r 1.2. The ray is now tangent: one
 * double root, the ray touches, t₁ 3.46." Empty if nothing audible changed.
 */
export function announcement(before: ExploreModel, after: ExploreModel): string {
  const value = changedValue(before, after);
  const news = after.state.revealed === null ? consequence(before, after) : '';
  return [value, news].filter(Boolean).join(' ');
}

function changedValue(before: ExploreModel, after: ExploreModel): string {
  const { state: a, shape: old } = before;
  const { state: b, shape, title } = after;
  if (a.kind !== b.kind) return `${title}.`;
  if (a.E !== b.E) return `E ${displayTriple(b.E)}.`;
  if (a.d !== b.d || a.unit !== b.unit) return `d ${displayTriple(after.ray.direction)}.`;
  if (a.method !== b.method) return `Computed by ${b.method}.`;
  const param = findShape(shape.kind)?.params.find(
    ({ key }) => paramValue(shape, key) !== paramValue(old, key),
  );
  return param ? `${param.symbol} ${spoken(paramValue(shape, param.key))}.` : '';
}

function spoken(value: ReturnType<typeof paramValue>): string {
  if (typeof value === 'string') return value;
  return typeof value === 'number' ? display(value) : displayTriple(value);
}

/** The verdict if it is another one now; else just where the first visible hit has gone. */
function consequence(before: ExploreModel, after: ExploreModel): string {
  const moved = hitsSpoken(before) !== hitsSpoken(after);
  const changed = before.verdict.text !== after.verdict.text;
  if (!moved && !changed) return '';
  const hits = hitsSpoken(after);
  if (!changed) return hits && `${hits}.`;
  return `Now ${after.verdict.text}${hits ? `, ${hits}` : ''}.`;
}

function hitsSpoken({ hits }: ExploreModel): string {
  return hits.map(({ index, t }) => `t${subscript(index)} ${display(t, 3)}`).join(', ');
}

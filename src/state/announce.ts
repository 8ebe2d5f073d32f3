import { findShape } from '../math/shapes.ts';
import { rootTexts } from '../text/apart.ts';
import { withArticle } from '../text/article.ts';
import { display, displayTriple } from '../text/format.ts';
import { subscript } from '../text/scripts.ts';
import type { ExploreModel } from './derive.ts';
import { paramValue } from './state.ts';

/**
 * What a listener should hear of a change: the value first, the consequence second. "r 1.2. The ray
 * is now tangent: one double root, the ray touches, t₁ 3.46." Empty if nothing audible changed.
 */
export function announcement(before: ExploreModel, after: ExploreModel): string {
  const value = newExample(before, after) || changedValue(before, after);
  const news = after.state.revealed === null ? consequence(before, after) : '';
  const told = after.state.told && !before.state.told ? (after.example?.entry.answer ?? '') : '';
  const left = leavesExample(before, after) ? 'The example is changed.' : '';
  return [value, news, told, left].filter(Boolean).join(' ');
}

/**
 * "Example 5 of 41: in the plane. Which t solve the equation?", if an example was opened or its
 * changes were undone; '' otherwise.
 */
function newExample({ example: old }: ExploreModel, { example, state }: ExploreModel): string {
  if (!example || example.changed) return '';
  if (old && !old.changed && old.number === example.number) return '';
  const { number, of, entry } = example;
  if (state.revealed !== null) return `Example ${number} of ${of}.`;
  return `Example ${number} of ${of}: ${entry.title}. ${entry.asks}`;
}

const leavesExample = (before: ExploreModel, after: ExploreModel): boolean =>
  before.example?.changed === false && after.example?.changed === true;

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
  if (!param) return '';
  const value = spoken(paramValue(shape, param.key));
  return `${param.symbol} ${value}${title === before.title ? '' : `: ${named(title)}`}.`;
}

/** "a cylinder" */
function named(title: string): string {
  if (title === 'axis' || title === 'point')
    return `only ${title === 'axis' ? 'the axis' : 'the centre'} is left`;
  return withArticle(title);
}

function spoken(value: ReturnType<typeof paramValue>): string {
  if (typeof value === 'string') return value;
  return typeof value === 'number' ? display(value) : displayTriple(value);
}

/** The verdict if it is another one now; else just where the first visible hit has gone. */
function consequence(before: ExploreModel, after: ExploreModel): string {
  const moved = hitsSpoken(before) !== hitsSpoken(after);
  const changed = before.verdict.text !== after.verdict.text;
  const typed = typedSpoken(after);
  const news = typed !== typedSpoken(before) ? typed : '';
  const hits = moved || changed ? hitsSpoken(after) : '';
  if (!changed) return [hits && `${hits}.`, news].filter(Boolean).join(' ');
  return `Now ${after.verdict.text}${hits ? `, ${hits}` : ''}. ${news}`.trim();
}

/** What the numbers as typed say, where that is something else, and what is to be known of them. */
function typedSpoken({ asTyped: { differs, notes } }: ExploreModel): string {
  const typed = differs ? [`As typed: ${differs.typed.text}.`] : [];
  return [...typed, ...notes].join(' ');
}

function hitsSpoken({ hits }: ExploreModel): string {
  const texts = rootTexts(
    hits.map(({ t }) => t),
    3,
  );
  return hits.map(({ index }, i) => `t${subscript(index)} ${texts[i]}`).join(', ');
}

import { findShape } from '../math/shapes.ts';
import { withArticle } from '../text/article.ts';
import { rootTexts } from '../text/distinguish.ts';
import { display, displayTriple } from '../text/format.ts';
import { subscript } from '../text/scripts.ts';
import { spokenName } from '../text/spoken.ts';
import { NAMED_VIEWS } from './camera-view.ts';
import type { ExploreModel } from './derive.ts';
import { CAP_NAMES } from './ends.ts';
import { paramValue } from './state.ts';

/**
 * What a listener should hear of a change: the value first, the consequence second. "r 1.2. The ray
 * is now tangent: one double root, the ray touches, t₁ 3.46." Empty if nothing audible changed.
 */
export function announcement(before: ExploreModel, after: ExploreModel): string {
  const value = newExample(before, after) || changedValues(before, after);
  const news = after.state.revealed === null ? consequence(before, after) : revealed(before, after);
  const told = after.state.told && !before.state.told ? (after.example?.entry.answer ?? '') : '';
  const left = leavesExample(before, after) ? 'The example is changed.' : '';
  const seen = value ? '' : viewed(before, after);
  return [value, seen, news, told, left].filter(Boolean).join(' ');
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

/** "E (3, 1, 1). r 1.2.": all that has got another value. */
function changedValues(before: ExploreModel, after: ExploreModel): string {
  const { state: a, shape: old } = before;
  const { state: b, shape, title } = after;
  const isOther = a.kind !== b.kind;
  const params = (findShape(shape.kind)?.params ?? []).filter(
    ({ key }) => !isOther && paramValue(shape, key) !== paramValue(old, key),
  );
  const becomes = title === before.title ? '' : `: ${named(title)}`;
  return [
    isOther ? `${title}.` : '',
    a.E === b.E ? '' : `E ${displayTriple(b.E)}.`,
    a.d === b.d && a.unit === b.unit ? '' : `d ${displayTriple(after.ray.direction)}.`,
    a.method === b.method ? '' : `Computed by ${b.method}.`,
    ...params.map(({ key, symbol }, i) => {
      const isLast = i === params.length - 1;
      return `${symbol} ${spoken(paramValue(shape, key))}${isLast ? becomes : ''}.`;
    }),
    endsSpoken(before, after),
  ]
    .filter(Boolean)
    .join(' ');
}

/** The shape's ends, if they have changed. */
function endsSpoken({ state: a }: ExploreModel, { state: b, found, title }: ExploreModel): string {
  const isSame = a.between === b.between && a.caps === b.caps;
  if (isSame || found.details.family !== 'curved') return '';
  if (!b.between) return `The ${title} is whole.`;
  const [low, high] = b.between;
  const lows = low === a.between?.[0] ? [] : [`low ${display(low)}.`];
  const highs = high === a.between?.[1] ? [] : [`high ${display(high)}.`];
  const caps = a.caps === b.caps && a.between ? [] : [b.caps ? 'Closed by caps.' : 'Open ends.'];
  return [...lows, ...highs, ...caps].join(' ');
}

/** The camera's view, if it has changed. */
function viewed({ state: { view: old } }: ExploreModel, { state: { view } }: ExploreModel): string {
  if (view === old) return '';
  if (typeof view === 'string') {
    return `View: ${NAMED_VIEWS.find(({ id }) => id === view)?.title}.`;
  }
  const { azimuth, elevation, zoom } = view;
  const near = zoom === null ? '' : `, zoom ${display(zoom)}`;
  return `View: ${display(azimuth)}° round, ${display(elevation)}° up${near}.`;
}

/** The lines that were shown one by one, while others are still hidden. */
function revealed({ shown: before }: ExploreModel, after: ExploreModel): string {
  const { shown, derivation, verdict } = after;
  const steps = derivation.steps.slice(before.steps, Math.max(before.steps, shown.steps));
  return [
    ...steps.map(({ id, value }) =>
      value === null ? 'The line of t.' : `${spokenName(id)} ${display(value)}.`,
    ),
    ...(shown.conditions && !before.conditions
      ? derivation.conditions.map(({ holds }, i) => `Condition ${i + 1} ${holdsWords(holds)}.`)
      : []),
    shown.verdict && !before.verdict ? `${verdict.text}.` : '',
    shown.hits && !before.hits ? `${hitsSpoken(after)}.` : '',
  ]
    .filter((words) => words.length > 1)
    .join(' ');
}

const holdsWords = (holds: boolean | null): string =>
  holds === null ? 'cannot be told' : holds ? 'holds' : 'fails';

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
  const isShown = before.state.revealed !== null;
  const changed = isShown || before.verdict.text !== after.verdict.text;
  const typed = typedSpoken(after);
  const news = typed !== typedSpoken(before) ? typed : '';
  const hits = moved || changed ? hitsSpoken(after) : '';
  if (!changed) return [hits && `${hits}.`, news].filter(Boolean).join(' ');
  const lead = isShown ? 'Shown:' : 'Now';
  return `${lead} ${after.verdict.text}${hits ? `, ${hits}` : ''}. ${news}`.trim();
}

/** The verdict for the numbers as typed, if it is another one, and notes on these numbers. */
function typedSpoken({ asTyped: { differs, notes } }: ExploreModel): string {
  const typed = differs ? [`As typed: ${differs.typed.text}.`] : [];
  return [...typed, ...notes].join(' ');
}

function hitsSpoken({ hits, ended }: ExploreModel): string {
  const texts = rootTexts(
    hits.map(({ t }) => t),
    3,
  );
  const roots = hits.map(
    ({ index, role }, i) => `t${subscript(index)} ${texts[i]}${role === 'cut' ? ' cut off' : ''}`,
  );
  const caps = (ended?.capHits ?? []).map(
    ({ end, hit }) => `${CAP_NAMES[end]} ${display(hit.t, 3)}`,
  );
  return [...roots, ...caps].join(', ');
}

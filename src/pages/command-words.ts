import { SHAPES } from '../math/index.ts';
import { type AppState, PAGES, type Settings } from '../state/state.ts';

/**
 * Words for screen readers on the effect of a command; '' where state/announce.ts (changes of ray
 * and shape), a dialog or the page announces it.
 */
export function commandWords(id: string, before: AppState, after: AppState): string {
  const still = before === after;
  const words = WORDS[id]?.(before, after, still);
  if (words !== undefined) return words;
  const shape = SHAPES.find(({ kind }) => id === `shape-${kind}`);
  return shape && before.kind === after.kind ? `${shape.title}, as before.` : '';
}

type Tell = (before: AppState, after: AppState, still: boolean) => string;

/** Words on `next` and `previous` of Explore. */
const turned: Tell = (before, after, still) => {
  if (still) return before.derive ? 'This is the end of the derivation.' : 'Nothing more.';
  if (before.told && !after.told && before.example === after.example)
    return 'The answer is hidden.';
  const back = (after.revealed ?? 0) < (before.revealed ?? 0);
  return back ? `A line is hidden again: ${after.revealed} shown.` : '';
};

const undone =
  (word: string, nothing: string): Tell =>
  (before, after, still) =>
    still ? nothing : [word, ...changes(before, after)].join(' ');

const WORDS: Readonly<Record<string, Tell>> = {
  next: turned,
  previous: turned,
  answer: (before, after, still) =>
    still ? 'No question is asked.' : before.told && !after.told ? 'The answer is hidden.' : '',
  derive: (_, after) => (after.derive ? '' : 'The derivation is closed.'),
  hide: (_, { revealed }) => (revealed === null ? '' : 'The results are hidden.'),
  reveal: ({ revealed: before }, { revealed }) => {
    if (before === null || revealed === null) return 'Nothing is hidden.';
    return revealed > before ? '' : 'Every line is shown.';
  },
  ghost: (_, { ghost }) =>
    ghost ? 'This ray is kept as a ghost to compare with.' : 'The ghost is dropped.',
  reset: () => 'Reset.',
  undo: undone('Undone.', 'There is nothing to undo.'),
  redo: undone('Done again.', 'There is nothing to redo.'),
};

/** Words on changes of the page, the method and the page's settings. */
function changes(before: AppState, after: AppState): string[] {
  const page = PAGES.find(({ id }) => id === after.page)?.title ?? '';
  const { page: id } = after;
  const [old, now]: Settings[] = [before.settings[id], after.settings[id]];
  const keys = [...new Set([...Object.keys(old ?? {}), ...Object.keys(now ?? {})])];
  const other = keys.filter((key) => old?.[key] !== now?.[key]);
  return [
    ...(before.page === after.page ? [] : [`${page}.`]),
    ...(before.method === after.method ? [] : [`method ${after.method}.`]),
    ...other.map((key) => `${key} ${spoken(now?.[key])}.`),
  ];
}

/** A packed scene or lesson is no text to read out. */
const spoken = (text: string | undefined): string =>
  text === undefined
    ? 'as at first'
    : text.startsWith('~') || text.length > 40
      ? 'as it was'
      : text;

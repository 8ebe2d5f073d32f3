import type { Example } from './gallery/define.ts';
import { type AppState, INITIAL } from './state.ts';
import { decode, encode } from './url.ts';

/** The example that a state shows, or was made from. */
export interface ShownExample {
  readonly entry: Example;
  /** From 1. */
  readonly number: number;
  readonly of: number;
  /** Whether ray, shape or method were changed, so that its question and answer no longer apply. */
  readonly changed: boolean;
}

let examples: readonly Example[] = [];
let numbers: ReadonlyMap<string, number> | null = null;

/**
 * Sets the gallery, which is loaded after the first frame. Before that no state counts as an
 * example, and there is no next one.
 */
export function provideExamples(loaded: readonly Example[]): void {
  examples = loaded;
  numbers = null;
}

/** In the gallery's order; empty until they are loaded. */
export const allExamples = (): readonly Example[] => examples;

/**
 * The example with the values of this state, however the state was reached (its link, undo); else
 * the one that it was made from, as changed; null for neither.
 */
export function exampleOf(state: AppState): ShownExample | null {
  numbers ??= new Map(examples.map(({ link }, i) => [valuesOf(decode(link)), i]));
  const same = numbers.get(valuesOf(state));
  const at = same ?? examples.findIndex(({ id }) => id === state.example);
  const entry = examples[at];
  if (!entry) return null;
  const changed = same === undefined;
  // With another shape it is no longer this example.
  if (changed && decode(entry.link).kind !== state.kind) return null;
  return { entry, number: at + 1, of: examples.length, changed };
}

/** A text that identifies ray, shape and method, without view and bead. */
function valuesOf(state: AppState): string {
  const { view, bead, settings, revealed, ask, derive } = INITIAL;
  return encode({ ...state, page: 'explore', view, bead, settings, revealed, ask, derive });
}

/**
 * "tangent", or "tangent, changed". While results are hidden only its number, "5 of 41", since most
 * titles give the result away.
 */
export const titleOf = ({ entry, changed, number, of }: ShownExample, hidden = false): string => {
  const title = hidden ? `${number} of ${of}` : entry.title;
  return changed ? `${title}, changed` : title;
};

/** Whether the answer to the example's question is shown; null where none is asked. */
export function answerShown(state: AppState): boolean | null {
  const { told, revealed } = state;
  return revealed === null && exampleOf(state)?.changed === false ? told : null;
}

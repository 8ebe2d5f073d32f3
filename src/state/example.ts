import type { Example } from './gallery/define.ts';
import { type AppState, INITIAL } from './state.ts';
import { decode, encode } from './url.ts';

/** The example that a state shows, or was made from. */
export interface ShownExample {
  readonly entry: Example;
  /** From 1. */
  readonly number: number;
  readonly of: number;
  /**
   * Something was changed: the title is still where it came from, and the caption no longer speaks
   * of what is shown.
   */
  readonly changed: boolean;
}

let examples: readonly Example[] = [];
let numbers: ReadonlyMap<string, number> | null = null;

/**
 * The gallery is loaded after the first frame. Until it is there, no state is known as an example,
 * and there is no next one.
 */
export function provideExamples(loaded: readonly Example[]): void {
  examples = loaded;
  numbers = null;
}

/** In the gallery's order; empty until they are loaded. */
export const allExamples = (): readonly Example[] => examples;

/**
 * Whoever opens an example's link has the example, and so has whoever undoes what he changed in it.
 */
export function exampleOf(state: AppState): ShownExample | null {
  numbers ??= new Map(examples.map(({ link }, i) => [valuesOf(decode(link)), i]));
  const same = numbers.get(valuesOf(state));
  const at = same ?? examples.findIndex(({ id }) => id === state.example);
  const entry = examples[at];
  if (!entry) return null;
  const changed = same === undefined;
  // With another shape nothing of the example is left.
  if (changed && decode(entry.link).kind !== state.kind) return null;
  return { entry, number: at + 1, of: examples.length, changed };
}

/** What a caption speaks of: ray, shape and method, however one looks at them. */
function valuesOf(state: AppState): string {
  const { view, bead, settings, revealed, ask } = INITIAL;
  return encode({ ...state, page: 'explore', view, bead, settings, revealed, ask });
}

/**
 * "tangent", or "tangent, changed"; only its number while the results are hidden, as most titles
 * tell them.
 */
export const titleOf = ({ entry, changed, number, of }: ShownExample, hidden = false): string => {
  const title = hidden ? `${number} of ${of}` : entry.title;
  return changed ? `${title}, changed` : title;
};

import type { Example } from './gallery/define.ts';
import { GALLERY } from './gallery/index.ts';
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

let numbers: ReadonlyMap<string, number> | null = null;

/**
 * Whoever opens an example's link has the example, and so has whoever undoes what he changed in it.
 */
export function exampleOf(state: AppState): ShownExample | null {
  numbers ??= new Map(GALLERY.map(({ link }, i) => [valuesOf(decode(link)), i]));
  const same = numbers.get(valuesOf(state));
  const at = same ?? GALLERY.findIndex(({ id }) => id === state.example);
  const entry = GALLERY[at];
  if (!entry) return null;
  const changed = same === undefined;
  // With another shape nothing of the example is left.
  if (changed && decode(entry.link).kind !== state.kind) return null;
  return { entry, number: at + 1, of: GALLERY.length, changed };
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

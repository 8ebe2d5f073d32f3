import type { AppState, PageId } from '../state/state.ts';

/**
 * The parts of other pages that a step can show alone, by the names that their elements carry in
 * data-part.
 */
const PARTS: Readonly<Partial<Record<PageId, readonly string[]>>> = {
  accuracy: ['prices', 'hardness', 'ray'],
};

export const partsOf = (page: PageId): readonly string[] => PARTS[page] ?? [];

/** What of a page a step shows: its own choice, or else the part that the page's link names. */
export function partShown(part: string | null, { page, settings }: AppState): string | null {
  return part ?? settings[page].part ?? (page === 'check' ? 'questions' : null);
}

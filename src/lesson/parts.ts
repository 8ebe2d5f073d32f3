import type { AppState, PageId } from '../state/state.ts';

/** The parts of other pages that a step can show alone: values of their elements' data-part. */
const PARTS: Readonly<Partial<Record<PageId, readonly string[]>>> = {
  accuracy: ['prices', 'hardness', 'ray', 'atlas'],
};

export const partsOf = (page: PageId): readonly string[] => PARTS[page] ?? [];

/** The part of a page that a step shows: the step's own, else that of the page's link. */
export function partShown(part: string | null, { page, settings }: AppState): string | null {
  return part ?? settings[page].part ?? (page === 'check' ? 'questions' : null);
}

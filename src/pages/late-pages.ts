import type { PageId } from '../state/state.ts';
import { late } from '../ui/late.ts';
import type { MountPage } from './page.ts';

/** The code of the pages, except Explore and Lessons, which a step of a lesson can show as well. */
export const SINGLE_PAGES: Readonly<Partial<Record<PageId, () => Promise<MountPage>>>> = {
  accuracy: () =>
    late(() => import('./accuracy/accuracy-page.ts')).then(({ mountAccuracy }) => mountAccuracy),
  check: () => late(() => import('./check/check-page.ts')).then(({ mountCheck }) => mountCheck),
  picture: () =>
    late(() => import('./picture/picture-page.ts')).then(({ loadPicture }) => loadPicture()),
};

import type { PageId } from '../state/state.ts';
import { lazy } from '../ui/lazy.ts';
import type { MountPage } from './page.ts';

/** Loaders of the pages that a step of a lesson can show: all but Explore and Lessons. */
export const SINGLE_PAGES: Readonly<Partial<Record<PageId, () => Promise<MountPage>>>> = {
  accuracy: () =>
    lazy(() => import('./accuracy/accuracy-page.ts')).then(({ mountAccuracy }) => mountAccuracy),
  check: () => lazy(() => import('./check/check-page.ts')).then(({ mountCheck }) => mountCheck),
  picture: () =>
    lazy(() => import('./picture/picture-page.ts')).then(({ loadPicture }) => loadPicture()),
};

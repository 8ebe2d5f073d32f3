import type { Dispatch } from '../../state/actions.ts';
import type { ExploreModel } from '../../state/derive.ts';
import { lazy } from '../../ui/lazy.ts';
import type { Mounted } from '../../ui/mounted.ts';
import { lazyView } from '../lazy-view.ts';

const WORDS = { waiting: 'loading…', failed: 'This part of Graze could not be loaded.' };

/** The parts of Explore that the link names, in the document of the whole page. */
export const lazyEmbed = (host: HTMLElement, dispatch: Dispatch): Mounted<ExploreModel> =>
  lazyView(
    host,
    () => lazy(() => import('./embed-view.ts')),
    ({ mountEmbed }) => mountEmbed(host, dispatch, location.href.replace(/#.*$/, '')),
    WORDS,
  );

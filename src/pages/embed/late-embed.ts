import type { Dispatch } from '../../state/actions.ts';
import type { ExploreModel } from '../../state/derive.ts';
import { late } from '../../ui/late.ts';
import type { Mounted } from '../../ui/mounted.ts';
import { lateView } from '../late-view.ts';

const WORDS = { waiting: 'loading…', failed: 'This part of Graze could not be loaded.' };

/** The parts of Explore that the link names, in the document of the whole page. */
export const lateEmbed = (host: HTMLElement, dispatch: Dispatch): Mounted<ExploreModel> =>
  lateView(
    host,
    () => late(() => import('./embed-view.ts')),
    ({ mountEmbed }) => mountEmbed(host, dispatch, location.href.replace(/#.*$/, '')),
    WORDS,
  );

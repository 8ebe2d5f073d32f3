import type { Dispatch } from '../../state/actions.ts';
import type { GraphModel } from '../../state/graph-model.ts';
import { lazy } from '../../ui/lazy.ts';
import type { Mounted } from '../../ui/mounted.ts';
import { lazyView } from '../lazy-view.ts';

const WORDS = {
  waiting: 'plotting…',
  failed: 'The plot could not be loaded. All numbers and formulas work.',
};

/** The graph of f, loaded after the formulas and numbers are shown. */
export const lazyGraph = (host: HTMLElement, dispatch: Dispatch): Mounted<GraphModel> =>
  lazyView(
    host,
    () => lazy(() => import('../../charts/graph.ts')),
    ({ mountGraph }) => mountGraph(host, dispatch),
    WORDS,
  );

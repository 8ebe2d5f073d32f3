import type { Dispatch } from '../../state/actions.ts';
import type { GraphModel } from '../../state/graph-model.ts';
import { late } from '../../ui/late.ts';
import type { Mounted } from '../../ui/mounted.ts';
import { lateView } from '../late-view.ts';

const WORDS = {
  waiting: 'plotting…',
  failed: 'The plot could not be loaded. All numbers and formulas work.',
};

/** The graph of f, loaded after the formulas and numbers are shown. */
export const lateGraph = (host: HTMLElement, dispatch: Dispatch): Mounted<GraphModel> =>
  lateView(
    host,
    () => late(() => import('../../charts/graph.ts')),
    ({ mountGraph }) => mountGraph(host, dispatch),
    WORDS,
  );

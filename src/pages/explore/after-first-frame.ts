/* Code of Explore that is loaded after the first frame. */

import type { ExploreModel } from '../../state/derive.ts';
import { lazy } from '../../ui/lazy.ts';

export * as ends from '../../panels/ends.ts';
export { normalLine } from '../../panels/normal-line.ts';
export { announcement } from '../../state/announce.ts';
export { exploreDetails } from '../../state/explore-details.ts';
export { GALLERY } from '../../state/gallery/index.ts';
export { followExplore, presentExplore } from '../lesson/projected-window.ts';
export { createBeadPlayer as createPlayer } from './bead-player.ts';
export { exampleQuestion } from './example-question.ts';
export { keepRevealed as keepLines } from './keep-revealed.ts';
export { createMotion } from './motion.ts';
export { createSecondView } from './second-view.ts';

export const NOT_KEPT =
  'this browser keeps nothing here (its storage is full or denied): what is typed on Check lasts ' +
  'until the page is closed. Programs and summaries can be saved by File and export';

/** Loads the handout's code: a browser that prints does not wait for it. */
export function printsOnPaper(shown: () => ExploreModel | null): void {
  lazy(() => import('../handout/explore-handout.ts')).then(
    ({ printExplore }) => printExplore(shown),
    // Without it the page itself is printed.
    () => {},
  );
}

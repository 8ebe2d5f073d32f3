/* What the page has beyond its first frame, which does not wait for it. */

import type { ExploreModel } from '../../state/derive.ts';
import { late } from '../../ui/late.ts';

export * as ends from '../../panels/ends.ts';
export { normalLine } from '../../panels/normal-line.ts';
export { announcement } from '../../state/announce.ts';
export { exploreDetails as closerLook } from '../../state/explore-details.ts';
export { GALLERY } from '../../state/gallery/index.ts';
export { followExplore, presentExplore } from '../lesson/projected-window.ts';
export { createPlayer } from './bead-player.ts';
export { exampleQuestion } from './example-question.ts';
export { keepLines } from './kept-lines.ts';
export { createMotion } from './motion.ts';
export { createSecondView } from './second-view.ts';

export const NOT_KEPT =
  'this browser keeps nothing here (its storage is full or denied): what is typed on Check lasts ' +
  'until the page is closed. Programs and summaries can be saved by File and export';

/** Paper is filled at once when the browser prints, so its code is there before. */
export function printsOnPaper(shown: () => ExploreModel | null): void {
  late(() => import('../handout/explore-handout.ts')).then(
    ({ printExplore }) => printExplore(shown),
    // Without it the page itself is printed.
    () => {},
  );
}

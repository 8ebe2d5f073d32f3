/* What the page has beyond its first frame, which does not wait for it. */

export { announcement } from '../../state/announce.ts';
export { closerLook } from '../../state/closer-look.ts';
export { GALLERY } from '../../state/gallery/index.ts';
export { createPlayer } from './player.ts';
export { createSecondView } from './second-view.ts';
export { story } from './story.ts';
export { createTravel } from './travel.ts';

export const NOT_KEPT =
  'this browser keeps nothing here (its storage is full or denied): what is typed on Check lasts ' +
  'until the page is closed. Programs and summaries can be saved by File and export';

import type { EaselModel } from './compare-view.ts';
import { errorMap } from './error-map.ts';
import type { Sight } from './picture-model.ts';
import { inkOf } from './theme-colours.ts';

/** What the easel shows: one picture, two, or the map of their differences in the theme's ink. */
export function easelModel(
  { picture, shots, main, other, comparison }: Sight,
  host: HTMLElement,
): EaselModel {
  const { width, height, against, split, show, pixel } = picture;
  const traced = (progress: typeof main) => (progress && progress.done > 0 ? progress.frame : null);
  const mapped = against !== null && show === 'errors' ? comparison : null;
  const [paper, ink] = inkOf(host);
  return {
    width,
    height,
    right: traced(main),
    left: traced(other),
    errors: mapped && (() => errorMap(mapped, width, height, paper, ink)),
    comparing: against !== null,
    split,
    pixel,
    version: [
      ...[shots.main.key, main?.done, main?.state, shots.other?.key, other?.done, other?.state],
      ...[mapped !== null, paper],
    ].join('|'),
  };
}

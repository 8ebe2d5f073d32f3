import type { CompareViewModel } from './compare-view.ts';
import { errorMap } from './error-map.ts';
import type { PictureModel } from './picture-model.ts';
import { themeColours } from './theme-colours.ts';

/**
 * What the compare view shows: one picture, two, or a map of their differences in ink.
 */
export function compareViewModel(
  { picture, requests, main, other, comparison }: PictureModel,
  host: HTMLElement,
): CompareViewModel {
  const { width, height, against, split, show, pixel } = picture;
  const traced = (progress: typeof main) => (progress && progress.done > 0 ? progress.frame : null);
  const mapped = against !== null && show === 'errors' ? comparison : null;
  const [paper, ink] = themeColours(host);
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
      ...[
        requests.main.key,
        main?.done,
        main?.state,
        requests.other?.key,
        other?.done,
        other?.state,
      ],
      ...[mapped !== null, paper],
    ].join('|'),
  };
}

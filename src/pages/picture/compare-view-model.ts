import type { CompareViewModel } from './compare-view.ts';
import type { PictureModel } from './picture-model.ts';

/** What the compare view shows: one picture, or two. */
export function compareViewModel({
  picture,
  requests,
  main,
  other,
}: PictureModel): CompareViewModel {
  const { width, height, against, split, pixel } = picture;
  const traced = (progress: typeof main) => (progress && progress.done > 0 ? progress.frame : null);
  return {
    width,
    height,
    right: traced(main),
    left: traced(other),
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
    ].join('|'),
  };
}

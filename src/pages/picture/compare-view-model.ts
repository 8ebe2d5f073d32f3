import type { PictureSettings } from '../../state/picture/settings.ts';
import type { Picture } from '../../tracer/compare.ts';
import type { CompareViewModel } from './compare-view.ts';
import type { PictureModel } from './picture-model.ts';

interface Camera {
  /** The settings of the picture at rest: their size is the frame's. */
  readonly still: PictureSettings;
  /** The picture with more rays a pixel; null without. */
  readonly finer: Picture | null;
  /** Whether unfinished pictures are not shown, since the one on the screen is finer. */
  readonly waits: boolean;
}

/** What the compare view shows: one picture, or two. */
export function compareViewModel(
  { picture, requests, main, other }: PictureModel,
  { still, finer, waits }: Camera,
): CompareViewModel {
  const { against, split, pixel } = picture;
  const { width, height } = still;
  const traced = (progress: typeof main) =>
    progress && progress.done > 0 && (progress.state === 'finished' || !waits)
      ? progress.frame
      : null;
  return {
    width,
    height,
    right: finer ?? traced(main),
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

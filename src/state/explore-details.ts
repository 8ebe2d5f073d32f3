import { asTyped } from './as-typed.ts';
import { endedOf } from './ended.ts';
import { exactBeside, rangeNote, rootGap, shownResult } from './exact-digits.ts';
import { fitsInto, isHalf, LONG, spacesOf } from './number-space.ts';
import { conditionDigits, putIn, resultsOf } from './put-in.ts';
import { createSceneAndGraph } from './scene-and-graph.ts';

/** Functions that are loaded after the first frame: the verdict on a ray needs none of them. */
export const exploreDetails = {
  asTyped,
  createSceneAndGraph,
  /** What a shape's ends leave of the roots. */
  endedOf,
  /** How many digits the page shows, and the exact ones beside them. */
  digits: {
    exactBeside,
    rangeNote,
    rootGap,
    shownResult,
    conditionDigits,
    putIn,
    resultsOf,
    fitsInto,
    isHalf,
    LONG,
    spacesOf,
  },
};

export type ExploreDetails = typeof exploreDetails;

import { asTyped } from './as-typed.ts';
import { endedOf } from './ended.ts';
import { exactBeside, rangeNote, rootGap, shownResult } from './exact-digits.ts';
import { fitsInto, isHalf, LONG, spacesOf } from './number-space.ts';
import { conditionDigits, putIn, resultsOf } from './put-in.ts';
import { createSceneAndGraph } from './scene-and-graph.ts';

/** Everything about a ray that is loaded after the first frame: what its verdict does not need. */
export const closerLook = {
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

export type CloserLook = typeof closerLook;

import { asTyped } from './as-typed.ts';
import { exactBeside, rangeNote, rootGap, shownResult } from './exact-digits.ts';
import { fitsInto, isHalf, LONG, spacesOf } from './number-space.ts';
import { createPictures } from './pictures.ts';
import { conditionDigits, putIn, resultsOf } from './put-in.ts';

/** What is computed of a ray beyond its verdict, by code that the first frame does not wait for. */
export const closerLook = {
  asTyped,
  createPictures,
  /** How many digits stand on the page, and which exact ones beside them. */
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

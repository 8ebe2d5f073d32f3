/** Rays of a block that fit the first cache together with what the passes hand on. */
export const BLOCK = 256;

/**
 * What the passes over a block hand to each other, one value for each ray that is hit. The passes are closures over these arrays, made once: so
 * V8 knows the arrays when it compiles them and reads and writes without looking up map, length and base each time, which costs
 * more than the arithmetic.
 */
export interface Scratch {
  /** The ray's place in the batch. */
  readonly index: Int32Array;
  /** d and E. */
  readonly x: Float64Array;
  readonly y: Float64Array;
  readonly z: Float64Array;
  readonly ex: Float64Array;
  readonly ey: Float64Array;
  readonly ez: Float64Array;
  /** A, √D with A's sign roughly, 1/(2√D), the roots roughly, and how far the relative error of a step may go. */
  readonly A: Float64Array;
  readonly slope: Float64Array;
  readonly half: Float64Array;
  readonly near: Float64Array;
  readonly far: Float64Array;
  readonly slack: Float64Array;
  /** The roots' whole parts, f there, g at the nearer one, what bounds g's error, and how far those points are from the centre. */
  readonly wholeNear: Float64Array;
  readonly wholeFar: Float64Array;
  readonly fNear: Float64Array;
  readonly fFar: Float64Array;
  readonly g: Float64Array;
  readonly reach: Float64Array;
  readonly spread: Float64Array;
  readonly spreadFar: Float64Array;
  /** Places of rays that pass 1 could not judge, and of clear hits that pass 3 could not settle. */
  readonly doubtful: Int32Array;
  readonly unsettled: Int32Array;
  /** How many there are: hits, doubtful, unsettled. */
  readonly count: Int32Array;
}

export const HITS = 0;
export const DOUBTS = 1;
export const UNSETTLED = 2;

export function createScratch(): Scratch {
  const array = (): Float64Array => new Float64Array(BLOCK);
  return {
    index: new Int32Array(BLOCK),
    x: array(),
    y: array(),
    z: array(),
    ex: array(),
    ey: array(),
    ez: array(),
    A: array(),
    slope: array(),
    half: array(),
    g: array(),
    reach: array(),
    near: array(),
    far: array(),
    slack: array(),
    fNear: array(),
    fFar: array(),
    wholeNear: array(),
    wholeFar: array(),
    spread: array(),
    spreadFar: array(),
    doubtful: new Int32Array(BLOCK),
    unsettled: new Int32Array(BLOCK),
    count: new Int32Array(3),
  };
}

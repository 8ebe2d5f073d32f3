/** What the passes of grid-quadric.ts hand to each other, and where in it each number is. */
export type Grid = Float64Array;

export const createGrid = (): Grid => new Float64Array(33);

/** A, b = B/2, C and D/4, rounded, and what b and D/4 are more than that. */
export const A = 0;
export const B = 1;
export const C = 2;
export const D = 3;
export const B_LOW = 4;
export const D_LOW = 5;
/** A in 26 bits, and the rest of it; 1/A. */
export const A_HEAD = 6;
export const A_REST = 7;
export const OVER_A = 8;
/** √D/4 with the sign of A, and what it is more than that. */
export const ROOT = 9;
export const ROOT_LOW = 10;
/** |d|, |E − C| and their like, and the error of D/4: grid-coefficients.ts. */
export const REACH_D = 11;
export const REACH_P = 12;
export const OFF_D = 13;
/** d, its part on the grid and the rest; E in two parts likewise; how far a point may be off. */
export const DX = 14;
export const DY = 15;
export const DZ = 16;
export const XH = 17;
export const YH = 18;
export const ZH = 19;
export const XL = 20;
export const YL = 21;
export const ZL = 22;
export const EXH = 23;
export const EYH = 24;
export const EZH = 25;
export const EXL = 26;
export const EYL = 27;
export const EZL = 28;
export const OFF_X = 29;
export const OFF_Y = 30;
export const OFF_Z = 31;
/** What cuts t. */
export const CUT_T = 32;

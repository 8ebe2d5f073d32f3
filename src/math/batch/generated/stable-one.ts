/*
 * One ray by the method stable root, in float64.
 * Made by `npm run kernels` from the formula trees; not to be edited.
 */
import { CONTAINED, NONE, ONE, TANGENT, TWO, UNDECIDED } from '../batch.ts';
import type { Pieces, PutRoots } from '../one-ray.ts';
import { ONE_RAY as textbook } from './textbook-one.ts';

const roots: PutRoots = (s) => {
s[4] = Number.NaN;
s[5] = Number.NaN;
const A = s[0] as number;
const B = s[1] as number;
const C = s[2] as number;
const D = s[3] as number;
if (A - A !== 0) {
return UNDECIDED;
}
if (A === 0) {
if (B - B !== 0) {
return UNDECIDED;
}
if (B === 0) {
if (C - C !== 0) {
return UNDECIDED;
}
if (C === 0) {
return CONTAINED;
}
return NONE;
}
s[4] = (-C) / B;
return ONE;
}
if (D - D !== 0) {
return UNDECIDED;
}
if (D === 0) {
s[4] = (-B) / (2 * A);
return TANGENT;
}
if (D < 0) {
return NONE;
}
const v0 = (Math.abs(B) + Math.sqrt(D)) * 0.5;
const v1 = !(B < 0) ? -v0 : v0;
const v2 = v1 / A;
const v3 = C / v1;
s[4] = v3 < v2 ? v3 : v2;
s[5] = v3 < v2 ? v2 : v3;
return TWO;
};

export const ONE_RAY: Pieces = {
...textbook,
roots,
};

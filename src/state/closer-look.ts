import { asTyped } from './as-typed.ts';
import { nearTangent } from './near-tangent.ts';
import { nearestTangent } from './nearest-tangent.ts';

/** What is computed of a ray beyond its verdict, by code that the first frame does not wait for. */
export const closerLook = { asTyped, nearTangent, nearestTangent };

export type CloserLook = typeof closerLook;

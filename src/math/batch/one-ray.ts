import type { Values } from '../formula/evaluate.ts';
import type { Vec3 } from '../vec3.ts';

/*
 * One ray without objects, by the pieces that scripts/kernels/trees makes of a method's trees. What
 * they hand on stands in a slot of SLOT numbers:
 *
 *   0 … 3    A, B, C, D; of a flat shape N·(E − P), N·d and t
 *   4, 5     the roots, ascending, NaN where there is none
 *   6 … 8    the point at one of the roots, or at t of a flat shape
 *   9 … 11   its normal; of a flat shape left − right of each of its conditions
 */
export const SLOT = 13;
export const AT_ROOTS = 4;
export const AT_POINT = 6;
export const AT_NORMAL = 9;

/**
 * A, B, C and D, or what a flat shape has in their place.
 *
 * @param values what the shape's symbols stand for.
 */
export type PutForm = (values: Values<number>, E: Vec3, d: Vec3, slot: Float64Array) => void;

/** From A, B, C and D to the roots, and to the class as a place in VERDICTS. */
export type PutRoots = (slot: Float64Array) => number;

/** The point at a root. */
export type PutPoint = (E: Vec3, d: Vec3, slot: Float64Array, root: 0 | 1) => void;

/** The normal at the point. */
export type PutNormal = (values: Values<number>, slot: Float64Array) => void;

/** What batches need of a method, by kind of shape; for what is missing the trees are asked. */
export interface OneRay {
  readonly forms: Readonly<Record<string, PutForm>>;
  readonly roots: PutRoots;
}

/** What objects need beside. */
export interface Pieces extends OneRay {
  readonly point: PutPoint;
  readonly normals: Readonly<Record<string, PutNormal>>;
}

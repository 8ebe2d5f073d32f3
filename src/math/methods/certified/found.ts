import type { DecidedBy } from '../../intersection.ts';

/**
 * What was found of a ray: the two roots, NaN where there is none, the verdict, and by which stage.
 * In doubles: fields of an object would be boxed.
 */
export type Found = Float64Array;
/** A `Found` of zeros. */
export const createFound = (): Found => new Float64Array(4);
/** Indices into `Found`. */
export const T0 = 0;
export const T1 = 1;
export const VERDICT = 2;
export const STAGE = 3;
const STAGES: readonly DecidedBy[] = ['filter', 'double-double', 'exact'];
/** The stage that decided, from `found[STAGE]`. */
export const stageFound = (found: Found): DecidedBy => STAGES[found[STAGE] as number] ?? 'exact';

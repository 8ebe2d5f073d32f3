import type { MeasuredRow } from '../../lab/session.ts';
import { formatOf } from '../../lab/steps.ts';
import type { Target } from '../../math/batch.ts';
import { findMethod } from '../../math/shapes.ts';
import { TARGETS } from './settings.ts';

/** The methods in one target, each compared with the textbook in the same. */
export interface Column {
  readonly target: Target;
  readonly rows: readonly MeasuredRow[];
  /** Whether the prices are those of typical rays where the page was built. */
  readonly isFaint: boolean;
  /** Why the target is not the one asked for, as a sentence; '' if it is. */
  readonly why: string;
}

export const targetTitle = (target: Target): string =>
  TARGETS.find(({ id }) => id === target)?.title ?? target;

/**
 * Whether the method's float32 is emulated: TypeScript computes in 53 bits and rounds each result
 * to 24.
 */
export function isEmulated(id: string, target: Target): boolean {
  const method = findMethod(id);
  return target === 'typescript' && method !== undefined && formatOf(method) === 'float32';
}

/** The rows that are not emulated: only their prices can be compared. */
export const comparable = ({ rows, target }: Pick<Column, 'rows' | 'target'>) =>
  rows.filter(({ id }) => !isEmulated(id, target));

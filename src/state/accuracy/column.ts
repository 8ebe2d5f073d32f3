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
  /** Why it is not the target that was asked for, as a sentence; '' if it is. */
  readonly why: string;
}

export const targetTitle = (target: Target): string =>
  TARGETS.find(({ id }) => id === target)?.title ?? target;

/** JavaScript has no numbers of 24 bits: each operation is one of 53, rounded once more. */
export function isEmulated(id: string, target: Target): boolean {
  const method = findMethod(id);
  return target === 'typescript' && method !== undefined && formatOf(method) === 'float32';
}

/** The methods whose arithmetic the target has: those whose prices compare. */
export const comparable = ({ rows, target }: Pick<Column, 'rows' | 'target'>) =>
  rows.filter(({ id }) => !isEmulated(id, target));

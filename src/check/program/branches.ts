import { intersect } from '../../math/index.ts';
import { type CurvedDetails, definitionOf } from '../../math/shapes.ts';
import { courseOf } from '../course.ts';
import { findMisconception } from '../misconceptions/index.ts';
import type { Input } from '../types.ts';
import { roughWork } from '../work.ts';
import type { GroupId } from './cases.ts';
import { isOnBorder } from './flaws.ts';

/**
 * What a program usually has code of its own for, ordinary cases first. A case is in the last one
 * that it belongs to, by exact signs.
 */
export const CASE_BRANCHES = [
  { id: 'two', title: 'two roots in front of E (D > 0)' },
  { id: 'meets', title: 'meets the figure in front of E' },
  { id: 'none', title: 'no root (D < 0)' },
  { id: 'beside', title: 'passes the figure' },
  { id: 'behind', title: 'a root behind E (t < 0)' },
  { id: 'nappe', title: 'a root on the lower nappe' },
  { id: 'tangent', title: 'touches (D = 0)' },
  { id: 'border', title: 'on a rim or an edge' },
  { id: 'linear', title: 'A = 0' },
  { id: 'parallel', title: 'N·d = 0' },
  { id: 'degenerate', title: 'a length or slope of 0' },
  { id: 'hard', title: 'hard: decided by rounding' },
  { id: 'invalid', title: 'invalid input' },
] as const;

export type BranchId = (typeof CASE_BRANCHES)[number]['id'];

/** The branch of a valid input, or that of its group. */
export function caseBranch(input: Input, group: GroupId): BranchId {
  if (group === 'invalid' || group === 'hard') return group;
  const { shape, ray } = input;
  const numbers = shape as unknown as Readonly<Record<string, unknown>>;
  if (definitionOf(shape).params.some(({ key }) => numbers[key] === 0)) return 'degenerate';
  const { class: verdict, hits, details } = intersect(shape, ray, 'exact');
  const behind = hits.some(({ t }) => t < 0);
  if (details.family === 'flat') {
    if (details.rate === 0) return 'parallel';
    const t = details.plane?.t ?? Number.NaN;
    const about = { input, found: roughWork(courseOf(shape), input) };
    if (isOnBorder(about, t)) return 'border';
    return verdict === 'none' ? 'beside' : behind ? 'behind' : 'meets';
  }
  if ((details as CurvedDetails).signs.A === 0) return 'linear';
  if (verdict === 'tangent') return 'tangent';
  if (verdict === 'none') return 'none';
  const upper = findMisconception('one-nappe')?.edit(courseOf(shape));
  if (upper && roughWork(upper, input).case !== verdict) return 'nappe';
  return behind ? 'behind' : 'two';
}

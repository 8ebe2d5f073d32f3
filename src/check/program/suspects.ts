import { type Course, courseOf } from '../course.ts';
import type { Misconception } from '../misconceptions/define.ts';
import { MISCONCEPTIONS } from '../misconceptions/index.ts';
import type { Answers } from '../types.ts';
import { roughWork } from '../work.ts';
import type { Case } from './cases.ts';
import { type Output, sameDirection } from './judge.ts';

export interface Finding {
  readonly misconception: Misconception;
  /** Of the cases on which it shows, so many came out just as it says. */
  readonly agrees: number;
  readonly of: number;
}

/** Enough cases to tell, and nearly all of them alike: a program is one formula, not a mixture. */
const LEAST = 3;
const SHARE = 0.9;

interface Lists {
  readonly t: readonly number[];
  readonly normal: readonly (readonly number[])[];
}

/**
 * The misconceptions that the program's own values show: on the cases where the edited formulas differ from the right
 * ones, in doubles both, the program returns what the edited ones do.
 */
export function findings(cases: readonly Case[], outputs: readonly Output[]): Finding[] {
  const usable = cases.flatMap((one, i) => {
    const output = outputs[i];
    if (!one.expected || output?.type !== 'value') return [];
    return [{ one, output, right: listsOf(roughWork(courseOf(one.shape), one)) }];
  });
  // No root at all fits whatever leaves no roots; it is no sign of anything.
  if (usable.every(({ output }) => output.t.length === 0)) return [];
  const found = MISCONCEPTIONS.flatMap((misconception): Finding[] => {
    const editedOf = onceFor(misconception);
    let agrees = 0;
    let of = 0;
    for (const { one, output, right } of usable) {
      const edited = editedOf(courseOf(one.shape));
      if (!edited) continue;
      // Most are out of the question after a few cases.
      if (of >= ENOUGH && agrees < of / 2) break;
      const withEdit = listsOf(roughWork(edited, one));
      const withNormals = output.normal !== null;
      if (same(withEdit, right, withNormals)) continue;
      of++;
      if (same(withEdit, { t: output.t, normal: output.normal ?? [] }, withNormals)) agrees++;
    }
    return agrees >= LEAST && agrees >= SHARE * of ? [{ misconception, agrees, of }] : [];
  });
  return found.sort((a, b) => b.agrees - a.agrees);
}

/** Cases on which an edit shows, after which a half that does not agree rules it out. */
const ENOUGH = 8;

/** The edit of each course, made once. */
function onceFor({ edit }: Misconception): (course: Course) => Course | null {
  const known = new Map<Course, Course | null>();
  return (course) => {
    const found = known.get(course);
    if (found !== undefined) return found;
    const edited = edit(course);
    known.set(course, edited);
    return edited;
  };
}

function listsOf(found: Answers): Lists {
  const ids = found.case === 'contained' || found.inside === 'outside' ? [] : ['1', '2'];
  return {
    t: ids.flatMap((i) => {
      const x = found[`t${i}`];
      return typeof x === 'number' ? [x] : [];
    }),
    normal: ids.flatMap((i) => {
      const n = found[`N${i}`];
      return typeof n === 'object' ? [n] : [];
    }),
  };
}

/** Two programs that do the same, each in its own order of operations. */
const ALIKE = 1e-6;

function same(a: Lists, b: Lists, withNormals: boolean): boolean {
  if (a.t.length !== b.t.length) return false;
  if (!a.t.every((x, i) => near(x, b.t[i] ?? Number.NaN))) return false;
  return !withNormals || a.normal.every((n, i) => sameDirection(b.normal[i] ?? [], n));
}

function near(x: number, y: number): boolean {
  if (!Number.isFinite(x) || !Number.isFinite(y)) return Number.isFinite(x) === Number.isFinite(y);
  return Math.abs(x - y) <= ALIKE * Math.max(Math.abs(x), Math.abs(y));
}

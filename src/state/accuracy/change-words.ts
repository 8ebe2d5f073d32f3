import type { MethodRow, ThisRay } from '../../lab/this-ray.ts';
import { JUDGEMENTS } from '../../lab/verdict.ts';
import type { Verdict } from '../../math/index.ts';
import { displayAll } from '../../text/format.ts';
import { subscript } from '../../text/scripts.ts';

export const SAYS: Readonly<Record<Verdict, string>> = {
  two: 'two points',
  tangent: 'touches once',
  one: 'one point',
  none: 'no point',
  contained: 'lies in it',
  undecided: 'cannot decide',
};

type Rows = Pick<ThisRay, 'rows' | 'reference'>;

/**
 * Which verdicts another ray changes, method by method, and whether exact arithmetic's is among
 * them; '' if none.
 */
export function flips(before: Rows, after: Rows): string {
  const changed = after.rows.flatMap(({ method, found, judgement }, i) => {
    const was = before.rows[i]?.found.class;
    if (was === undefined || was === found.class) return [];
    return `${method.title}: ${SAYS[was]} → ${SAYS[found.class]} (${JUDGEMENTS[judgement]})`;
  });
  return changed.join('; ');
}

/** What moving an input has changed: verdicts; if none, the chosen method's roots. */
export function changeWords(before: Rows, after: Rows, chosen: string): string {
  const changed = flips(before, after);
  if (changed) return changed;
  const of = (rows: Rows): MethodRow | undefined =>
    rows.rows.find(({ method }) => method.id === chosen);
  const [was, is] = [of(before), of(after)];
  const roots = (is?.roots ?? []).flatMap(({ t, count }, i) => {
    const old = was?.roots[i];
    if (!old) return [];
    const letter = (is?.roots.length ?? 0) > 1 ? `t${subscript(i + 1)}` : 't';
    if (Object.is(old.t, t)) return [`${letter} stays`];
    return [`${letter} = ${displayAll(old.t)} → ${displayAll(t)} (${old.count} → ${count} digits)`];
  });
  const own = roots.length > 0 ? `; ${is?.method.title ?? chosen}: ${roots.join(', ')}` : '';
  return `no verdict changes${own}`;
}

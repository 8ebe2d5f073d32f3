import { type Hit, InvalidInput, intersect } from '../math/index.ts';
import { display } from '../text/format.ts';
import type { StartRule } from '../tracer/types.ts';
import type { ExploreModel } from './derive.ts';
import { readStartRule } from './picture/start-rule.ts';

/** The effect of the start rule on a ray that was opened from a picture. */
interface StartOutcome {
  /** Null for a rule that nobody can read. */
  readonly rule: StartRule['rule'] | null;
  /** t of the hit that the rule drops; null if it drops none. */
  readonly dropped: number | null;
  /** t of the first hit that counts in the picture; null for none. */
  readonly first: number | null;
  readonly words: string;
}

/** Null for a ray without a start rule. */
export function startOutcomeOf(model: ExploreModel): StartOutcome | null {
  const text = model.state.settings.explore.start;
  if (text === undefined) return null;
  try {
    return outcomeBy(readStartRule(text), model);
  } catch (error) {
    if (!(error instanceof InvalidInput)) throw error;
    return { rule: null, dropped: null, first: null, words: `start: ${error.message}` };
  }
}

function outcomeBy(start: StartRule, model: ExploreModel): StartOutcome {
  const { rule } = start;
  const hits = model.ended?.hits ?? model.found.hits;
  const there = hits.filter((hit) => !isCut(hit, model));
  const own = rule === 'from' ? startOf(model) : null;
  const counts = ({ t }: Hit): boolean =>
    rule === 'epsilon' ? t >= start.epsilon : t > 0 && t !== own;
  const near = there.find(({ t }) => rule === 'epsilon' && t > 0 && t < start.epsilon);
  const first = there.find(counts)?.t ?? null;
  const dropped = own ?? near?.t ?? null;
  const how = {
    from: `the ray starts on the ${model.title}, so the root nearest to 0 is dropped`,
    none: 'any t > 0 counts',
    epsilon: `only t ≥ ${rule === 'epsilon' ? display(start.epsilon) : ''} counts`,
  }[rule];
  const gone = dropped === null ? '' : `, t = ${display(dropped)}`;
  const left = first === null ? 'nothing is hit' : `first hit at t = ${display(first)}`;
  return { rule, dropped, first, words: `In the picture ${how}${gone}: ${left}.` };
}

/** The root where the ray starts, by the math module's rule of identity. */
function startOf({ shape, ray, found, ended }: ExploreModel): number | null {
  const solid = ended ? { ...shape, between: ended.between, caps: ended.caps } : shape;
  return intersect(solid, ray, found.method, { from: solid }).dropped?.t ?? null;
}

/** A flat shape is whole here, but not in a picture that keeps it between two heights. */
function isCut({ fate, point: [, y] }: Hit, { state: { between }, ended }: ExploreModel): boolean {
  if (ended || !between) return fate === 'cut';
  return y < between[0] || y > between[1];
}

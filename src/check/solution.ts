import type { Posed } from './compose.ts';
import { courseOf } from './course.ts';
import type { Argument } from './exercises/define.ts';
import { type DerivationLine, linesOf } from './lines.ts';
import { work } from './work.ts';

/** Words with lines of the derivation below: in symbols, or in numbers without results. */
interface Hint {
  readonly words: string;
  readonly lines: readonly DerivationLine[];
  readonly layer: 'symbols' | 'numbers';
}

const NO_ARGUMENT: Argument = { rule: '', put: '', decision: [] };

const argumentOf = ({ exercise, draft }: Posed): Argument =>
  exercise.argue?.(draft, work(courseOf(draft.shape), draft)) ?? NO_ARGUMENT;

/** Three hints: words, formulas in symbols, formulas in numbers; without the given lines. */
export function hintsOf(posed: Posed): readonly [Hint, Hint, Hint] {
  const { rule, put } = argumentOf(posed);
  const lines = linesAfterGiven(posed);
  // The last hint leaves the arithmetic to the student. It has no lines if a parameter is asked
  // for,
  // since they contain it.
  const open = posed.exercise.asksForParam ? [] : lines.map((line) => ({ ...line, values: [] }));
  return [
    { words: posed.exercise.clue, lines: [], layer: 'symbols' },
    { words: rule, lines, layer: 'symbols' },
    { words: put, lines: put ? [] : open, layer: 'numbers' },
  ];
}

/** The lines from what is given to what is asked, and the sentences before the answers. */
export const solutionOf = (
  posed: Posed,
): { readonly lines: readonly DerivationLine[]; readonly decision: readonly string[] } => ({
  lines: linesAfterGiven(posed),
  decision: argumentOf(posed).decision,
});

function linesAfterGiven({ exercise, draft, given, fields }: Posed): readonly DerivationLine[] {
  const all = linesOf(courseOf(draft.shape), draft);
  const isGiven = (id: string): boolean => given[id] !== undefined || given[`${id}1`] !== undefined;
  // The line P is needed only if it is asked whether the point is in a figure.
  const needless =
    fields.some(({ id }) => id === 'inside') || !exercise.lines.includes('inside') ? '' : 'P';
  return all.filter(({ id }) => exercise.lines.includes(id) && id !== needless && !isGiven(id));
}

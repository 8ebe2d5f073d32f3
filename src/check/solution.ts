import type { Posed } from './compose.ts';
import { courseOf } from './course.ts';
import type { Argument } from './exercises/define.ts';
import { type Line, linesOf } from './lines.ts';
import { work } from './work.ts';

/**
 * Words, and under them lines of the derivation: in symbols, or with the numbers put in and the
 * result left open.
 */
interface Hint {
  readonly words: string;
  readonly lines: readonly Line[];
  readonly layer: 'symbols' | 'numbers';
}

const NO_ARGUMENT: Argument = { rule: '', put: '', decision: [] };

const argumentOf = ({ exercise, draft }: Posed): Argument =>
  exercise.argue?.(draft, work(courseOf(draft.shape), draft)) ?? NO_ARGUMENT;

/** The words, the formula in symbols, the formula with numbers: all of them after what is given. */
export function hintsOf(posed: Posed): readonly [Hint, Hint, Hint] {
  const { rule, put } = argumentOf(posed);
  const lines = linesAfterGiven(posed);
  // The last hint puts the numbers in and leaves the arithmetic to the student; not a number that
  // is asked for.
  const open = posed.exercise.asksForParam ? [] : lines.map((line) => ({ ...line, values: [] }));
  return [
    { words: posed.exercise.clue, lines: [], layer: 'symbols' },
    { words: rule, lines, layer: 'symbols' },
    { words: put, lines: put ? [] : open, layer: 'numbers' },
  ];
}

/**
 * The lines that lead from what is given to what is asked, and why they decide it; the answers come
 * last.
 */
export const solutionOf = (
  posed: Posed,
): { readonly lines: readonly Line[]; readonly decision: readonly string[] } => ({
  lines: linesAfterGiven(posed),
  decision: argumentOf(posed).decision,
});

function linesAfterGiven({ exercise, draft, given, fields }: Posed): readonly Line[] {
  const all = linesOf(courseOf(draft.shape), draft);
  const isGiven = (id: string): boolean => given[id] !== undefined || given[`${id}1`] !== undefined;
  // A plane's point is only asked for where a figure ends.
  const needless =
    fields.some(({ id }) => id === 'inside') || !exercise.lines.includes('inside') ? '' : 'P';
  return all.filter(({ id }) => exercise.lines.includes(id) && id !== needless && !isGiven(id));
}

import { digitCount } from '../../lab/digits.ts';
import { grouped } from '../../lab/sentence.ts';
import type { Summary } from '../../lab/summary.ts';
import { type Failure, linesOf, type SweepPoint } from '../../lab/sweep.ts';
import type { Dial } from '../../math/families.ts';
import { display, MINUS } from '../../text/format.ts';
import { superscript } from '../../text/scripts.ts';
import { titleOf } from './frontier.ts';
import type { Worth } from './settings.ts';

const REASONS: Readonly<Record<Failure['reason'], string>> = {
  misses: 'loses hits',
  invents: 'invents hits',
  misnames: 'misnames hits',
  undecided: 'undecided',
};

/** The lines of a sweep as a plot shows them. */
export function hardnessOf(points: readonly SweepPoint[], dial: Dial, worth: Worth) {
  const digitsOf = (quality: Summary): number =>
    worth === 'worst' ? quality.leastDigits : quality.digits;
  const lines = linesOf(points).map(({ id, points: own, end, firstFailure }) => ({
    id,
    name: titleOf(id),
    points: own.map(({ difficulty, quality }) => ({
      difficulty,
      digits: digitsOf(quality),
      words: wordsOf(id, quality, tickOf(dial)(difficulty)),
    })),
    ...(end && {
      end: {
        difficulty: end.difficulty,
        reason: REASONS[end.reason],
        words: wordsOf(id, end.quality, tickOf(dial)(end.difficulty)),
      },
    }),
    ...(firstFailure && { first: { difficulty: firstFailure.difficulty } }),
  }));
  return {
    lines,
    range: dial.range,
    dialTitle: dialTitle(dial),
    digitsTitle:
      worth === 'worst' ? 'digits right, in the worst ray' : 'digits right, in 9 rays of 10',
    tick: tickOf(dial),
  };
}

/**
 * What a dial's rays have in common: “E is 10³ … 10⁹ radii away”.
 *
 * @param at value of the dial; null if the family draws it for each ray.
 */
export function dialWords(dial: Dial, at: number | null): string {
  const tick = tickOf(dial);
  const [from, to] = at === null ? dial.usual : [at, at];
  const range = from === to ? tick(from) : `${tick(from)} … ${tick(to)}`;
  const { title } = dial;
  return POWER.test(title) ? title.replace(POWER, range) : `${title}: ${range}`;
}

/** The dial's title with its power as a superscript. */
export const dialTitle = ({ title }: Dial): string => title.replace('^-k', '⁻ᵏ').replace('^k', 'ᵏ');

const POWER = /(\d+)\^(-?)k/;

/** Writes a dial value in the unit of its title: 10⁴, 2³ or 40 %. */
export function tickOf({ title }: Dial): (k: number) => string {
  const [, base, minus] = POWER.exec(title) ?? [];
  if (!base) return (k) => display(k, 3);
  return (k) => {
    const exponent = minus ? -k : k;
    if (exponent === 0) return '1';
    return Number.isInteger(exponent)
      ? `${base}${superscript(exponent)}`
      : `${base}^${display(exponent, 3).replace('-', MINUS)}`;
  };
}

function wordsOf(id: string, quality: Summary, at: string): string {
  const { judged, undecided, rays } = quality;
  const digits = Number.isNaN(quality.digits)
    ? 'no ray has a root'
    : `${digitCount(quality.digits)} digits right in 9 rays of 10, ` +
      `${digitCount(quality.leastDigits)} in the worst`;
  const failures = [
    ...(judged.misses > 0 ? [`${grouped(judged.misses)} lose a hit`] : []),
    ...(judged.invents > 0 ? [`${grouped(judged.invents)} see one that is not there`] : []),
    ...(judged.misnames > 0 ? [`${grouped(judged.misnames)} get the kind wrong`] : []),
    ...(undecided > 0 ? [`${grouped(undecided)} cannot tell`] : []),
  ];
  const verdicts =
    failures.length > 0
      ? `of ${grouped(rays)} rays ${failures.join(', ')}`
      : 'every verdict is right';
  return `${titleOf(id)} at ${at}: ${digits}; ${verdicts}`;
}

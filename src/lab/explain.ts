import { type Surd, toNumber } from '../math/exact.ts';
import type { Method } from '../math/shapes.ts';
import { display } from '../text/format.ts';
import { type Cause, inputsOf, size } from './causes.ts';
import { digitCount } from './digits.ts';
import type { Losses, StepLoss } from './losses.ts';
import { plainText } from './plain-text.ts';
import type { MethodRow } from './this-ray.ts';

/** The name of a step in a sentence: its letter and what it is. */
function nameOf(step: StepLoss): string {
  const letter = step.letter ? plainText(step.letter) : null;
  return letter === null || letter === step.text ? step.text : `${letter} = ${step.text}`;
}

/** Why the step lost its digits, in a sentence. */
export function whyLost(step: StepLoss): string {
  const name = nameOf(step);
  const left = digitCount(step.digits ?? 0);
  const rest =
    left === 0 ? 'no digit is left' : `${left} of 16 digits ${left === 1 ? 'is' : 'are'} left`;
  const { cause, exact } = step;
  const terms = inputsOf(step).map(({ expr, letter }) => plainText(letter ?? expr));
  switch (cause?.kind) {
    case 'input':
      return isOut(step)
        ? `${name} is out of the range of 32-bit numbers before anything is computed: ${rest}.`
        : `${name} is rounded before anything is computed: ${rest}.`;
    case 'division':
      return `${name}: the divisor may be 0, and ${rest}.`;
    case 'overflow':
      return `${within(name, cause)} is larger than the largest number there is: ${rest}.`;
    case 'underflow':
      return cause.flushed
        ? `${within(name, cause)} is smaller than the smallest number there is: ${rest}.`
        : `${within(name, cause)} is below the smallest number that has all its digits: ${rest}.`;
    case 'zero':
      return `${name} is exactly 0: what comes out is what was rounded off before.`;
    case 'total':
      return (
        `${name}: ${leading(terms)}, ${shown(exact)}, is no larger than what was rounded ` +
        `off before: ${rest}.`
      );
    case 'cancellation': {
      const [share, cancel] =
        cause.digits === 1
          ? ['first digit', 'cancels']
          : [`first ${cause.digits} digits`, 'cancel'];
      return (
        `${name}: the ${share} of ${listed(terms)} ${cancel}, and what was rounded behind ` +
        `them moves to the front; ${rest}.`
      );
    }
    default:
      return `${name}: ${rest}, ${display(step.lost, 2)} fewer than went in.`;
  }
}

/** An input that became 0 or an infinity. */
const isOut = ({ own }: StepLoss): boolean => own === 0 || !Number.isFinite(own);

const within = (name: string, cause: { readonly within: boolean }): string =>
  cause.within ? `${name}: a number on the way` : name;

/** Of two terms one can say that their digits agree; of more, only that they cancel. */
const leading = (terms: readonly string[]): string =>
  terms.length === 2
    ? `all leading digits of ${listed(terms)} agree; the difference`
    : `all leading digits of ${listed(terms)} cancel; the sum`;

const shown = (exact: Surd | null): string => (exact ? display(toNumber(size(exact)), 3) : '');

function listed(names: readonly string[]): string {
  return names.length < 2 ? names.join('') : `${names.slice(0, -1).join(', ')} and ${names.at(-1)}`;
}

/** The same in a few words, for the column "where digits go". */
export function whereLost({ method, found, judgement, digits }: MethodRow, losses: Losses): string {
  if (judgement === 'undecided') return undecidedBy(losses);
  if (judgement === 'right' && found.hits.length === 0) return 'no root, no digits';
  if (judgement === 'right' && (digits === null || digits >= 15.6)) return noneLost(method);
  const { worst } = losses;
  if (!worst) return judgement === 'right' ? 'a little at every step' : 'in the last comparison';
  if (worst.inputs.length === 0) return `the inputs: ${isOut(worst) ? 'out of range' : '24 bits'}`;
  const words = worst.cause && BRIEFLY[worst.cause.kind];
  return words ? `${shortName(worst)}: ${words}` : `in ${shortName(worst)}`;
}

const BRIEFLY: Readonly<Partial<Record<Cause['kind'], string>>> = {
  division: 'divided by what may be 0',
  overflow: 'overflow',
  underflow: 'underflow',
  zero: 'exactly 0, left are rounding errors',
  total: 'all digits cancel',
  cancellation: 'nearly equal numbers',
};

function noneLost(method: Method): string {
  if (method.proven === 'rounded') return 'none: correctly rounded';
  return method.proven ? 'none: at most 1 unit in the last place' : 'none here';
}

const LONGEST = 16;

/** Long formulas are known by their letter. */
function shortName(step: StepLoss): string {
  return step.letter && step.text.length > LONGEST ? plainText(step.letter) : step.text;
}

/** Words on the first sign that the method could not determine. */
function undecidedBy({ steps }: Losses): string {
  const overflow = steps.find(({ cause }) => cause?.kind === 'overflow');
  if (overflow) return `${shortName(overflow)} overflows`;
  const unknown = steps.filter(({ sign }) => Number.isNaN(sign));
  const decisive = unknown.find(({ letter }) => letter && 'id' in letter && letter.id === 'D');
  const open = decisive ?? unknown.at(-1);
  return open ? `${shortName(open)} may be < 0 or > 0` : 'a bound on every side';
}

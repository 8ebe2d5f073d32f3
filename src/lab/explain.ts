import type { Method } from '../math/methods/define.ts';
import { display } from '../text/format.ts';
import { digitCount } from './digits.ts';
import { inputsOf, type Losses, magnitude, type Step } from './losses.ts';
import { plainText } from './plain.ts';
import type { MethodRow } from './this-ray.ts';
import type { Operation } from './trace.ts';

/** How many of the leading digits a sum's terms share and so take away from each other. */
function cancelled(step: Operation): number {
  const largest = Math.max(...inputsOf(step).map(({ exact }) => magnitude(exact)));
  const left = magnitude(step.exact);
  return left > 0 ? Math.max(0, Math.log10(largest / left)) : Number.POSITIVE_INFINITY;
}

/** The name of a step in a sentence: its letter and what it is. */
function nameOf(step: Step): string {
  const letter = step.letter ? plainText(step.letter) : null;
  return letter === null || letter === step.text ? step.text : `${letter} = ${step.text}`;
}

const range = ({ own, exact, inputs }: Operation): 'overflow' | 'underflow' | null => {
  if (!Number.isFinite(own) && inputs.every((input) => Number.isFinite(input.own)))
    return 'overflow';
  return own === 0 && exact !== null && exact.u.m !== 0n && inputs.every((input) => input.own !== 0)
    ? 'underflow'
    : null;
};

/** Why the step lost its digits, in a sentence. */
export function whyLost(step: Step): string {
  const name = nameOf(step);
  const left = digitCount(step.digits ?? 0);
  const rest = left === 0 ? 'no digit is left' : `${left} of 16 digits are left`;
  if (step.inputs.length === 0) return `${name} is rounded before anything is computed: ${rest}.`;
  const beyond = range(step);
  if (beyond === 'overflow') return `${name} is larger than the largest number there is: ${rest}.`;
  if (beyond === 'underflow')
    return `${name} is smaller than the smallest number there is: ${rest}.`;
  if (step.expr.op === 'sum') {
    const gone = cancelled(step);
    const inputs = inputsOf(step).map(({ expr, letter }) => plainText(letter ?? expr));
    if (gone === Number.POSITIVE_INFINITY) {
      return `${name} is exactly 0: what comes out is the rounding of ${listed(inputs)}.`;
    }
    if (gone >= 1) {
      const share = Math.floor(gone) === 1 ? 'first digit' : `first ${Math.floor(gone)} digits`;
      return `${name}: the ${share} of ${listed(inputs)} cancel, and what was rounded behind them moves to the front; ${rest}.`;
    }
  }
  return `${name}: ${rest}, ${display(step.lost, 2)} fewer than went in.`;
}

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
  if (worst.inputs.length === 0) return 'the inputs: 24 bits';
  const beyond = range(worst);
  if (beyond) return `${shortName(worst)}: ${beyond}`;
  const equal = worst.expr.op === 'sum' && cancelled(worst) >= 1;
  return equal ? `${shortName(worst)}: nearly equal numbers` : `in ${shortName(worst)}`;
}

function noneLost(method: Method): string {
  if (method.id === 'exact') return 'none: correctly rounded';
  if (method.id === 'certified') return 'none: at most 1 unit in the last place';
  return 'none here';
}

const LONGEST = 16;

/** Long formulas are known by their letter. */
function shortName(step: Step): string {
  return step.letter && step.text.length > LONGEST ? plainText(step.letter) : step.text;
}

/** The sign that the method could not tell, the first of them. */
function undecidedBy({ steps }: Losses): string {
  const overflow = steps.find((step) => range(step) === 'overflow');
  if (overflow) return `${shortName(overflow)} overflows`;
  const unknown = steps.filter(({ sign }) => Number.isNaN(sign));
  const decisive = unknown.find(({ letter }) => letter && 'id' in letter && letter.id === 'D');
  const open = decisive ?? unknown.at(-1);
  return open ? `${shortName(open)} may be < 0 or > 0` : 'a bound on every side';
}

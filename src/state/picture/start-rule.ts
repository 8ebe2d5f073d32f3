import { InvalidInput } from '../../math/index.ts';
import { quote } from '../../math/shapes.ts';
import { display, shortest } from '../../text/format.ts';
import { parseNumber } from '../../text/parse.ts';
import type { StartRule } from '../../tracer/types.ts';

/** The start rules in the menu: the right one, none, and epsilons from too small to too large. */
export const START_TEXTS = ['from', 'none', '1e-15', '1e-9', '0.001', '0.3'] as const;

/** 'from', 'none', or an epsilon. */
export function readStartRule(text: string): StartRule {
  if (text === 'from') return { rule: 'from' };
  if (text === 'none') return { rule: 'none' };
  const parsed = parseNumber(text);
  if (!parsed.ok || !(parsed.value > 0)) {
    throw new InvalidInput(`${quote(text)} is not from, none or a positive number`);
  }
  return { rule: 'epsilon', epsilon: parsed.value };
}

export const startText = (start: StartRule): string =>
  start.rule === 'epsilon' ? shortest(start.epsilon).replace('e+', 'e') : start.rule;

/** Short words for a start rule, to stand beside a method's name. */
export function startWords(start: StartRule): string {
  if (start.rule === 'from') return 'start rule';
  return start.rule === 'none' ? 'no start rule' : `t ≥ ${display(start.epsilon, 3)}`;
}

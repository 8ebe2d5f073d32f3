import { definitionOf } from '../math/shapes.ts';
import { display } from '../text/format.ts';
import type { Posed } from './compose.ts';
import { withParam } from './exercises/params.ts';
import type { Answers, Input } from './types.ts';

/**
 * The input to draw before a question is solved. A parameter that is asked for has the student's
 * value, or without one the shape's initial value.
 */
export function drawnInput(
  { exercise, draft }: Posed,
  own: Answers,
): { readonly input: Input; readonly note: string } {
  const { param, shape, ray } = draft;
  if (!exercise.asksForParam || !param) return { input: draft, note: '' };
  const { symbol, key } = param;
  const initial = definitionOf(shape).params.find((one) => one.key === key)?.initial;
  const typed = own.value;
  const isOwn = typeof typed === 'number' && Number.isFinite(typed) && typed > 0;
  const value = isOwn ? typed : Number(initial);
  const note = isOwn
    ? `drawn with your ${symbol} = ${display(value)}`
    : `${symbol} is asked for: drawn with ${symbol} = ${display(value)} for now`;
  return { input: { shape: withParam(shape, param, value), ray }, note };
}

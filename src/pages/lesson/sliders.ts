import { html, nothing, type TemplateResult } from 'lit';
import { freedomOf } from '../../lesson/freedom.ts';
import type { Step } from '../../lesson/lesson.ts';
import type { AppState, Settings } from '../../state/state.ts';
import { shortest } from '../../text/format.ts';
import { parseNumber } from '../../text/parse.ts';
import type { HandIn } from './hand-in.ts';
import { type SliderMark, sliderView } from './slider-view.ts';

/** The sliders for a step's free number, and which handles can be dragged. */
export function slidersOf(
  step: Step,
  state: AppState,
  settings: Settings,
  isAsked: boolean,
  { inner, draft, change }: HandIn,
): {
  readonly view: () => TemplateResult | typeof nothing;
  readonly movable: (symbol: string) => boolean;
} {
  const { free, guess } = step;
  const all = free === null ? [] : (freedomOf(free, state) ?? []);
  if (all.length === 0) return { view: () => nothing, movable: () => false };
  // While a free number is asked for it is locked, since trying would give the answer.
  const locked = isAsked && guess?.type === 'free';
  const given = numberIn(locked ? draft() : settings.guess);
  const truth = guess?.type === 'free' && !locked ? guess.truth : null;
  const mark: SliderMark | null =
    guess?.type === 'free' && given !== null ? { at: given, truth } : null;
  return {
    view: () =>
      html`${all.map((freedom) => {
        const now = freedom.valueIn(state);
        return sliderView({
          freedom,
          value: locked ? (given ?? now) : now,
          mark,
          guessing: locked,
          send(value) {
            if (locked) change(shortest(value));
            else if (freedom.allows(value, state)) inner(freedom.action(value));
          },
        });
      })}`,
    // A handle of the scene moves all three numbers of a vector.
    movable: (symbol) => !locked && symbol === free,
  };
}

function numberIn(text: string | undefined): number | null {
  if (text === undefined) return null;
  const parsed = parseNumber(text);
  return parsed.ok ? parsed.value : null;
}

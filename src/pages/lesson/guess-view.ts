import { html, nothing, type TemplateResult } from 'lit';
import type { Guess, Step } from '../../lesson/lesson.ts';
import { quantityOf } from '../../lesson/quantities.ts';
import type { Verdict } from '../../math/index.ts';
import type { ExploreModel } from '../../state/derive.ts';
import { display } from '../../text/format.ts';
import { parseNumber } from '../../text/parse.ts';
import { type ProseTools, proseView, spokenName } from './prose-view.ts';

/** The classes in the words of the page. */
const CLASS_WORDS: Readonly<Partial<Record<Verdict, string>>> = {
  two: 'two points',
  tangent: 'one double root',
  one: 'one point',
  none: 'no point',
  contained: 'all of it',
};

export interface GuessTools {
  /** What is written in the box, or chosen, and not yet handed in. */
  readonly draft: string;
  readonly change: (text: string) => void;
  readonly hand: (text: string) => void;
  readonly show: () => void;
}

/** What is asked, with a box or the choices, while nobody has answered. */
export function questionView(
  step: Step,
  guess: Guess,
  prose: ProseTools,
  { draft, change, hand, show }: GuessTools,
): TemplateResult {
  const name = guessName(step, guess);
  const refused = draft !== '' && guess.type !== 'class' && !parseNumber(draft).ok;
  const submit = (event: Event): void => {
    event.preventDefault();
    if (draft !== '' && !refused) hand(draft);
  };
  return html`<form class="lesson-question" aria-label="Question" @submit=${submit}>
    <div class="asked">${proseView(step.question, prose)}</div>
    <div class="answering">
      ${
        guess.type === 'class'
          ? choices(draft, change)
          : html`<label>${spokenName(name)} = <input
              class="guess-box"
              inputmode="text"
              autocomplete="off"
              .value=${draft}
              aria-invalid=${refused}
              @input=${(event: Event) => change((event.target as HTMLInputElement).value)}
            /></label>`
      }
      <button type="submit" class="primary"
        aria-disabled=${draft === '' || refused}>That is my guess</button>
      <button type="button" class="show-me" @click=${show}>show me</button>
    </div>
    ${refused ? html`<p class="guess-refused" role="alert">${reason(draft)}</p>` : nothing}
  </form>`;
}

function reason(text: string): string {
  const parsed = parseNumber(text);
  return parsed.ok ? '' : parsed.reason;
}

function choices(draft: string, change: (text: string) => void): TemplateResult {
  return html`<fieldset class="guess-classes"><legend class="visually-hidden">Your guess</legend>
    ${Object.entries(CLASS_WORDS).map(
      ([id, words]) =>
        html`<label><input type="radio" name="lesson-class"
          value=${id}
          .checked=${draft === id}
          @change=${() => change(id)} />${words}</label>`,
    )}
  </fieldset>`;
}

const guessName = ({ free }: Step, guess: Guess): string =>
  guess.type === 'free' ? (free ?? '') : guess.type === 'quantity' ? guess.quantity : 'class';

/** The truth of a question; null where it has none, as t2 of a tangent. */
function truthOf(guess: Guess, model: ExploreModel): number | string | null {
  if (guess.type === 'free') return guess.truth;
  return guess.type === 'class' ? model.found.class : quantityOf(model, guess.quantity);
}

/** How far a guess was off and which way, in words. */
function guessWords(given: string, truth: number | string | null): string {
  if (typeof truth === 'string') {
    const said = CLASS_WORDS[given as Verdict] ?? given;
    return given === truth
      ? `Your guess, ${said}: right`
      : `Your guess, ${said}: it is ${CLASS_WORDS[truth as Verdict] ?? truth}`;
  }
  const parsed = parseNumber(given);
  if (!parsed.ok || truth === null) return `Your guess: ${given}`;
  const off = parsed.value - truth;
  // Six digits are what the page shows, so whoever gives them is right.
  if (off === 0 || display(parsed.value) === display(truth)) {
    return `Your guess ${display(parsed.value)}: right`;
  }
  const way = off < 0 ? 'too small' : 'too large';
  return `Your guess ${display(parsed.value)}: ${way} by ${display(Math.abs(off), 3)}`;
}

/** After it has been answered or shown. */
export function answerView(
  step: Step,
  guess: Guess,
  given: string | undefined,
  model: ExploreModel | null,
  prose: ProseTools,
): TemplateResult {
  const words =
    given === undefined || !model ? 'The answer' : guessWords(given, truthOf(guess, model));
  return html`<section class="lesson-answer" aria-label="Answer">
    <h3>${words}</h3>
    ${proseView(step.answer, prose)}
  </section>`;
}

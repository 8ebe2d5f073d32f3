import { html, nothing, type TemplateResult } from 'lit';
import { CLASS_WORDS, judgeGuess, type Seen, whyNoGuess } from '../../lesson/judge.ts';
import type { Guess, Step } from '../../lesson/lesson.ts';
import { namedCauses, whereAndWhat } from '../../panels/check-feedback.ts';
import { questionOf } from '../../state/predictions.ts';
import { spokenName } from '../../text/spoken.ts';
import { type ProseTools, proseView } from './prose-view.ts';

export interface GuessTools {
  /** The text or choice that is not handed in yet, as drawn. */
  readonly draft: string;
  /** The draft at the time of handing in, which may be newer than the drawn one. */
  readonly now: () => string;
  readonly change: (text: string) => void;
  readonly hand: (text: string) => void;
  readonly show: () => void;
}

/** The question with a box or choices, before it is answered. */
export function questionView(
  step: Step,
  guess: Guess,
  prose: ProseTools,
  { draft, now, change, hand, show }: GuessTools,
): TemplateResult {
  if (guess.type === 'open') {
    return html`<section class="lesson-question" aria-label="Question">
      <div class="asked">${proseView(step.question, prose)}</div>
      <div class="answering">
        <button type="button" class="show-me" @click=${show}>show the answer</button></div>
    </section>`;
  }
  const whyNot = (text: string): string | null => whyNoGuess(text, guess, prose.model);
  const refused = draft === '' ? null : whyNot(draft);
  const isOpen = draft === '' || refused !== null;
  const submit = (event: Event): void => {
    event.preventDefault();
    const given = now();
    if (given !== '' && whyNot(given) === null) hand(given);
  };
  return html`<form class="lesson-question" aria-label="Question" @submit=${submit}>
    <div class="asked">${proseView(step.question, prose)}</div>
    ${
      guess.type === 'free'
        ? html`<p class="how">Put the mark <svg class="how-mark" width="16" height="14"
          viewBox="-8 -2 16 14" role="img" aria-label="triangle"><path class="mark"
          d="M0 0L6 10H-6Z" /></svg> on the slider, or write a number.</p>`
        : nothing
    }
    ${
      prose.model ? nothing : html`<p class="how">What is shown beside it is hidden until then.</p>`
    }
    <div class="answering">
      ${
        guess.type === 'class' || guess.type === 'prediction'
          ? choices(optionsOf(guess), draft, change)
          : html`<label>${nameOf(step, guess)} = <input
              class="guess-box"
              inputmode="text"
              autocomplete="off"
              .value=${draft}
              aria-invalid=${refused !== null}
              @input=${(event: Event) => change((event.target as HTMLInputElement).value)}
            /></label>`
      }
      <button type="submit" class="primary"
        aria-disabled=${isOpen}>That is my guess</button>
      <button type="button" class="show-me" @click=${show}>show me</button>
    </div>
    ${refused ? html`<p class="guess-refused" data-say="problem">${refused}</p>` : nothing}
  </form>`;
}

type Option = readonly [id: string, words: string];

const optionsOf = (guess: Guess): readonly Option[] =>
  guess.type === 'prediction'
    ? questionOf(guess.ask, true).options.map(({ id, title }) => [id, title])
    : Object.entries(CLASS_WORDS);

function choices(
  options: readonly Option[],
  draft: string,
  change: (text: string) => void,
): TemplateResult {
  return html`<fieldset class="guess-classes"><legend class="visually-hidden">Your guess</legend>
    ${options.map(
      ([id, words]) =>
        html`<label><input type="radio" name="lesson-class"
          value=${id}
          .checked=${draft === id}
          @change=${() => change(id)} />${words}</label>`,
    )}
  </fieldset>`;
}

/** The name of the asked quantity; a number in a table's row has no letter of its own. */
function nameOf({ free }: Step, guess: Guess): string {
  if (guess.type === 'free') return free ?? '';
  if (!('quantity' in guess)) return 'your guess';
  const isLetter = /^[A-Za-z]\d?(\.[xyz])?$/.test(guess.quantity);
  return isLetter ? spokenName(guess.quantity) : 'your guess';
}

/** The answer, after it was handed in or shown. */
export function answerView(
  step: Step,
  guess: Guess,
  given: string | undefined,
  seen: Seen,
  prose: ProseTools,
): TemplateResult {
  const judged = given === undefined ? null : judgeGuess(guess, given, seen);
  const causes = judged?.causes ?? [];
  return html`<section class="lesson-answer" aria-label="Answer">
    <h3>${judged?.words ?? 'The answer'}</h3>
    ${causes.length > 0 ? html`<p class="why">${namedCauses(causes)}</p>` : nothing}
    ${causes.map((cause) => html`<p class="why">${whereAndWhat(cause, causes.length > 1)}</p>`)}
    ${proseView(step.answer, prose)}
  </section>`;
}

import { html, nothing, type TemplateResult } from 'lit';
import type { Step } from '../../lesson/lesson.ts';
import { innerState, isAsked, isHidden } from '../../lesson/step-state.ts';
import { announcement } from '../../state/announce.ts';
import { createDerive, type FullModel } from '../../state/derive.ts';
import { answerShown } from '../../state/example.ts';
import { exploreDetails } from '../../state/explore-details.ts';
import { lineCount, shownLines } from '../../state/reveal.ts';
import { type AppState, INITIAL, type Settings, stepShown } from '../../state/state.ts';
import { update } from '../../state/update.ts';
import { decode } from '../../state/url.ts';
import { hitSentences } from '../../state/verdict-words.ts';
import { display } from '../../text/format.ts';
import { subscript } from '../../text/scripts.ts';
import { spokenName } from '../../text/spoken.ts';
import { next } from '../commands.ts';
import type { LessonStep } from './lesson-step.ts';
import type { Projected } from './presenter-channel.ts';
import { exploreValue } from './prose-tools.ts';
import { type ProseTools, proseView } from './prose-view.ts';

/** What the presenter's window shows of a step or of Explore. */
export interface PresenterParts {
  readonly of: string;
  readonly title: string;
  readonly text: TemplateResult | typeof nothing;
  /** Beside the text: the notes, or the values of Explore. */
  readonly aside: { readonly name: string; readonly content: TemplateResult };
  /** What the next press of the clicker shows. */
  readonly next: string;
  /** What Explore shows after the next one; null for none, and for another page. */
  readonly drawn: AppState | null;
}

const ofStep = createDerive(() => exploreDetails);
const ofStage = createDerive(() => exploreDetails);
const ofNext = createDerive(() => exploreDetails);

/** A step with its answer and notes; `numbers` are those of another page than Explore. */
export function stepParts(
  settings: Settings,
  { lesson, number, step }: LessonStep,
  numbers: Projected['numbers'],
): PresenterParts {
  const following = lesson.steps[number];
  const inner = innerState(step, { ...settings, shown: '1' });
  const model = inner.page === 'explore' ? ofStep(inner) : null;
  const tools: ProseTools = {
    model,
    slider: () => nothing,
    isHidden: () => false,
    room: (_, digits) => digits,
    value: (name) => (model ? exploreValue(model, name) : (numbers[name] ?? null)),
  };
  const answer = html`<h3>Question</h3>${proseView(step.question, tools)}
    <h3>Answer</h3>${proseView(step.answer, tools)}`;
  const notes =
    step.notes.length > 0 ? proseView(step.notes, tools) : html`<p>None for this step.</p>`;
  const state = following && innerState(following, {});
  return {
    of: lesson.title,
    title: `${number} of ${lesson.steps.length}: ${step.title}`,
    text: html`${proseView(step.text, tools)}${step.guess ? answer : nothing}`,
    aside: { name: 'Notes', content: notes },
    next: afterStep(settings, step, following),
    drawn: state?.page === 'explore' ? state : null,
  };
}

function afterStep(settings: Settings, step: Step, following: Step | undefined): string {
  const after = following ? following.title : 'nothing, this is the last step';
  if (isAsked(step, settings)) return `the answer, then ${after}`;
  return isHidden(step, settings) ? `the results, then ${after}` : after;
}

/** Explore: the example's question and answer, and every value, also those not revealed yet. */
export function exploreParts({ hash, look }: Projected): PresenterParts {
  const state: AppState = { ...decode(hash, INITIAL), ...look };
  const model = ofStage({ ...state, revealed: null });
  const { example, title } = model;
  const asked = example?.changed === false ? example.entry : null;
  const after = afterNext(state, model);
  const drawn = { ...after, revealed: null };
  const told = ofNext(drawn);
  const isOther = told.example?.entry !== example?.entry;
  return {
    of: 'Explore',
    title: example
      ? `Example ${example.number} of ${example.of}: ${titled(model)}`
      : `A ray and a shape of your own: ${title}`,
    text: asked
      ? html`<h3>Question</h3><p>${asked.asks}</p>
          <h3>Answer${state.told ? '' : notYet}</h3><p>${asked.answer}</p>`
      : html`<p>No question: this is not an example as it came.</p>`,
    aside: { name: 'Values', content: values(model, state.revealed) },
    next:
      isOther && told.example
        ? `example ${told.example.number} of ${told.example.of}: ${told.example.entry.title}`
        : nextWords(state, after),
    drawn: isOther ? drawn : null,
  };
}

const titled = ({ example }: FullModel): string =>
  example ? `${example.entry.title}${example.changed ? ', changed' : ''}` : '';

const notYet = ', not shown yet';

function values(model: FullModel, revealed: number | null): TemplateResult {
  const { derivation, verdict, hits } = model;
  const shown = shownLines(model, revealed);
  const line = (words: string, isShown: boolean): TemplateResult =>
    html`<li class=${isShown ? 'shown' : 'to-come'}>${words}${isShown ? '' : notYet}</li>`;
  return html`<ul class="presenter-lines">
    ${derivation.steps.map(({ id, value }, i) =>
      line(
        value === null ? `the line of ${spokenName(id)}` : `${spokenName(id)} = ${display(value)}`,
        i < shown.steps,
      ),
    )}
    ${derivation.conditions.map(({ holds }, i) => {
      const how = holds === null ? 'cannot be told' : holds ? 'holds' : 'fails';
      return line(`condition ${i + 1} ${how}`, shown.conditions);
    })}
    ${line(verdict.text, shown.verdict)}
    ${hitSentences(hits).map((words) => line(words, shown.hits))}
    ${hits.map(({ index }, i) => {
      const point = model.found.hits[i]?.point;
      return point
        ? line(`P${subscript(index)} = (${point.map((x) => display(x)).join(', ')})`, shown.hits)
        : nothing;
    })}
  </ul>`;
}

/** The state after the next press of the clicker, by the command itself. */
function afterNext(state: AppState, model: FullModel): AppState {
  let now = state;
  const total = lineCount(model);
  next(
    {
      get: () => now,
      dispatch(action) {
        now = update(now, action);
      },
    },
    {
      lines: () => ({ total, shown: now.revealed ?? total }),
      answer: () => answerShown(now),
    },
  );
  return now;
}

/** What the next press shows where the example stays the same. */
function nextWords(before: AppState, after: AppState): string {
  if (before.derive) {
    const step = stepShown(after);
    return step === stepShown(before)
      ? 'nothing, this is the last step of the derivation'
      : `step ${step} of the derivation`;
  }
  if (after.told && !before.told) return 'the answer';
  return announcement(ofNext(before), ofNext(after)) || 'nothing more';
}

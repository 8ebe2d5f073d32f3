import { freedomOf } from '../../lesson/freedom.ts';
import type { Step } from '../../lesson/lesson.ts';
import {
  isHidden as areHidden,
  changesOf,
  innerState,
  isAsked,
  toStep,
} from '../../lesson/step-state.ts';
import type { Action, Changes, Dispatch } from '../../state/actions.ts';
import type { Settings } from '../../state/state.ts';
import { update } from '../../state/update.ts';
import { decode } from '../../state/url.ts';
import type { GuessTools } from './guess-view.ts';
import { lessonStepOf } from './lesson-step.ts';

export interface HandIn {
  /** Dispatch for the page that the step shows. */
  readonly inner: Dispatch;
  /** The guess as it is now, before it is handed in. */
  readonly draft: () => string;
  readonly change: (text: string) => void;
  tools(step: Step): GuessTools;
  /** Shows hidden results or the answer. */
  readonly reveal: () => void;
  /** A clicker's key: forward shows the answer or hidden results first, back hides them again. */
  readonly turn: (by: 1 | -1) => void;
  /** The settings of a step once its question has been answered. */
  readonly answered: (now: Settings) => Settings;
  /** Clears the draft, for another step. */
  readonly clear: () => void;
}

/** Changes a step's state and its guess as settings of the lesson, in one action. */
export function createHandIn(dispatch: Dispatch, changed: () => void): HandIn {
  let draft = '';
  const change = (text: string): void => {
    draft = text;
    changed();
  };
  const inner: Dispatch = (action) => {
    if (leads(action)) dispatch(action);
    else dispatch({ type: 'settings', values: (now) => moved(now, action) });
  };
  /** Settings that show the answer; a free number that was asked for gets its true value. */
  const answer = (more: Changes) => (now: Settings) => {
    const step = lessonStepOf(now)?.step;
    const free = step?.free;
    if (step?.guess?.type !== 'free' || !free) return more;
    const [freedom] = freedomOf(free, decode(step.link)) ?? [];
    return { ...(freedom ? moved(now, freedom.action(step.guess.truth)) : {}), ...more };
  };
  const settle = (more: Changes): void => {
    dispatch({ type: 'settings', values: answer(more) });
  };
  const restart = (now: Settings): Changes => {
    const kept = ['id', 'file', 'step'];
    const rest = Object.keys(now).filter((key) => !kept.includes(key));
    return Object.fromEntries(rest.map((key) => [key, null]));
  };
  const turned =
    (by: 1 | -1) =>
    (now: Settings): Changes => {
      const place = lessonStepOf(now);
      if (!place) return {};
      const { lesson, number, step } = place;
      if (by === 1 && (isAsked(step, now) || areHidden(step, now))) {
        return answer({ shown: '1' })(now);
      }
      if (by === -1 && (now.shown ?? now.guess) !== undefined) return restart(now);
      const to = number + by;
      return to < 1 || to > lesson.steps.length ? {} : toStep(to)(now);
    };
  return {
    inner,
    draft: () => draft,
    turn: (by) => dispatch({ type: 'settings', values: turned(by) }),
    change,
    tools: () => ({
      draft,
      now: () => draft,
      change,
      hand: (text) => settle({ guess: text }),
      show: () => settle({ shown: '1' }),
    }),
    reveal: () => settle({ shown: '1' }),
    answered: (now) => {
      const all = Object.entries({ ...now, ...answer({ shown: '1' })(now) });
      return Object.fromEntries(all.flatMap(([key, value]) => (value ? [[key, value]] : [])));
    },
    clear() {
      draft = '';
    },
  };
}

/** Whether an action opens another page, which leaves the lesson. */
const leads = (action: Action): boolean => action.type === 'link' || action.type === 'page';

function moved(now: Settings, action: Action): Changes {
  const step = lessonStepOf(now)?.step;
  return step ? changesOf(step, update(innerState(step, now), action), now) : {};
}

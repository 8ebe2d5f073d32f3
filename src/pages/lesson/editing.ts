import type { TemplateResult } from 'lit';
import { OWN } from '../../lesson/lesson.ts';
import { readLesson } from '../../lesson/read.ts';
import { withSteps } from '../../lesson/write.ts';
import type { Dispatch } from '../../state/actions.ts';
import { editView } from './edit-view.ts';
import type { LessonStep } from './lesson-step.ts';
import { ownSettings } from './own-lesson.ts';

/** Editing of a step. Editing a lesson that comes with Graze makes an own lesson of it. */
export function createEditing(dispatch: Dispatch, changed: () => void) {
  let draft: { text: string; title: string } | null = null;

  const cancel = (): void => {
    draft = null;
  };
  const put = ({ lesson }: LessonStep, sources: readonly string[], number: number): void => {
    const title = draft?.title.trim() || lesson.title;
    cancel();
    const text = withSteps({ ...lesson, title: title.replaceAll('\n', ' ') }, sources);
    const settings = ownSettings(text, Math.min(Math.max(number, 1), sources.length));
    dispatch({
      type: 'settings',
      values: (now) => ({
        ...Object.fromEntries(Object.keys(now).map((key) => [key, null])),
        ...settings,
      }),
    });
    dispatch({ type: 'say', problems: readLesson(text, OWN).problems });
  };
  const sourcesOf = (place: LessonStep): string[] =>
    place.lesson.steps.map(({ source }, i) =>
      i === place.number - 1 ? (draft?.text ?? source).trim() : source,
    );
  /** Swaps the step with the one before or after. */
  const move = (place: LessonStep, by: 1 | -1): void => {
    const sources = sourcesOf(place);
    const at = place.number - 1;
    const [from, to] = [sources[at], sources[at + by]];
    if (from === undefined || to === undefined) return;
    sources[at] = to;
    sources[at + by] = from;
    put(place, sources, place.number + by);
  };

  return {
    begin({ step, lesson }: LessonStep): void {
      draft = { text: step.source, title: lesson.title };
      changed();
    },
    cancel,
    /** The form in place of the text; null while nothing is edited. */
    view(place: LessonStep): TemplateResult | null {
      if (!draft) return null;
      const now = draft;
      return editView({
        ...now,
        isFirst: place.number === 1,
        isLast: place.number === place.lesson.steps.length,
        change: (text) => {
          now.text = text;
        },
        changeTitle: (title) => {
          now.title = title;
        },
        done: () => put(place, sourcesOf(place), place.number),
        cancel() {
          cancel();
          changed();
        },
        remove() {
          const sources = sourcesOf(place);
          if (sources.length > 1) put(place, sources.toSpliced(place.number - 1, 1), place.number);
        },
        earlier: () => move(place, -1),
        later: () => move(place, 1),
      });
    },
  };
}

import type { TemplateResult } from 'lit';
import type { Posed } from '../../check/compose.ts';
import type { Judged } from '../../check/judge.ts';
import type { Progress } from '../../check/progress.ts';
import type { View } from '../../state/camera-view.ts';
import type { AppState } from '../../state/state.ts';
import { lazyScene } from '../lazy-scene.ts';
import type { PageContext } from '../page.ts';
import type { CheckStorage } from './check-storage.ts';
import type { QuestionSceneInput } from './question-scene.ts';
import { createQuestionScene } from './question-scene.ts';
import type { CheckSettings } from './settings.ts';

/** The session of a package's set, whose answers go to a course system. */
export interface CourseSession {
  /** Whether this session is the one that is reported. */
  isOf(progress: Progress): boolean;
  /** A judged answer. */
  answered(posed: Posed, index: number, progress: Progress, judged: Judged): void;
  /** Something else of the session; at once, or with the next report. */
  changed(progress: Progress, index: number, now: boolean): void;
  box(progress: Progress): TemplateResult;
}

/** What every part of the page is created with. */
export interface PartContext extends PageContext {
  readonly storage: CheckStorage;
  /** Writes settings into the link. */
  readonly set: (wanted: Partial<CheckSettings>) => void;
  /** The session that is reported, in a package for a course system; null elsewhere. */
  readonly course: () => CourseSession | null;
}

/**
 * A part of the left side: renders the areas above and below the picture, and says what to draw;
 * null for no scene.
 */
export interface LeftPart {
  render(
    head: HTMLElement,
    body: HTMLElement,
    state: AppState,
    settings: CheckSettings,
  ): QuestionPicture | null;
}

/** A part that takes the whole width, for lecturers: making sets, marking classes. */
export interface WidePart {
  render(host: HTMLElement, settings: CheckSettings): void;
  /** Takes a file that was dropped on the page; false if the part has no use for it. */
  open?(text: string): boolean;
  /** The page is left. */
  rest?(): void;
}

export type QuestionPicture = Omit<QuestionSceneInput, 'view'>;

export function element(className: string, into: Element): HTMLElement {
  const made = document.createElement('div');
  made.className = className;
  into.append(made);
  return made;
}

/**
 * A scene that can be turned, with a view of its own. Its code is loaded when it is first shown.
 */
export function turnablePicture(
  host: HTMLElement,
  changed: () => void,
): { render(shown: QuestionPicture): void } {
  const picture = createQuestionScene();
  let view: View = 'iso';
  let scene: ReturnType<typeof lazyScene> | null = null;
  return {
    render(shown) {
      scene ??= lazyScene(element('scene-host', host), (action) => {
        if (action.type !== 'view') return;
        view = action.view;
        changed();
      });
      scene.render(picture({ ...shown, view }));
    },
  };
}

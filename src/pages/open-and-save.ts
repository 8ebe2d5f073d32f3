import type { Store } from '../state/store.ts';
import { encode } from '../state/url.ts';
import { download, mayPick, onTooLarge, pickFile, watchDrops } from '../ui/files.ts';
import { lazy } from '../ui/lazy.ts';
import type { PageView } from './page.ts';

interface Tools {
  readonly store: Store;
  readonly say: (words: string) => void;
  /** The shown page, which may take a file itself. */
  readonly view: () => Promise<PageView | null>;
  /** Reads the settings of the page that a file has brought. */
  readonly readShown: () => void;
  /** Uses code that a person waits for. */
  readonly withCode: <T>(code: Promise<T>, use: (code: T) => void) => void;
}

/** Files: a state or a lesson is saved, picked, or dropped onto the page. */
export function createFiles({ store, say, view, readShown, withCode }: Tools) {
  const states = () => lazy(() => import('../state/file.ts'));
  const lessons = () => lazy(() => import('./lesson/own-lesson.ts'));

  const openAnywhere = (text: string): void => {
    // Only a lesson begins with a line of three dashes.
    if (/^\s*---/.test(text)) {
      withCode(lessons(), ({ openedLesson }) => {
        store.dispatch({ type: 'open', state: (now) => openedLesson(now, text) });
        readShown();
      });
      return;
    }
    withCode(states(), ({ fromFile }) => {
      const opened = fromFile(text);
      if (opened.ok) {
        store.dispatch({ type: 'open', state: opened.state });
        readShown();
      } else store.dispatch({ type: 'say', problems: [opened.reason] });
    });
  };
  const openText = (text: string | null): void => {
    if (text === null) return;
    const here = view().catch(() => null);
    withCode(here, (shown) => shown?.open?.(text) || openAnywhere(text));
  };
  watchDrops(document.body, openText);
  onTooLarge((words) => store.dispatch({ type: 'say', problems: [words] }));

  return {
    save: (): void =>
      withCode(states(), ({ toFile }) => {
        download('graze.json', toFile(store.get()), 'application/json');
        say('saved: graze.json');
      }),
    open(): void {
      if (mayPick()) pickFile('.json,application/json,.md,text/markdown').then(openText);
      else say('that took too long for this browser: ask for it again');
    },
    /** Adds what is shown to the own lesson. */
    collect: (): void =>
      withCode(lessons(), ({ withCollected }) => {
        const { state, step } = withCollected(store.get(), encode(store.get()));
        store.dispatch({ type: 'open', state });
        say(`added as step ${step} of your lesson`);
      }),
  };
}

import { html, nothing, render } from 'lit';
import { COURSE_ELEMENT, readCourse } from '../../state/course/course.ts';
import { lazy, notLoaded } from '../../ui/lazy.ts';
import type { ExportItem } from '../export-dialog.ts';
import type { MountPage } from '../page.ts';
import { openCheckStorage } from './check-storage.ts';
import { createOwn } from './own-numbers.ts';
import { mountProgram } from './own-program.ts';
import {
  type CourseSession,
  element,
  type PartContext,
  turnablePicture,
  type WidePart,
} from './page-parts.ts';
import { createQuestions } from './questions.ts';
import {
  type CheckSettings,
  PARTS,
  type PartId,
  readSettings,
  settingsFor,
  settingsOf,
} from './settings.ts';
import './check-page.css';

/** The code of the parts for lecturers. */
const WIDE: Readonly<Partial<Record<PartId, () => Promise<(part: PartContext) => WidePart>>>> = {
  set: () => lazy(() => import('./set-part.ts')).then(({ createSetPart }) => createSetPart),
  class: () => lazy(() => import('./class-part.ts')).then(({ createClassPart }) => createClassPart),
};

const isWide = (id: PartId): boolean => PARTS.some((one) => one.id === id && one.wide);

/**
 * Questions or own numbers on the left, the own program on the right; on a narrow screen one at a
 * time.
 */
export const mountCheck: MountPage = (host, context) => {
  host.classList.add('check');
  const tabs = element('parts-area', host);
  const left = element('check-left', host);
  const head = element('check-head', left);
  const stage = element('check-stage', left);
  const picture = turnablePicture(stage, context.changed);
  const body = element('check-body', left);
  const right = element('check-right', host);
  tabs.dataset.part = 'rest';
  left.dataset.part = 'questions own';
  right.dataset.part = 'program';
  const broad = element('check-wide', host);
  broad.dataset.part = 'set class';
  const wide = matchMedia('(min-width: 1100px)');
  wide.addEventListener('change', context.changed);

  let session: CourseSession | null = null;
  const part: PartContext = {
    ...context,
    storage: openCheckStorage(),
    set: (wanted) => context.dispatch({ type: 'settings', values: settingsFor(wanted) }),
    course: () => session,
  };
  const questions = createQuestions(part);
  const course = readCourse(document.getElementById(COURSE_ELEMENT)?.textContent);
  if (course) {
    lazy(() => import('./course.ts'))
      .then(({ joinCourse }) => joinCourse(course, part))
      .then((joined) => {
        session = joined;
        questions.again();
        context.changed();
      });
  }
  const own = createOwn(part);
  const program = mountProgram(right, part);

  const wideParts = new Map<PartId, WidePart | 'loading' | 'failed'>();
  const wideHosts = new Map<PartId, HTMLElement>();
  const load = (id: PartId): void => {
    const loader = WIDE[id];
    if (!loader) return;
    wideParts.set(id, 'loading');
    loader().then(
      (create) => {
        wideParts.set(id, create(part));
        context.changed();
      },
      () => {
        wideParts.set(id, 'failed');
        context.changed();
      },
    );
  };
  const renderWide = (id: PartId, settings: CheckSettings): void => {
    if (!wideParts.has(id)) load(id);
    for (const [other, own] of wideHosts) own.hidden = other !== id;
    const own = wideHosts.get(id) ?? element('wide-part', broad);
    wideHosts.set(id, own);
    own.hidden = false;
    const loaded = wideParts.get(id);
    if (loaded === 'failed')
      render(
        notLoaded('This part could not be loaded.', () => load(id)),
        own,
      );
    else if (loaded === 'loading' || !loaded) own.setAttribute('aria-busy', 'true');
    else {
      if (own.hasAttribute('aria-busy')) own.removeAttribute('aria-busy');
      loaded.render(own, settings);
    }
  };
  const wideShown = (): WidePart | null => {
    const loaded = now && isWide(now.part) ? wideParts.get(now.part) : undefined;
    return typeof loaded === 'object' ? loaded : null;
  };
  let now: CheckSettings | null = null;

  const shownPart = (settings: CheckSettings): PartId => {
    if (!wide.matches) return settings.part;
    return settings.part === 'program' ? 'questions' : settings.part;
  };
  const drawTabs = (shown: PartId, settings: CheckSettings): void => {
    const offered = wide.matches ? PARTS.filter(({ id }) => id !== 'program') : PARTS;
    render(
      html`<h1 class="visually-hidden">Check yourself: where does the ray meet the surface?</h1>
      <nav class="check-parts" aria-label="Parts of this page">${offered.map(
        ({ id, title }) =>
          html`<button type="button" class="check-part"
            aria-current=${id === shown ? 'true' : nothing}
            @click=${() => part.set({ part: id })}>${title}</button>`,
      )}</nav>${shown === 'questions' ? questions.forms(settings) : nothing}`,
      tabs,
    );
  };

  return {
    render(state) {
      const settings = settingsOf(state.settings.check);
      const shown = shownPart(settings);
      drawTabs(shown, settings);
      now = settings;
      broad.hidden = !isWide(shown);
      left.hidden = shown === 'program' || isWide(shown);
      right.hidden = isWide(shown) || (!wide.matches && shown !== 'program');
      if (!broad.hidden) renderWide(shown, settings);
      if (!left.hidden) {
        const drawn = shown === 'own' ? own : questions;
        const scene = drawn.render(head, body, state, settings);
        stage.hidden = scene === null;
        if (scene) picture.render(scene);
      }
      if (!right.hidden) program.render(settings);
    },
    read: readSettings,
    exports: () => [
      exportItem(
        'summary-json',
        'the summary of the session as JSON',
        'graze-check.json',
        questions.json,
      ),
      exportItem('program-js', 'the own program', 'intersect.js', program.source),
      exportItem('cases-json', 'the cases for a program as JSON', 'graze-cases.json', () =>
        program.cases('json'),
      ),
      exportItem('cases-csv', 'the cases for a program as CSV', 'graze-cases.csv', () =>
        program.cases('csv'),
      ),
    ],
    score: questions.score,
    open(text) {
      if (wideShown()?.open?.(text)) return true;
      if (!wide.matches) part.set({ part: 'program' });
      return program.open(text);
    },
    rest() {
      program.cancel();
      wideShown()?.rest?.();
    },
  };
};

const TYPES: Readonly<Record<string, string>> = {
  json: 'application/json',
  js: 'text/javascript',
  csv: 'text/csv',
};

const exportItem = (id: string, title: string, file: string, text: () => string): ExportItem => ({
  ...{ id, title, file, text },
  type: TYPES[file.split('.').at(-1) ?? ''] ?? 'text/plain',
  blob: null,
});

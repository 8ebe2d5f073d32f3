import { html, nothing, render } from 'lit';
import { seedForm } from '../../panels/check-question.ts';
import type { ExportItem } from '../export-dialog.ts';
import type { MountPage } from '../page.ts';
import { openMemory } from './memory.ts';
import { createOwn } from './own-numbers.ts';
import { mountProgram } from './own-program.ts';
import { element, type PartContext, turnablePicture } from './part.ts';
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

/**
 * Questions or own numbers on the left, the own program on the right; on a narrow screen one at a
 * time.
 */
export const mountCheck: MountPage = (host, context) => {
  host.classList.add('check');
  const tabs = element('parts-area', host);
  const left = element('check-left', host);
  const head = element('check-head', left);
  const picture = turnablePicture(element('check-stage', left), context.changed);
  const body = element('check-body', left);
  const right = element('check-right', host);
  tabs.dataset.part = 'rest';
  left.dataset.part = 'questions own';
  right.dataset.part = 'program';
  const wide = matchMedia('(min-width: 1100px)');
  wide.addEventListener('change', context.changed);

  const part: PartContext = {
    ...context,
    memory: openMemory(),
    set: (wanted) => context.dispatch({ type: 'settings', values: settingsFor(wanted) }),
  };
  const questions = createQuestions(part);
  const own = createOwn(part);
  const program = mountProgram(right, part);

  const shownPart = (settings: CheckSettings): PartId => {
    if (!wide.matches) return settings.part;
    return settings.part === 'program' ? 'questions' : settings.part;
  };
  const drawTabs = (shown: PartId, { seed }: CheckSettings): void => {
    const offered = wide.matches ? PARTS.filter(({ id }) => id !== 'program') : PARTS;
    render(
      html`<h1 class="visually-hidden">Check yourself: where does the ray meet the surface?</h1>
      <nav class="parts" aria-label="Parts of this page">${offered.map(
        ({ id, title }) =>
          html`<button type="button" class="part" aria-current=${id === shown ? 'true' : nothing}
            @click=${() => part.set({ part: id })}>${title}</button>`,
      )}</nav>${shown === 'questions' ? seedForm(seed, questions.tools) : nothing}`,
      tabs,
    );
  };

  return {
    render(state) {
      const settings = settingsOf(state.settings.check);
      const shown = shownPart(settings);
      drawTabs(shown, settings);
      left.hidden = shown === 'program';
      right.hidden = !wide.matches && shown !== 'program';
      if (!left.hidden) {
        const drawn = shown === 'own' ? own : questions;
        picture.render(drawn.render(head, body, state, settings));
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
      if (!wide.matches) part.set({ part: 'program' });
      return program.open(text);
    },
    rest: () => program.cancel(),
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

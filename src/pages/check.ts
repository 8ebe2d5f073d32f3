import { html, nothing, render } from 'lit';
import { readAll, type Texts } from '../check/grade.ts';
import { checkOwn, type OwnReport, ownFields } from '../check/own-numbers.ts';
import { example, template } from '../check/program/template.ts';
import { summary, summaryJson } from '../check/summary.ts';
import type { Input } from '../check/types.ts';
import { ownNumbers } from '../panels/check-own.ts';
import {
  editor,
  exchange,
  type ProgramTools,
  programHead,
  programReport,
} from '../panels/check-program.ts';
import { answerForm, questionHead, questionText, seedForm } from '../panels/check-question.ts';
import { summaryTable } from '../panels/check-summary.ts';
import { controls } from '../panels/controls.ts';
import { shapePicker } from '../panels/shape-picker.ts';
import type { Action } from '../state/actions.ts';
import { createDerive } from '../state/derive.ts';
import { type AppState, INITIAL, rayOf, shapeOf } from '../state/state.ts';
import type { View } from '../state/view.ts';
import { download, pickFile } from '../ui/files.ts';
import { openMemory } from './check-memory.ts';
import { createPicture, exploreLink } from './check-picture.ts';
import { createQuestions } from './check-questions.ts';
import { createRuns, kindsFor } from './check-runs.ts';
import {
  type CheckSettings,
  PARTS,
  type PartId,
  readSettings,
  settingsFor,
  settingsOf,
} from './check-settings.ts';
import { lateScene } from './late-scene.ts';
import type { MountPage } from './page.ts';
import './check.css';

/** Questions or own numbers on the left, the own program on the right; on a narrow screen one at a time. */
export const mountCheck: MountPage = (host, context) => {
  host.classList.add('check');
  const part = (className: string, into: Element = host): HTMLElement => {
    const element = document.createElement('div');
    element.className = className;
    into.append(element);
    return element;
  };
  const tabs = part('parts-area');
  const left = part('check-left');
  const head = part('check-head', left);
  const stage = part('check-stage', left);
  const body = part('check-body', left);
  const right = part('check-right');
  const program = part('check-program', right);
  const failing = part('check-stage check-failing', right);
  const more = part('check-more', right);

  const wide = matchMedia('(min-width: 1100px)');
  wide.addEventListener('change', context.changed);
  const memory = openMemory();
  const derive = createDerive();
  const picture = createPicture();
  const failingPicture = createPicture();
  let state: AppState = INITIAL;
  let settings: CheckSettings = settingsOf({});
  let view: View = 'iso';
  let failingView: View = 'iso';
  let ownTexts: Texts = memory.own();
  let ownReport: { readonly input: Input; readonly report: OwnReport } | null = null;
  let ownInput: Input | null = null;
  let source = memory.program() ?? template(kindsFor(settings.cases));
  let failingScene: ReturnType<typeof lateScene> | null = null;

  const set = (wanted: Partial<CheckSettings>): void =>
    context.dispatch({ type: 'settings', values: settingsFor(wanted) });
  const questions = createQuestions(memory, {
    changed: context.changed,
    announce: context.announce,
    go(index) {
      set({ question: index });
      requestAnimationFrame(() => requestAnimationFrame(() => focusFirst()));
    },
    seed: (seed) => set({ seed, question: 0 }),
  });
  const runs = createRuns(right, context.changed);
  const scene = lateScene(part('scene-host', stage), (action: Action) => {
    if (action.type !== 'view') return;
    view = action.view;
    context.changed();
  });

  const focusFirst = (): void => body.querySelector<HTMLElement>('input, select')?.focus();

  const inputOf = (): Input => {
    const [shape, ray] = [shapeOf(state), rayOf(state)];
    const same =
      ownInput &&
      ownInput.shape === shape &&
      String(ownInput.ray.origin) === String(ray.origin) &&
      String(ownInput.ray.direction) === String(ray.direction);
    if (!same) ownInput = { shape, ray };
    return ownInput as Input;
  };

  const ownTools = {
    type(field: string, text: string) {
      ownTexts = { ...ownTexts, [field]: text };
      ownReport = null;
      memory.keepOwn(ownTexts);
      context.changed();
    },
    check() {
      const input = inputOf();
      ownReport = { input, report: checkOwn(input, ownTexts) };
      context.changed();
    },
    clear() {
      ownTexts = {};
      ownReport = null;
      memory.keepOwn(ownTexts);
      context.changed();
    },
  };

  const write = (text: string): void => {
    source = text;
    memory.keepProgram(text);
    context.changed();
  };
  /** A program that somebody wrote is not thrown away for a template without asking the undo of the box: it is put below it. */
  const offer = (text: string): void => {
    const kinds = kindsFor(settings.cases);
    const untouched =
      source.trim() === '' ||
      source === template(kinds) ||
      kinds.some((kind) => source === example(kind));
    write(
      untouched
        ? text
        : `${text}\n/* What stood here before:\n${source.replaceAll('*/', '* /')}\n*/\n`,
    );
  };
  const programTools: ProgramTools = {
    edit: write,
    pick(cases) {
      const untouched = source === template(kindsFor(settings.cases));
      set({ cases });
      if (untouched) write(template(kindsFor(cases)));
    },
    run: () => runs.run(source, settings.cases),
    cancel: () => runs.cancel(),
    async openFile() {
      const text = await pickFile('.js,.mjs,.ts,text/javascript');
      if (text !== null) write(text);
    },
    template: () => offer(template(kindsFor(settings.cases))),
    example: () => offer(example(kindsFor(settings.cases)[0] ?? 'cylinder')),
    select: (failure) => runs.select(failure),
    saveCases: (format) =>
      download(
        `graze-cases.${format}`,
        runs.file(format, settings.cases),
        format === 'json' ? 'application/json' : 'text/csv',
      ),
    async openResults() {
      const text = await pickFile('.json,.csv,application/json,text/csv');
      if (text !== null) runs.grade(text, settings.cases);
    },
  };

  const shownPart = (): PartId => {
    if (!wide.matches) return settings.part;
    return settings.part === 'program' ? 'questions' : settings.part;
  };

  const drawTabs = (shown: PartId): void => {
    const offered = wide.matches ? PARTS.filter(({ id }) => id !== 'program') : PARTS;
    render(
      html`<h1 class="visually-hidden">Check yourself: where does the ray meet the surface?</h1>
      <nav class="parts" aria-label="Parts of this page">${offered.map(
        ({ id, title }) =>
          html`<button type="button" class="part" aria-current=${id === shown ? 'true' : nothing} @click=${() => set({ part: id })}>${title}</button>`,
      )}</nav>${shown === 'questions' ? seedForm(settings.seed, questions.tools) : nothing}`,
      tabs,
    );
  };

  const drawQuestions = (): void => {
    const asked = questions.view(settings.seed, settings.question);
    render(html`${questionHead(asked, questions.tools)}${questionText(asked)}`, head);
    const committed = questions.committed();
    scene.render(
      picture({ input: asked.posed.draft, results: committed !== null, answers: committed, view }),
    );
    render(
      html`${answerForm(asked, questions.tools)}${summaryTable(summary(questions.progress()), {
        save: saveSummary,
        print: printSummary,
        restart: () => questions.restart(),
      })}`,
      body,
    );
  };

  const saveSummary = (): void => {
    const progress = questions.progress();
    download(`graze-check-${progress.seed}.json`, summaryJson(progress), 'application/json');
  };
  const printSummary = (): void => {
    const details = body.querySelector('details');
    if (details) details.open = true;
    window.print();
  };

  const drawOwn = (): void => {
    const model = derive(state);
    const input = inputOf();
    const report = ownReport?.input === input ? ownReport.report : null;
    render(
      html`<h2>Own numbers</h2>${shapePicker(model, context.dispatch)}${controls(model, context.dispatch)}`,
      head,
    );
    const answers = report ? readAll(ownFields(input), ownTexts) : null;
    scene.render(picture({ input, results: report !== null, answers, view }));
    render(ownNumbers({ input, texts: ownTexts, report }, ownTools), body);
  };

  const drawProgram = (): void => {
    const run = runs.get();
    const link = run.selected && exploreLink(run.selected.case);
    const shown = { ...run, source, kind: settings.cases, link };
    render(
      html`${programHead(shown, programTools)}${editor(shown, programTools)}${programReport(shown, programTools)}`,
      program,
    );
    render(exchange(programTools), more);
    drawFailing(link !== null);
  };

  const drawFailing = (drawable: boolean): void => {
    const { selected } = runs.get();
    failing.hidden = !selected || !drawable;
    if (!selected || !drawable) return;
    failingScene ??= lateScene(part('scene-host', failing), (action) => {
      if (action.type !== 'view') return;
      failingView = action.view;
      context.changed();
    });
    const { case: input, output } = selected;
    const t = output.type === 'value' ? output.t.slice(0, 2) : [];
    const answers = Object.fromEntries(t.map((x, i) => [`t${i + 1}`, x] as const));
    failingScene.render(failingPicture({ input, results: true, answers, view: failingView }));
  };

  return {
    render(next) {
      state = next;
      settings = settingsOf(next.settings.check);
      const shown = shownPart();
      drawTabs(shown);
      left.hidden = shown === 'program';
      right.hidden = !wide.matches && shown !== 'program';
      if (!left.hidden) {
        if (shown === 'own') drawOwn();
        else drawQuestions();
      }
      if (!right.hidden) drawProgram();
    },
    read: readSettings,
    takeaways: () => [
      {
        id: 'summary-json',
        title: 'the summary of the session as JSON',
        file: 'graze-check.json',
        type: 'application/json',
        text: () => summaryJson(questions.progress()),
        blob: null,
      },
      {
        id: 'program-js',
        title: 'the own program',
        file: 'intersect.js',
        type: 'text/javascript',
        text: () => source,
        blob: null,
      },
      {
        id: 'cases-json',
        title: 'the cases for a program as JSON',
        file: 'graze-cases.json',
        type: 'application/json',
        text: () => runs.file('json', settings.cases),
        blob: null,
      },
      {
        id: 'cases-csv',
        title: 'the cases for a program as CSV',
        file: 'graze-cases.csv',
        type: 'text/csv',
        text: () => runs.file('csv', settings.cases),
        blob: null,
      },
    ],
    open(text) {
      if (/\bintersect\b/.test(text) && /function|=>/.test(text)) {
        write(text);
        if (!wide.matches) set({ part: 'program' });
        return true;
      }
      if (!wide.matches) set({ part: 'program' });
      return runs.grade(text, settings.cases);
    },
    rest: () => runs.cancel(),
  };
};

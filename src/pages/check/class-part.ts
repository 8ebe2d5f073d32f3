import { html, render } from 'lit';
import {
  type ClassReport,
  classCsv,
  classReport,
  type HandIn,
  type MarkedStudent,
  marking,
} from '../../check/class.ts';
import { isGraded } from '../../check/program/submissions.ts';
import { setName } from '../../check/sets.ts';
import { InvalidInput } from '../../math/index.ts';
import { type ClassTools, classForm } from '../../panels/check-class.ts';
import { codesIn, readHandIn } from '../../state/hand-in.ts';
import { chosenFiles, download, droppedFiles, readTexts } from '../../ui/files.ts';
import { createGrades } from './grades.ts';
import { element, type PartContext, type WidePart } from './page-parts.ts';
import type { CheckSettings } from './settings.ts';

/** ms of marking after which the page may draw and handle events; one question takes up to 100. */
const SLICE_MS = 12;

/** The part 'Mark a class': marks hand-in codes in slices of time, and grades programs. */
export function createClassPart(part: PartContext): WidePart {
  const { changed } = part;
  let host: HTMLElement | null = null;
  let sandbox: HTMLElement | null = null;
  /** Where programs run: beside what is drawn. */
  const sandboxHost = (): HTMLElement => {
    sandbox ??= element('class-sandbox', host?.parentElement ?? document.body);
    return sandbox;
  };
  const grades = createGrades(sandboxHost, part);
  let text = '';
  let compares = true;
  let problems: readonly string[] = [];
  let marked: readonly MarkedStudent[] = [];
  let report: ClassReport | null = null;
  let running: { readonly done: number; readonly total: number } | null = null;
  let settings: CheckSettings | null = null;
  let stop = (): void => {};
  const known = new Set<string>();
  const tell = (): void => {
    const expected = settings && compares ? { set: settings.set, seed: settings.seed } : null;
    report = marked.length > 0 ? classReport(marked, expected) : null;
    changed();
  };
  /** Marks the codes of a text; the same code twice counts once. */
  const take = (given: string, from: string): boolean => {
    const codes = [...new Set(codesIn(given))];
    const waits = new Set(queue.map(({ code }) => code));
    const fresh = codes.filter((code) => !known.has(code) && !waits.has(code));
    for (const code of fresh) {
      try {
        queue.push({ code, handIn: readHandIn(code) });
      } catch (error) {
        if (!(error instanceof InvalidInput)) throw error;
        problems = [...problems, `${code.slice(0, 24)}… (${from}): ${error.message}`];
      }
    }
    if (codes.length === 0) problems = [...problems, `${from}: no hand-in code in it`];
    else if (fresh.length === 0) problems = [...problems, `${from}: marked already`];
    if (queue.length > 0 && !running) void work();
    changed();
    return codes.length > 0;
  };
  const queue: { readonly code: string; readonly handIn: HandIn }[] = [];
  const work = async (): Promise<void> => {
    let stopped = false;
    stop = () => {
      stopped = true;
    };
    let done = 0;
    let slice = performance.now();
    const breathe = async (): Promise<void> => {
      if (performance.now() - slice < SLICE_MS) return;
      running = { done, total: done + queue.length + 1 };
      changed();
      await new Promise((resolve) => setTimeout(resolve));
      slice = performance.now();
    };
    running = { done, total: queue.length };
    for (let next = queue.shift(); next && !stopped; next = queue.shift()) {
      const steps = marking(next.handIn);
      let step = steps.next();
      while (!step.done && !stopped) {
        await breathe();
        step = steps.next();
      }
      if (step.done) {
        marked = [...marked, step.value];
        known.add(next.code);
      }
      done++;
    }
    queue.length = 0;
    running = null;
    tell();
  };
  const tools: ClassTools = {
    type(typed) {
      text = typed;
    },
    mark() {
      problems = [];
      if (take(text, 'the box')) text = '';
    },
    async files(files) {
      problems = [];
      const programs: { readonly path: string; readonly text: string }[] = [];
      for (const { path, text: content } of await readTexts(files)) {
        const name = path.slice(-60);
        // Operating systems add files of their own to folders: .DS_Store.
        if (path.split('/').at(-1)?.startsWith('.')) continue;
        if (content === null) problems = [...problems, `${name}: larger than 2 MB`];
        else if (isGraded(path) && codesIn(content).length === 0) {
          programs.push({ path, text: content });
        } else take(content, name);
      }
      if (programs.length > 0) grades.take(programs);
      changed();
    },
    chosen: (input) => tools.files(chosenFiles(input)),
    drop: async (transfer) => tools.files(await droppedFiles(transfer)),
    compare(wanted) {
      compares = wanted;
      tell();
    },
    cancel: () => stop(),
    clear() {
      stop();
      queue.length = 0;
      known.clear();
      grades.clear();
      marked = [];
      problems = [];
      tell();
    },
    save: () => report && download('graze-class.csv', classCsv(report), 'text/csv'),
  };
  return {
    render(own, next) {
      host = own;
      const other = settings?.set !== next.set || settings?.seed !== next.seed;
      settings = next;
      if (other && marked.length > 0) tell();
      const compared = `${setName(next.set)}, seed ${next.seed}`;
      const view = {
        ...{ text, running, problems, report, compared, compares },
        ...{ grades: grades.view(next), isGraded: grades.isThere() },
      };
      render(html`${classForm(view, tools)}`, own);
    },
    open(given) {
      problems = [];
      return take(given, 'the file');
    },
    rest() {
      stop();
      grades.cancel();
    },
  };
}

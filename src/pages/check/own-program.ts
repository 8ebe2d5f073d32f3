import { html, render } from 'lit';
import { CASES_SEED } from '../../check/program/cases.ts';
import { tooLong } from '../../check/program/script.ts';
import { example, template } from '../../check/program/template.ts';
import { FIRST_SET } from '../../check/sets.ts';
import { SHAPES } from '../../math/index.ts';
import type { ShapeKind } from '../../math/shapes.ts';
import { editor, exchange, programHead } from '../../panels/check-program.ts';
import type { ProgramTools } from '../../panels/check-program-view.ts';
import { programReport } from '../../panels/check-report.ts';
import { download, pickFile } from '../../ui/files.ts';
import { element, type PartContext, turnablePicture } from './page-parts.ts';
import { allWords, createRuns, kindsFor } from './program-run.ts';
import { exploreLink } from './question-scene.ts';
import { type CheckSettings, seedProblem } from './settings.ts';

interface Program {
  render(settings: CheckSettings): void;
  source(): string;
  cases(format: 'json' | 'csv'): string;
  /** Opens a program or a file of results; false if the text is neither. */
  open(text: string): boolean;
  cancel(): void;
}

const TYPES = { json: 'application/json', csv: 'text/csv' } as const;

/** The student's own program: its text, its run in the sandbox, the report and a failing case. */
export function mountProgram(
  host: HTMLElement,
  { storage, changed, ...part }: PartContext,
): Program {
  const main = element('check-program', host);
  const failing = element('check-stage check-failing', host);
  const more = element('check-more', host);
  const picture = turnablePicture(failing, changed);
  let casesSeed = CASES_SEED;
  const runs = createRuns(
    () => host,
    changed,
    () => casesSeed,
  );
  let cases = '';
  let set = FIRST_SET;
  const kinds = (): readonly ShapeKind[] => kindsFor(cases, set);
  // A stored program that is too long to edit (older versions allowed it) is kept until a new one
  // is written.
  const kept = storage.program();
  let unshown = kept !== null && tooLong(kept) !== '' ? kept : null;
  let written = unshown === null ? kept : null;
  let refusal =
    unshown === null
      ? ''
      : `The program that this device remembers is not shown: ${tooLong(unshown)}.`;
  const templateNow = (): string => template(kinds());
  const source = (): string => written ?? templateNow();
  const refuse = (words: string): void => {
    refusal = words;
    changed();
  };
  /** Whether the text may replace the program; if it is refused, the editor keeps its text. */
  const takes = (text: string, what = 'This text'): boolean => {
    const reason = tooLong(text);
    if (reason) refuse(`${what} was not taken: ${reason}.`);
    return reason === '';
  };
  const write = (text: string, what?: string): void => {
    if (takes(text, what)) {
      written = text;
      unshown = null;
      refusal = '';
      storage.keepProgram(text);
    }
    changed();
  };
  const isOurs = (text: string): boolean => {
    const choices = [kinds(), ...SHAPES.map(({ kind }) => [kind])];
    return text.trim() === '' || choices.some((k) => text === template(k) || text === example(k));
  };
  /** Puts a template into the editor; the student's program is kept below it as a comment. */
  const offer = (text: string, what: string): void => {
    const before = source();
    const below = `\n/* What stood here before:\n${before.replaceAll('*/', '* /')}\n*/\n`;
    write(isOurs(before) ? text : text + below, what);
  };
  const tools: ProgramTools = {
    edit: (text) => write(text),
    takes: (text) => takes(text),
    seed(wanted) {
      const problem = seedProblem('cases-seed', wanted);
      refuse(problem);
      if (problem === '') part.set({ casesSeed: Number(wanted) });
    },
    pick(kind) {
      if (source() === templateNow()) write(template(kindsFor(kind, set)));
      cases = kind;
      part.set({ cases: kind });
    },
    run: () => runs.run(source(), kinds()),
    cancel: () => runs.cancel(),
    async openFile() {
      const text = await pickFile('.js,.mjs,.cjs,.ts,.mts,text/javascript');
      if (text === '') refuse('The file is empty, or larger than 2 MB.');
      else if (text !== null) write(text, 'The file');
    },
    saveUnshown: () => download('intersect.js', unshown ?? '', 'text/javascript'),
    template: () => offer(templateNow(), 'With what stands here, the template'),
    example: () => offer(example(kinds()), 'With what stands here, the example'),
    select: (failure) => runs.select(failure),
    saveCases: (format) =>
      download(`graze-cases.${format}`, runs.file(format, kinds()), TYPES[format]),
    async openResults() {
      const text = await pickFile('.json,.csv,application/json,text/csv');
      if (text !== null) runs.grade(text, kinds());
    },
  };
  const drawFailing = (drawable: boolean): void => {
    const { selected } = runs.get();
    failing.hidden = !selected || !drawable;
    if (!selected || !drawable) return;
    const { case: input, output } = selected;
    const t = output.type === 'value' ? output.t.slice(0, 2) : [];
    const answers = Object.fromEntries(t.map((x, i) => [`t${i + 1}`, x] as const));
    picture.render({ input, results: true, answers, given: {}, note: '' });
  };
  return {
    render(settings) {
      ({ cases, set, casesSeed } = settings);
      const run = runs.get();
      const link = run.selected && exploreLink(run.selected.case);
      const view = {
        ...run,
        ...{
          source: source(),
          refusal,
          unshown: unshown !== null,
          kind: cases,
          all: allWords(set),
          link,
        },
      };
      render(
        html`${programHead(view, tools)}${editor(view, tools)}${programReport(view, tools)}`,
        main,
      );
      render(exchange(tools, casesSeed), more);
      drawFailing(link !== null);
    },
    source,
    cases: (format) => runs.file(format, kinds()),
    open(text) {
      if (!/\bintersect\b/.test(text) || !/function|=>/.test(text))
        return runs.grade(text, kinds());
      write(text, 'The file');
      return true;
    },
    cancel: () => runs.cancel(),
  };
}

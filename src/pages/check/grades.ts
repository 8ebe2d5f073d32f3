import type { GroupId } from '../../check/program/cases.ts';
import {
  type Graded,
  gradesCsv,
  gradescope,
  gradesMarkdown,
  junit,
  resultsName,
  WEIGHTS,
  weightProblem,
} from '../../check/program/marks.ts';
import { isProgram, type Submission, submissionsAmong } from '../../check/program/submissions.ts';
import { gradesPart } from '../../panels/check-grades.ts';
import { zipOf } from '../../state/zip.ts';
import { parseNumber } from '../../text/parse.ts';
import { download } from '../../ui/files.ts';
import type { PartContext } from './page-parts.ts';
import { allWords, createRuns, kindsFor } from './program-run.ts';
import { type CheckSettings, seedProblem } from './settings.ts';

interface GradedFile {
  readonly path: string;
  readonly text: string;
}

interface Grades {
  /** Grades these files, beside those that were before. */
  take(files: readonly GradedFile[]): void;
  view(settings: CheckSettings): ReturnType<typeof gradesPart>;
  /** Whether something was graded. */
  isThere(): boolean;
  cancel(): void;
  clear(): void;
}

/** Grades programs and files of results of a class, one after another. */
export function createGrades(
  host: () => Element,
  { changed, set, say }: Pick<PartContext, 'changed' | 'set' | 'say'>,
): Grades {
  let settings: CheckSettings | null = null;
  let files: readonly GradedFile[] = [];
  let graded: readonly Graded[] = [];
  let running: { readonly done: number; readonly total: number } | null = null;
  let weights = WEIGHTS;
  let refusals: Record<string, string> = {};
  /** The shapes and the seed of the graded cases, which stay when the link changes. */
  let about = '';
  /** Grows with each round of grading, so that an earlier round stops. */
  let round = 0;
  let heard = (): void => {};
  const runs = createRuns(
    host,
    () => {
      heard();
      changed();
    },
    () => settings?.casesSeed ?? 0,
    false,
  );
  const kinds = () => (settings ? kindsFor(settings.cases, settings.set) : []);
  const gradeOne = async ({ who, file, problem }: Submission<GradedFile>): Promise<Graded> => {
    if (!file) return { who, report: null, problems: [problem] };
    const { finished } = runs.get();
    if (isProgram(file.path)) {
      const end = new Promise<void>((done) => {
        heard = () => runs.get().finished > finished && !runs.get().shrinking && done();
      });
      runs.run(file.text, kinds());
      await end;
      heard = () => {};
    } else runs.grade(file.text, kinds());
    const { report, trouble, notes } = runs.get();
    return { who, report, problems: [...(trouble ? [trouble] : []), ...notes] };
  };
  const work = async (): Promise<void> => {
    if (!settings || files.length === 0) return;
    const own = ++round;
    const all = submissionsAmong(files);
    graded = [];
    about = `${kinds().join(', ')}, seed ${settings.casesSeed}`;
    for (const [done, submission] of all.entries()) {
      running = { done, total: all.length };
      changed();
      const one = await gradeOne(submission);
      // Lets the page draw and handle events between two files.
      await new Promise((resolve) => setTimeout(resolve));
      if (own !== round) return;
      graded = [...graded, one];
    }
    running = null;
    changed();
  };
  const cancel = (): void => {
    if (!running) return;
    round++;
    runs.cancel();
    running = null;
    changed();
  };
  const FILES: Readonly<Record<string, () => void>> = {
    csv: () => download('graze-programs.csv', gradesCsv(graded, weights), 'text/csv'),
    junit: () => download('graze-junit.xml', junit(graded), 'application/xml'),
    markdown: () => download('report.md', gradesMarkdown(graded, weights, `Programs for ${about}`)),
    gradescope() {
      const [only, ...others] = graded;
      if (only && others.length === 0) {
        download('results.json', gradescope(only, weights), 'application/json');
        return;
      }
      const each = graded.map((one) => [resultsName(one.who), gradescope(one, weights)] as const);
      const zip = zipOf(Object.fromEntries(each)) as BlobPart;
      download('graze-results.zip', new Blob([zip], { type: 'application/zip' }));
    },
  };
  return {
    take(more) {
      const paths = new Set(more.map(({ path }) => path));
      files = [...files.filter(({ path }) => !paths.has(path)), ...more];
      void work();
    },
    view(next) {
      settings = next;
      const view = {
        ...{ graded, running, weights, refusals, about },
        ...{ cases: next.cases, casesSeed: next.casesSeed, all: allWords(next.set) },
        isStale: about !== '' && about !== `${kinds().join(', ')}, seed ${next.casesSeed}`,
      };
      return gradesPart(view, {
        cancel,
        again: () => void work(),
        save: (id) => FILES[id]?.(),
        cases: (cases) => set({ cases }),
        seed(text) {
          const problem = seedProblem('cases-seed', text);
          refusals = { ...refusals, seed: problem };
          if (problem === '') set({ casesSeed: Number(text) });
          changed();
        },
        saveCases(format) {
          download(`graze-cases.${format}`, runs.file(format, kinds()));
          say(`saved: graze-cases.${format}`);
        },
        weigh(group: GroupId, text: string) {
          const read = parseNumber(text);
          const wanted = { ...weights, [group]: read.ok ? read.value : 0 };
          const problem = read.ok ? weightProblem(wanted) : `${read.reason}.`;
          refusals = { ...refusals, [group]: problem && `Weight of ${group} cases: ${problem}` };
          if (problem === '') weights = wanted;
          changed();
        },
      });
    },
    isThere: () => about !== '',
    cancel,
    clear() {
      cancel();
      files = [];
      graded = [];
      about = '';
    },
  };
}

import type { Posed } from '../check/compose.ts';
import { courseOf } from '../check/course.ts';
import { readAll } from '../check/grade.ts';
import { type Judged, judge } from '../check/judge.ts';
import { askedAt, hinted, type Progress, solutionShown, tried, typed } from '../check/progress.ts';
import { plan, question } from '../check/session.ts';
import type { Answers } from '../check/types.ts';
import { work } from '../check/work.ts';
import { HINTS, type QuestionTools, type QuestionView } from '../panels/check-question.ts';
import type { Memory } from './check-memory.ts';

export interface Questions {
  /** The question that the link asks for. */
  view(seed: number, index: number): QuestionView;
  /** What has been committed, for the picture; null while a prediction is open. */
  committed(): Answers | null;
  readonly tools: QuestionTools;
  progress(): Progress;
  /** Forgets this session's answers. */
  restart(): void;
}

/** The questions of one session after another: what was typed lives on the device, what was judged with the page. */
export function createQuestions(
  memory: Memory,
  tools: {
    changed(): void;
    announce(words: string): void;
    go(index: number): void;
    seed(seed: number): void;
  },
): Questions {
  let progress = memory.session(1);
  let index = 0;
  let posed: Posed = question(progress.seed, index);
  let judged: Judged | null = null;
  const keep = (next: Progress): void => {
    progress = next;
    memory.keep(progress);
    tools.changed();
  };
  const judgeNow = (): Judged => {
    const { draft, fields, truth, suspects } = posed;
    const again = (own: Answers): Answers => work(courseOf(draft.shape), draft, own);
    return judge(fields, askedAt(progress, index).texts, truth, suspects, again);
  };
  const show = (seed: number, at: number): void => {
    if (seed === progress.seed && at === index) return;
    if (seed !== progress.seed) progress = memory.session(seed);
    index = at;
    posed = question(seed, at);
    recallVerdict();
  };
  /** A question that was solved before is still solved. */
  const recallVerdict = (): void => {
    judged = askedAt(progress, index).solvedAt === null ? null : judgeNow();
  };
  recallVerdict();
  return {
    view(seed, at) {
      show(seed, at);
      return { posed, index, count: plan(seed).length, progress, judged };
    },
    committed() {
      const { texts, solutionShown: shown } = askedAt(progress, index);
      if (judged && judged.verdict !== 'invalid') return readAll(posed.fields, texts);
      return shown ? {} : null;
    },
    progress: () => progress,
    restart() {
      judged = null;
      keep({ seed: progress.seed, asked: {} });
    },
    tools: {
      type(field, text) {
        judged = null;
        keep(typed(progress, index, field, text));
      },
      check() {
        judged = judgeNow();
        keep(tried(progress, index, judged));
      },
      hint: () => keep(hinted(progress, index, HINTS)),
      solution: () => keep(solutionShown(progress, index)),
      go: tools.go,
      seed: tools.seed,
    },
  };
}

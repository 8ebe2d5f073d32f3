import { html, render } from 'lit';
import { derivationFor, type Posed } from '../../check/compose.ts';
import { drawnInput } from '../../check/drawn-input.ts';
import { readAll } from '../../check/grade.ts';
import { type Judged, judge } from '../../check/judge.ts';
import {
  askedAt,
  hinted,
  type Progress,
  solutionShown,
  started,
  tried,
  typed,
} from '../../check/progress.ts';
import { plan, question } from '../../check/session.ts';
import { FIRST_SET, LATEST_SET } from '../../check/sets.ts';
import { summary, summaryJson } from '../../check/summary.ts';
import { answerForm, questionHead, questionText } from '../../panels/check-question.ts';
import { HINTS, type QuestionTools } from '../../panels/check-question-view.ts';
import { summaryTable } from '../../panels/check-summary.ts';
import { download } from '../../ui/files.ts';
import type { LeftPart, PartContext, Shown } from './part.ts';
import type { CheckSettings } from './settings.ts';

interface Questions extends LeftPart {
  readonly tools: QuestionTools;
  /** The session so far as JSON, for a download. */
  json(): string;
  score(): { readonly right: number; readonly asked: number };
}

/** The questions of sessions. Typed texts are kept in the browser's storage, judgements are not. */
export function createQuestions({ memory, changed, set }: PartContext): Questions {
  let progress = memory.session(1, FIRST_SET);
  let index = 0;
  let posed: Posed = question(progress.seed, index, progress.set);
  let judged: Judged | null = null;
  /** The picture; the same object while it shows the same. */
  let picture: Shown | null = null;
  const keep = (next: Progress): void => {
    progress = next;
    memory.keep(progress);
    changed();
  };
  const judgeNow = (): Judged => judge(derivationFor(posed), askedAt(progress, index).texts);
  /** Judges the texts of a question again that was solved before. */
  const recallVerdict = (): void => {
    judged = askedAt(progress, index).solvedAt === null ? null : judgeNow();
  };
  const show = ({ seed, set: own, question: at }: CheckSettings): void => {
    const same = seed === progress.seed && own === progress.set;
    if (same && at === index) return;
    if (!same) progress = memory.session(seed, own);
    index = at;
    posed = question(seed, at, own);
    recallVerdict();
  };
  /** The picture: with hits and normals once the question is solved, else the student's points. */
  const shown = (): Shown => {
    const { texts, solvedAt, solutionShown: given } = askedAt(progress, index);
    const results = solvedAt !== null || given;
    const committed = judged !== null && judged.verdict !== 'invalid';
    const answers = committed ? readAll(posed.fields, texts) : null;
    const drawn = results ? { input: posed.draft, note: '' } : drawnInput(posed, answers ?? {});
    const next = { ...drawn, results, answers, given: posed.given };
    if (JSON.stringify(next) !== JSON.stringify(picture)) picture = next;
    return picture ?? next;
  };
  /** The question whose first box gets the focus when it is rendered. */
  let arriving: number | null = null;
  const tools: QuestionTools = {
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
    go(next) {
      arriving = next;
      set({ question: next });
      changed();
    },
    // A new session uses the newest set; one from a link keeps the link's.
    seed: (seed) => set({ seed, set: LATEST_SET, question: 0 }),
  };
  const save = (): void =>
    download(`graze-check-${progress.seed}.json`, summaryJson(progress), 'application/json');
  recallVerdict();
  return {
    tools,
    json: () => summaryJson(progress),
    score() {
      const { right, total } = summary(progress);
      return { right, asked: total };
    },
    render(head, body, _, settings) {
      show(settings);
      const view = {
        posed,
        index,
        count: plan(progress.seed, progress.set).length,
        progress,
        judged,
      };
      render(html`${questionHead(view, tools)}${questionText(view)}`, head);
      const print = (): void => {
        const details = body.querySelector('details');
        if (details) details.open = true;
        window.print();
      };
      const restart = (): void => {
        judged = null;
        keep(started(progress.seed, progress.set));
      };
      const table = summaryTable(summary(progress), { save, print, restart });
      render(html`${answerForm(view, tools)}${table}`, body);
      // In the same task: later it would take the focus from whoever has gone on meanwhile.
      if (arriving === index) body.querySelector<HTMLElement>('input, select')?.focus();
      arriving = null;
      return shown();
    },
  };
}

import { html, nothing, render, type TemplateResult } from 'lit';
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
import { plan, question, studentSeed } from '../../check/session.ts';
import { FIRST_SET, isNumbered, LATEST_SET, setOf } from '../../check/sets.ts';
import { summary, summaryJson } from '../../check/summary.ts';
import { handInBox, nameForm } from '../../panels/check-hand-in.ts';
import { answerForm, questionHead, questionText, seedForm } from '../../panels/check-question.ts';
import { HINTS, type QuestionTools } from '../../panels/check-question-view.ts';
import { summaryTable } from '../../panels/check-summary.ts';
import { handInCode, handInOf } from '../../state/hand-in.ts';
import { copyText } from '../../ui/clipboard.ts';
import { download } from '../../ui/files.ts';
import { lazy } from '../../ui/lazy.ts';
import { qrCode } from '../handout/qr-code.ts';
import type { LeftPart, PartContext, QuestionPicture } from './page-parts.ts';
import type { CheckSettings } from './settings.ts';

interface Questions extends LeftPart {
  /** The boxes for the seed and for a name. */
  forms(settings: CheckSettings): TemplateResult;
  /** The session so far as JSON, for a download. */
  json(): string;
  score(): { readonly right: number; readonly asked: number };
  /** Another session is kept for the same seed. */
  again(): void;
}

/** The questions of sessions. Typed texts are kept in the browser's storage, judgements are not. */
export function createQuestions({ storage, changed, set, say, course }: PartContext): Questions {
  let progress = storage.session(1, FIRST_SET);
  let index = 0;
  let posed: Posed = question(progress.seed, index, progress.set);
  let judged: Judged | null = null;
  /** The picture; the same object while it shows the same. */
  let picture: QuestionPicture | null = null;
  const keep = (next: Progress): void => {
    progress = next;
    storage.keep(progress);
    changed();
  };
  const judgeNow = (): Judged => judge(derivationFor(posed), askedAt(progress, index).texts);
  /** Judges the texts of a question again that was solved before. */
  const recallVerdict = (): void => {
    judged = askedAt(progress, index).solvedAt === null ? null : judgeNow();
  };
  /** The seed and the name of the link, from which the session's seed follows. */
  let given = { seed: 1, who: '' };
  let handsIn = false;
  const show = ({ seed: ofAll, who, set: own, question: at }: CheckSettings): void => {
    given = { seed: ofAll, who };
    const seed = studentSeed(ofAll, who);
    const same = seed === progress.seed && own === progress.set;
    if (same && at === index) return;
    if (!same) progress = storage.session(seed, own);
    index = at;
    course()?.changed(progress, index, false);
    posed = question(seed, at, own);
    recallVerdict();
  };
  /**
   * The scene, if the question has one: with hits and normals once it is solved, else the student's
   * points.
   */
  const shown = (): QuestionPicture | null => {
    if (posed.exercise.picture) return null;
    const { texts, solvedAt, solutionShown: given } = askedAt(progress, index);
    const results = solvedAt !== null || given;
    const committed = judged !== null && judged.verdict !== 'invalid';
    const answers = committed ? readAll(posed.fields, texts) : null;
    const drawn = results ? { input: posed.draft, note: '' } : drawnInput(posed, answers ?? {});
    const next = { ...drawn, results, answers, given: posed.given };
    if (JSON.stringify(next) !== JSON.stringify(picture)) picture = next;
    return picture ?? next;
  };
  const code = (): string => handInCode(handInOf(progress, given.seed, given.who));
  const handIn = {
    toggle(open: boolean) {
      if (open === handsIn) return;
      handsIn = open;
      changed();
    },
    name: (who: string) => set({ who, question: 0 }),
    async copy() {
      const copied = await copyText(code());
      say(copied ? 'copied: the code of what you hand in' : 'it could not be copied: mark it');
    },
    save: () => download(`graze-hand-in-${progress.seed}.txt`, `${code()}\n`),
    async statements() {
      const { saveStatements } = await lazy(() => import('./statements.ts'));
      await saveStatements(progress, given);
      say('saved: the statements');
    },
  };
  let drawnCode: { readonly code: string; readonly picture: TemplateResult } | null = null;
  const handInView = () => {
    if (!handsIn) return { who: given.who, open: false, code: '', picture: html`` };
    const now = code();
    if (drawnCode?.code !== now) drawnCode = { code: now, picture: qrCode(now, 'code') };
    return { who: given.who, open: true, ...drawnCode };
  };
  /** The question whose first box gets the focus when it is rendered. */
  let arriving: number | null = null;
  const tools: QuestionTools = {
    type(field, text) {
      judged = null;
      keep(typed(progress, index, field, text));
      course()?.changed(progress, index, false);
    },
    check() {
      judged = judgeNow();
      keep(tried(progress, index, judged));
      course()?.answered(posed, index, progress, judged);
    },
    hint() {
      keep(hinted(progress, index, HINTS));
      course()?.changed(progress, index, false);
    },
    solution() {
      keep(solutionShown(progress, index));
      course()?.changed(progress, index, true);
    },
    go(next) {
      arriving = next;
      set({ question: next });
      changed();
    },
    // A new session uses the newest set; one that was made for a class is kept.
    seed: (seed) =>
      set({ seed, set: isNumbered(progress.set) ? LATEST_SET : progress.set, question: 0 }),
  };
  const save = (): void =>
    download(`graze-check-${progress.seed}.json`, summaryJson(progress), 'application/json');
  recallVerdict();
  return {
    forms: ({ seed, who, set: own }) =>
      html`<div class="seeds">${
        !isNumbered(own) || who !== '' ? nameForm(who, handIn.name) : nothing
      }${seedForm(seed, tools)}</div>`,
    json: () => summaryJson(progress),
    score() {
      const { right, total } = summary(progress);
      return { right, asked: total };
    },
    again() {
      progress = storage.session(progress.seed, progress.set);
      recallVerdict();
    },
    render(head, body, _, settings) {
      show(settings);
      const view = {
        posed,
        index,
        count: plan(progress.seed, progress.set).length,
        progress,
        judged,
        withHints: !setOf(progress.set).withoutHints,
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
      const own = course();
      const reported = own?.isOf(progress) === true;
      const summed = summary(progress);
      const table = summaryTable(summed, {
        ...{ save, print, isFramed: window.parent !== window },
        restart: reported ? null : restart,
      });
      const box = handInBox({ ...handInView(), reported }, handIn);
      const told = own?.box(progress) ?? nothing;
      render(html`${answerForm(view, tools)}${told}${table}${box}`, body);
      // In the same task: later it would take the focus from another control.
      if (arriving === index) body.querySelector<HTMLElement>('input, select')?.focus();
      arriving = null;
      return shown();
    },
  };
}

import { html, type TemplateResult } from 'lit';
import { askedOf } from '../../check/asked.ts';
import type { Posed } from '../../check/compose.ts';
import { plan, question } from '../../check/session.ts';
import { setName } from '../../check/sets.ts';
import type { Field } from '../../check/types.ts';
import { questionDrawing } from '../../panels/check-drawing.ts';
import { solution } from '../../panels/check-feedback.ts';
import { givenLines } from '../../panels/check-given.ts';
import type { Sheets } from '../../panels/check-set.ts';
import type { Handout } from './print.ts';
import './sheets.css';

/** Most sheets of one print: more are printed in portions. */
export const MOST_SHEETS = 200;

/** The questions of a seed. */
export interface Sheet {
  readonly seed: number;
  readonly posed: readonly Posed[];
}

/** The seeds of these sheets, in order. */
export const seedsOf = ({ from, to }: Sheets): number[] =>
  Array.from({ length: to - from + 1 }, (_, i) => from + i);

export const sheetOf = (set: string, seed: number): Sheet => ({
  seed,
  posed: plan(seed, set).map((_, i) => question(seed, i, set)),
});

/** The sheets one after the other, and behind them their keys. */
export function sheetsHandout(
  set: string,
  sheets: readonly Sheet[],
  { paper, key }: Sheets,
): Handout {
  const page = `sheet sheet-${paper}`;
  return {
    content: html`<div>${sheets.map(
      (sheet) => html`<section class=${page}>${head(set, sheet.seed, false)}
        ${sheet.posed.map((posed, i) => asked(posed, i, sheet.seed))}</section>`,
    )}${
      key
        ? sheets.map(
            (sheet) => html`<section class="${page} sheet-key">${head(set, sheet.seed, true)}
              ${sheet.posed.map((posed, i) => solved(posed, i, sheet.seed))}</section>`,
          )
        : ''
    }</div>`,
    drawn: () => {},
  };
}

const head = (set: string, seed: number, isKey: boolean): TemplateResult =>
  html`<header class="sheet-head"><h1>${isKey ? 'Key' : 'Where does the ray meet it?'}</h1>
    <span>${setName(set)}, seed ${seed}</span>${
      isKey ? '' : html`<span class="sheet-name">Name <span></span></span>`
    }</header>`;

const about = (posed: Posed, i: number, id: string): TemplateResult =>
  html`<h2>${i + 1}  ${askedOf(posed).subject}: ${posed.exercise.topic}</h2>
    <p>${posed.exercise.ask(posed.draft)}</p>${givenLines(posed)}${questionDrawing(posed, id)}`;

const asked = (posed: Posed, i: number, seed: number): TemplateResult =>
  html`<div class="sheet-question" .style=${`--answers: ${posed.fields.length}`}>
    ${about(posed, i, `asked-${seed}-${i}`)}
    <div class="sheet-working"></div>
    <div class="sheet-answers">${posed.fields.map(answerPlace)}</div></div>`;

const answerPlace = ({ kind, label, options }: Field): TemplateResult =>
  kind === 'choice'
    ? html`<span class="sheet-answer">${label}: ${options.map(
        ({ title }) =>
          html`<span class="sheet-option"><span class="sheet-box"></span> ${title}</span>`,
      )}</span>`
    : html`<span class="sheet-answer">${label} = <span class="sheet-line"></span></span>`;

const solved = (posed: Posed, i: number, seed: number): TemplateResult =>
  html`<div class="sheet-question">${about(posed, i, `key-${seed}-${i}`)}${solution(posed)}</div>`;

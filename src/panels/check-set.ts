import { html, nothing, type TemplateResult } from 'lit';
import { live } from 'lit/directives/live.js';
import { EXERCISES } from '../check/exercises/index.ts';
import { MOST_QUESTIONS } from '../check/sets.ts';
import { SHAPES } from '../math/index.ts';
import type { ShapeKind } from '../math/shapes.ts';
import './check-set.css';
import { type Refusals, refusal, typedIn } from './refused-text.ts';

export interface SetView {
  /** How often each exercise comes, by its id. */
  readonly times: Readonly<Record<string, number>>;
  readonly shapes: readonly ShapeKind[];
  /** '' for levels that rise. */
  readonly level: string;
  readonly hints: boolean;
  readonly seed: number;
  /** A numbered set as it is, and whether its topics are shuffled; null for one that was made. */
  readonly numbered: { readonly name: string; readonly isSpread: boolean } | null;
  /** The whole address of the set's questions. */
  readonly link: string;
  readonly count: number;
  readonly refusals: Refusals;
  readonly files: readonly CourseFile[];
  readonly sheets: Sheets;
  /** Sheets that are made; null while none are. */
  readonly making: { readonly done: number; readonly total: number } | null;
  readonly packages: Packages;
  /** The file that is put together, in words; '' while none is. */
  readonly saving: string;
}

export interface SetTools {
  times(exercise: string, text: string): void;
  shape(kind: ShapeKind, wanted: boolean): void;
  level(level: string): void;
  hints(offered: boolean): void;
  seed(text: string): void;
  copy(): void;
  open(): void;
  /** Saves a file for a course system. */
  save(id: string): void;
  own(wanted: boolean): void;
  pass(text: string): void;
  sheets(change: Partial<Pick<Sheets, 'paper' | 'key'>>): void;
  sheetSeed(end: 'from' | 'to', text: string): void;
  print(): void;
}

/** Which sheets are printed: those of the seeds from one to another. */
export interface Sheets {
  readonly from: number;
  readonly to: number;
  readonly paper: 'a4' | 'letter';
  readonly key: boolean;
}

/** What packages say beside the set. */
export interface Packages {
  /** Percent of right questions from which it is passed. */
  readonly pass: number;
  /** Whether each student has own numbers. */
  readonly own: boolean;
}

/** A file for a course system, and what is in it. */
export interface CourseFile {
  readonly id: string;
  readonly title: string;
  readonly says: string;
}

/** The form in which a lecturer makes a set, and its link. */
export function setForm(view: SetView, tools: SetTools): TemplateResult {
  const { numbered } = view;
  const keepsOrder = numbered?.isSpread === false;
  return html`<form class="set-form" @submit=${(event: Event) => event.preventDefault()}>
    <h2>Make a set</h2>
    <p class="set-about">Say how often each exercise comes, and about which shapes. The link holds
      all of it, and poses the same questions for ever: ${
        keepsOrder
          ? `this is ${numbered?.name} as it always was. What is changed makes a set with `
          : ''
      }topics in an order of the seed’s, right answers spread evenly over what is possible.</p>
    <fieldset class="set-exercises"><legend>Exercises: ${view.count} of at most
      ${MOST_QUESTIONS} questions</legend>
      <ul>${EXERCISES.map(({ id, topic }) => exerciseRow(id, topic, view, tools))}</ul>
    </fieldset>
    <fieldset><legend>Shapes</legend>
      <div class="set-choices">${SHAPES.map(
        ({ kind, title }) => html`<label><input type="checkbox"
          .checked=${live(view.shapes.includes(kind))}
          @change=${(event: Event) => tools.shape(kind, (event.target as HTMLInputElement).checked)}
        /> ${title}</label>`,
      )}</div>
      ${refusal(view.refusals, 'shapes')}
    </fieldset>
    <fieldset><legend>Beside</legend>
      <div class="set-choices">
        <label>numbers <select @change=${(event: Event) =>
          tools.level((event.target as HTMLSelectElement).value)}>
          <option value="" ?selected=${view.level === ''}>rise from easy to hard</option>
          <option value="1" ?selected=${view.level === '1'}>easy (level 1)</option>
          <option value="2" ?selected=${view.level === '2'}>larger (level 2)</option>
          <option value="3" ?selected=${view.level === '3'}>with halves (level 3)</option>
        </select></label>
        <label><input type="checkbox" .checked=${view.hints}
          @change=${(event: Event) => tools.hints((event.target as HTMLInputElement).checked)}
        /> hints and solutions</label>
        <label>seed <input class="set-seed" inputmode="numeric" .value=${String(view.seed)}
          @change=${(event: Event) => tools.seed(typedIn(event))}
        /></label>
      </div>
      ${refusal(view.refusals, 'beside')}${refusal(view.refusals, 'seed')}
    </fieldset>
    <label class="set-link">Link <input readonly .value=${view.link} /></label>
    <div class="buttons">
      <button type="button" class="button primary" @click=${tools.copy}>Copy the link</button>
      <button type="button" class="button" @click=${tools.open}>Open its questions</button>
    </div>
    ${
      numbered
        ? nothing
        : html`<p class="tolerance">On that page students give a name or number: each gets numbers
      of their own by it, which you get back from the same name and seed.</p>`
    }
    ${sheetFields(view, tools)}
    <fieldset><legend>Files for course systems</legend>
      <p class="set-about">For the questions of this seed; in SCORM and xAPI, if you like, with each
        student’s own numbers. Nothing is sent by this page: a file is saved on this device, and
        nothing of students is in it.</p>
      <ul class="set-files">${view.files.map(
        ({ id, title, says }) => html`<li><button type="button" class="button"
          ?disabled=${view.saving !== ''}
          @click=${() => tools.save(id)}>${title}</button> <span>${says}</span></li>`,
      )}</ul>
      <div class="set-choices">
        <label>SCORM and xAPI: passed from <input class="set-pass" inputmode="decimal"
          .value=${String(view.packages.pass)}
          @change=${(event: Event) => tools.pass(typedIn(event))} /> % right on</label>
        <label><input type="checkbox" .checked=${view.packages.own}
          @change=${(event: Event) => tools.own((event.target as HTMLInputElement).checked)}
        /> own numbers for each student, by the id that the course system has</label>
      </div>
      ${refusal(view.refusals, 'pass')}${refusal(view.refusals, 'file')}
      <span data-say>${view.saving || nothing}</span>
    </fieldset>
  </form>`;
}

function exerciseRow(id: string, topic: string, view: SetView, tools: SetTools): TemplateResult {
  const now = view.times[id] ?? 0;
  return html`<li data-exercise=${id}><label for=${`times-${id}`}>${topic}</label>
    <input id=${`times-${id}`} inputmode="numeric" .value=${String(now)}
      @change=${(event: Event) => tools.times(id, typedIn(event))}
    />${refusal(view.refusals, id)}</li>`;
}

function sheetFields({ sheets, making, refusals }: SetView, tools: SetTools): TemplateResult {
  const number = (key: 'from' | 'to', label: string): TemplateResult => html`<label>${label}
    <input class="set-seed" inputmode="numeric" .value=${String(sheets[key])}
      @change=${(event: Event) => tools.sheetSeed(key, typedIn(event))}
    /></label>`;
  return html`<fieldset><legend>On paper</legend>
    <p class="set-about">A sheet for each seed, with space for working; then, if wanted, the key
      with worked solutions. The browser’s own command prints the same, also into a PDF.</p>
    <div class="set-choices">
      ${number('from', 'seeds from')} ${number('to', 'to')}
      <label>paper <select @change=${(event: Event) =>
        tools.sheets({ paper: (event.target as HTMLSelectElement).value as Sheets['paper'] })}>
        <option value="a4" ?selected=${sheets.paper === 'a4'}>A4</option>
        <option value="letter" ?selected=${sheets.paper === 'letter'}>Letter</option>
      </select></label>
      <label><input type="checkbox" .checked=${sheets.key}
        @change=${(event: Event) =>
          tools.sheets({ key: (event.target as HTMLInputElement).checked })}
      /> with the key</label>
    </div>
    ${refusal(refusals, 'from')}${refusal(refusals, 'to')}
    <div class="buttons"><button type="button" class="button" ?disabled=${making !== null}
      @click=${tools.print}>Print the sheets</button>
      <span data-say>${making ? `sheet ${making.done} of ${making.total}` : nothing}</span>
    </div>
  </fieldset>`;
}

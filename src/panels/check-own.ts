import { html, nothing, type TemplateResult } from 'lit';
import type { Texts } from '../check/grade.ts';
import { FOUR_DIGITS_WORDS } from '../check/grade.ts';
import { editedLines } from '../check/lines.ts';
import { type OwnLine, type OwnReport, ownFields } from '../check/own-numbers.ts';
import type { Input } from '../check/types.ts';
import { definitionOf } from '../math/shapes.ts';
import { ids, namedCauses, whereAndWhat } from './check-feedback.ts';
import { type FieldView, fieldRow } from './check-field.ts';
import { inputRow } from './check-given.ts';
import { derivationLines } from './check-lines.ts';

interface OwnView {
  readonly input: Input;
  readonly texts: Texts;
  /** Null until the student asks. */
  readonly report: OwnReport | null;
}

interface OwnTools {
  type(field: string, text: string): void;
  check(): void;
  clear(): void;
}

const MARKS: Readonly<Record<OwnLine['verdict'], readonly [FieldView['glyph'], string]>> = {
  correct: ['=', 'right'],
  absent: ['=', 'right: it does not exist'],
  rounded: ['≈', ''],
  wrong: ['≠', 'not right'],
  follows: ['→', 'right for your earlier values'],
  invalid: ['?', ''],
};

/** The note on a line. */
const says = (line: OwnLine | undefined): string => line?.note ?? '';

/** A student's own derivation, line by line; empty lines are not marked. */
export function ownNumbers({ input, texts, report }: OwnView, tools: OwnTools): TemplateResult {
  const lineOf = (id: string): OwnLine | undefined =>
    report?.lines.find(({ field }) => field.id === id);
  return html`<form class="answers own" @submit=${(event: Event) => {
    event.preventDefault();
    tools.check();
  }}>
    <p class="ask"
    >Type what you have for this ${definitionOf(input.shape).title} and ray, as far as you got. A
    dash says that a quantity does not exist.</p>
    ${inputRow(input)}
    <div class="own-fields">${ownFields(input).map((field) => {
      const line = lineOf(field.id);
      const [glyph, words] = line ? MARKS[line.verdict] : ['' as const, ''];
      return fieldRow({
        field,
        id: `own-${field.id}`,
        text: texts[field.id] ?? '',
        mark: [words, says(line)].filter(Boolean).join(': '),
        glyph,
        invalid: line?.verdict === 'invalid',
        onText: (text) => tools.type(field.id, text),
      });
    })}</div>
    <div class="commit">
      <button type="submit" class="button primary">Check my numbers</button>
      <button type="button" class="button" @click=${tools.clear}>Clear</button>
      <span class="tolerance">${FOUR_DIGITS_WORDS}</span>
    </div>
    <div data-say>${report ? verdict(report, input) : nothing}</div>
  </form>`;
}

function verdict(report: OwnReport, input: Input): TemplateResult {
  const { says, firstWrong, causes, way } = report;
  const edited = editedLines(causes, input);
  return html`<div class="feedback" data-verdict=${firstWrong ? 'wrong' : 'correct'}
    data-cause=${ids(causes) || nothing}>
    <p class="verdict"><span class="glyph"
      aria-hidden="true">${firstWrong ? '≠' : '='}</span> ${says}</p>
    ${way ? html`<p>What is marked right is right with ${way.says}.</p>` : nothing}
    ${causes.length > 0 ? html`<p>${namedCauses(causes)}</p>` : nothing}
    ${causes.map((cause) => html`<p>${whereAndWhat(cause, causes.length > 1)}</p>`)}
    ${edited.length > 0 ? derivationLines(edited, 'numbers') : nothing}
  </div>`;
}

import { html, nothing, type TemplateResult } from 'lit';
import { askedOf, givenName } from '../check/asked.ts';
import type { Posed } from '../check/compose.ts';
import type { Answer, Input } from '../check/types.ts';
import type { Vec3 } from '../math/index.ts';
import { definitionOf } from '../math/shapes.ts';
import { display, displayTriple } from '../text/format.ts';
import { symbol } from './formula.ts';
import { classOf } from './symbols.ts';

/** Significant digits; more than the usual six, since the numbers are copied onto paper. */
const DIGITS = 8;

const text = (value: unknown): string => {
  if (Array.isArray(value)) return displayTriple(value as unknown as Vec3, DIGITS);
  return typeof value === 'number' ? display(value, DIGITS) : String(value);
};

/** E, d and the shape's parameters in their colours; `unknown` is the symbol that is asked for. */
export function inputRow({ shape, ray }: Input, unknown: string | null = null): TemplateResult {
  const { params, title } = definitionOf(shape);
  const given = shape as unknown as Readonly<Record<string, unknown>>;
  return html`<ul class="given" aria-label=${`The ray and the ${title}`}>
    ${item('E', 'vector', text(ray.origin))} ${item('d', 'vector', text(ray.direction))}
    ${params.map(({ symbol: letter, key, type }) =>
      item(
        letter,
        type === 'vector' ? 'vector' : 'scalar',
        key === unknown ? '?' : text(given[key]),
      ),
    )}
  </ul>`;
}

/** All that a question gives: ray and shape, quantities of the derivation, and what is told. */
export function givenLines(posed: Posed): TemplateResult {
  const { input, unknown, told } = askedOf(posed);
  const known = Object.entries(posed.given);
  const { origin } = posed.draft.ray;
  return html`${
    input === 'all'
      ? inputRow(posed.draft, unknown)
      : input === 'E'
        ? html`<ul class="given" aria-label="The camera">${item('E', 'vector', text(origin))}</ul>`
        : nothing
  }${
    told.length === 0
      ? nothing
      : html`<dl class="told-lines">${told.map(
          ({ name, says }) => html`<div><dt>${name}</dt><dd>${says}</dd></div>`,
        )}</dl>`
  }${
    known.length === 0
      ? nothing
      : html`<ul class="given told" aria-label="Also given">${known.map(
          ([id, answer]) => html`<li>${givenName(id)} = ${shownAnswer(answer)}</li>`,
        )}</ul>`
  }`;
}

function item(letter: string, sort: 'vector' | 'scalar', words: string): TemplateResult {
  const cls = classOf(letter, sort);
  const name = /^[a-zA-Z]$/.test(letter)
    ? symbol(letter, null, cls, letter)
    : html`<span>normal along</span>`;
  return html`<li>${name}${/^[a-zA-Z]$/.test(letter) ? ' = ' : ' '}<span
    class=${cls}>${words}</span></li>`;
}

/** An answer in `DIGITS` digits. */
export const shownAnswer = (answer: Answer): string => {
  if (typeof answer === 'number') return display(answer, DIGITS);
  return typeof answer === 'object' ? displayTriple(answer, DIGITS) : answer;
};

import { html, mathml, nothing, type TemplateResult } from 'lit';
import { allHold } from '../../lesson/condition.ts';
import type { Block, FormulaPart, Inline, Prose } from '../../lesson/prose.ts';
import { formula } from '../../panels/formula.ts';
import { classOf, highlightOf } from '../../panels/symbols.ts';
import type { ExploreModel } from '../../state/derive.ts';
import { shortest } from '../../text/format.ts';

/** A value with the text that the page shows for it. */
export interface ShownValue {
  readonly value: number | string;
  readonly text: string;
}

/** What the prose needs from the page. */
export interface ProseTools {
  /** The value that is shown beside the prose; null if there is none. */
  readonly value: (quantity: string) => ShownValue | null;
  /** Whether a quantity is hidden. */
  readonly isHidden: (quantity: string) => boolean;
  /** The model for conditions; null on other pages than Explore, where no condition holds. */
  readonly model: ExploreModel | null;
  readonly slider: () => TemplateResult | typeof nothing;
  /**
   * The largest number of digits a live number had in this step, so that it never gets narrower.
   */
  readonly room: (quantity: string, digits: number) => number;
}

export function proseView(prose: Prose, tools: ProseTools): TemplateResult {
  return html`${prose.map((block) => (isShown(block, tools) ? blockView(block, tools) : nothing))}`;
}

function isShown({ when }: Block, { model }: ProseTools): boolean {
  if (when.length === 0) return true;
  // Conditional text is hidden with the results: it would give them away.
  return model?.shown.hits === true && allHold(when, model);
}

function blockView(block: Block, tools: ProseTools): TemplateResult | typeof nothing {
  switch (block.type) {
    case 'paragraph':
      return html`<p>${inlines(block.inside, tools)}</p>`;
    case 'display':
      return html`<p class="lesson-display">${formulaView(block.parts, tools, withFractions)}</p>`;
    case 'list': {
      const items = block.items.map((item) => html`<li>${inlines(item, tools)}</li>`);
      return block.ordered ? html`<ol>${items}</ol>` : html`<ul>${items}</ul>`;
    }
    case 'code':
      return html`<pre><code>${block.text}</code></pre>`;
    case 'slider':
      return tools.slider();
  }
}

/** The parts of a line; a full stop after a number or formula is kept on its line. */
function inlines(parts: readonly Inline[], tools: ProseTools): TemplateResult[] {
  const told = parts.filter(({ type }) => type !== 'claims');
  return told.map((part, i) => {
    const stop = stopOf(told[i + 1]);
    if (stop !== '' && isMath(part)) {
      return html`<span class="kept">${inlineView(part, tools)}${stop}</span>`;
    }
    if (part.type === 'text' && isMath(told[i - 1])) {
      return html`${part.text.slice(stopOf(part).length)}`;
    }
    return inlineView(part, tools);
  });
}

const isMath = (part: Inline | undefined): boolean =>
  part?.type === 'live' || part?.type === 'formula';

const stopOf = (part: Inline | undefined): string =>
  part?.type === 'text' ? (part.text.match(/^[.,;:!?)]+/)?.[0] ?? '') : '';

function inlineView(part: Inline, tools: ProseTools): TemplateResult {
  switch (part.type) {
    case 'text':
      return html`${part.text}`;
    case 'strong':
      return html`<strong>${inlines(part.inside, tools)}</strong>`;
    case 'em':
      return html`<em>${inlines(part.inside, tools)}</em>`;
    case 'link':
      return html`<a href=${part.href} rel="noreferrer">${inlines(part.inside, tools)}</a>`;
    case 'formula':
      return formulaView(part.parts, tools);
    case 'live':
      return liveView(part.quantity, tools);
    case 'break':
      return html`<br />`;
    case 'claims':
      return html``;
  }
}

/** Largest number of parts of a formula that is never broken. */
const SHORT = 8;
const isSign = (part: FormulaPart | undefined, signs: RegExp): boolean =>
  part?.type === 'sign' && signs.test(part.text);

/** A formula that may be broken after a comma and, if it is long, before a relation. */
function formulaView(
  parts: readonly FormulaPart[],
  tools: ProseTools,
  rowsOf: (parts: readonly FormulaPart[], tools: ProseTools) => TemplateResult[] = raised,
): TemplateResult {
  const pieces: { readonly parts: FormulaPart[]; readonly after: string }[] = [];
  let piece: FormulaPart[] = [];
  const end = (after: string): void => {
    if (piece.length > 0) pieces.push({ parts: piece, after });
    piece = [];
  };
  for (const part of parts) {
    if (parts.length > SHORT && isSign(part, /^[=<>≤≥≠]$/)) end('');
    piece.push(part);
    if (isSign(part, /^,$/)) end(' ');
  }
  end('');
  return html`<span class="lesson-formula">${pieces.map(
    ({ parts, after }) => html`<wbr />${formula(mathml`${rowsOf(parts, tools)}`)}${after}`,
  )}</span>`;
}

/** Writes "X / Y" as a fraction; each side ends at a sign outside of brackets. */
function withFractions(parts: readonly FormulaPart[], tools: ProseTools): TemplateResult[] {
  const at = parts.findIndex((part) => isSign(part, /^\/$/));
  if (at < 0) return raised(parts, tools);
  const from = at - sideOf(parts.slice(0, at).reverse(), /^\)$/);
  const to = at + 1 + sideOf(parts.slice(at + 1), /^\($/);
  const [above, below] = [parts.slice(from, at), parts.slice(at + 1, to)].map((side) =>
    raised(isBracketed(side) ? side.slice(1, -1) : side, tools),
  );
  return [
    ...raised(parts.slice(0, from), tools),
    mathml`<mstyle displaystyle="true"
      ><mfrac><mrow>${above}</mrow><mrow>${below}</mrow></mfrac></mstyle>`,
    ...withFractions(parts.slice(to), tools),
  ];
}

const isBracketed = (side: readonly FormulaPart[]): boolean =>
  isSign(side[0], /^\($/) && isSign(side.at(-1), /^\)$/);

/** Number of parts that belong to a side of a fraction, counted from the stroke outwards. */
function sideOf(parts: readonly FormulaPart[], opening: RegExp): number {
  let depth = 0;
  for (const [i, part] of parts.entries()) {
    if (depth === 0 && isSign(part, /^[=<>≤≥≠,+−±/]$/)) return i;
    if (isSign(part, /^[()]$/)) depth += isSign(part, opening) ? 1 : -1;
  }
  return parts.length;
}

const isRoot = (part: FormulaPart | undefined): boolean =>
  part?.type === 'sign' && part.text === '√';

/** Typesets roots, which cover the next part, and powers, which belong to the part before. */
function raised(parts: readonly FormulaPart[], tools: ProseTools): TemplateResult[] {
  const rows: TemplateResult[] = [];
  for (const [i, part] of parts.entries()) {
    if (isRoot(parts[i - 1])) {
      rows.push(
        mathml`<msqrt>${part.type === 'power' ? nothing : partView(part, tools, false)}</msqrt>`,
      );
      continue;
    }
    if (isRoot(part) && i + 1 < parts.length) continue;
    const base = part.type === 'power' ? rows.pop() : undefined;
    if (part.type === 'power') {
      rows.push(mathml`<msup><mrow>${base ?? nothing}</mrow><mn>${part.text}</mn></msup>`);
    } else rows.push(partView(part, tools, isPrefix(parts, i)));
  }
  return rows;
}

/** Whether the sign is a prefix and not an operator between two operands. */
const isPrefix = (parts: readonly FormulaPart[], i: number): boolean =>
  isSign(parts[i], /^\($/) ||
  (isSign(parts[i], /^[−+±√]$/) && (i === 0 || isSign(parts[i - 1], /^[(=<>≤≥≠,/·]$/)));

function partView(
  part: Exclude<FormulaPart, { type: 'power' }>,
  tools: ProseTools,
  prefix: boolean,
): TemplateResult {
  switch (part.type) {
    case 'symbol':
      return symbolView(part.base, part.index);
    case 'number':
      return mathml`<mn>${part.text}</mn>`;
    case 'live':
      return liveInFormula(part.quantity, tools);
    case 'sign':
      return mathml`<mo form=${prefix ? 'prefix' : part.text === ')' ? 'postfix' : 'infix'}
        lspace=${part.text === '.' ? '0' : nothing} rspace=${part.text === '.' ? '0' : nothing}
        stretchy="false">${part.text}</mo>`;
  }
}

/** Classes of the symbols of hits. */
const COLOURS: Readonly<Record<string, string>> = { t: 'sym sym-hit', P: 'sym sym-hit' };

function symbolView(base: string, index: string): TemplateResult {
  if (index === '') {
    const sort = /^[EdNPV]$/.test(base) ? 'vector' : 'scalar';
    return mathml`<mi class=${classOf(base, sort)}
      data-symbol=${highlightOf(base, sort)}>${base}</mi>`;
  }
  const ofHit = /^\d$/.test(index);
  const cls = ofHit
    ? (COLOURS[base] ?? (base === 'N' ? 'sym sym-normal' : 'sym'))
    : classOf(base, 'vector');
  const lights = ofHit ? `${base}${index}` : base;
  const below = ofHit ? mathml`<mn>${index}</mn>` : mathml`<mi>${index}</mi>`;
  return mathml`<msub class=${cls} data-symbol=${lights}><mi>${base}</mi>${below}</msub>`;
}

interface Live {
  readonly text: string;
  readonly quantity: string | typeof nothing;
  readonly value: string | typeof nothing;
  readonly cls: string;
  readonly lights: string;
}

/** A live number as the page shows it: six digits, all of them in data-value. */
function liveOf(name: string, tools: ProseTools): Live {
  const cls = colourOf(name);
  const lights = lightsOf(name);
  if (tools.isHidden(name)) return { text: '?', quantity: nothing, value: nothing, cls, lights };
  const shown = tools.value(name);
  if (!shown) return { text: '–', quantity: nothing, value: nothing, cls, lights };
  const { value, text } = shown;
  const full = typeof value === 'number' ? shortest(value) : value;
  return { text, quantity: name, value: full, cls, lights };
}

/** The quantity without the row of a table: "t1" for "textbook.t1". */
const withoutRow = (name: string): string => name.replace(/^[a-z][\w-]{2,}\./, '');

function colourOf(name: string): string {
  const [letter = '', axis] = withoutRow(name).split('.');
  if (/^[tP]\d$/.test(letter)) return 'sym sym-hit';
  if (/^N\d$/.test(letter)) return 'sym sym-normal';
  return classOf(letter, axis === undefined ? 'scalar' : 'vector');
}

function lightsOf(name: string): string {
  const symbol = withoutRow(name);
  return symbol.includes('.') ? symbol : highlightOf(symbol, 'scalar');
}

function liveView(name: string, tools: ProseTools): TemplateResult {
  const { text, quantity, value, cls, lights } = liveOf(name, tools);
  const room = tools.room(name, widthOf(text));
  if (room > LONGEST_LINE || !/^[−\d.–?]/.test(text)) {
    return html`<span class="live ${cls}"
      data-symbol=${lights}
      data-quantity=${quantity}
      data-value=${value}>${text}</span>`;
  }
  return html`<span class="live room-${room} ${cls}"
    data-symbol=${lights}
    data-quantity=${quantity}
    data-value=${value}>${text}</span>`;
}

/** Largest width in digits that is kept for a number. */
const LONGEST_LINE = 12;

/** Width of a text in digits; points, spaces and signs count half. */
function widthOf(text: string): number {
  const digits = text.replace(/\D/g, '').length;
  return Math.floor(digits + (text.length - digits) / 2);
}

function liveInFormula(name: string, tools: ProseTools): TemplateResult {
  const { text, quantity, value, cls, lights } = liveOf(name, tools);
  return mathml`<mn class="live ${cls}"
    data-symbol=${lights}
    data-quantity=${quantity}
    data-value=${value}>${text}</mn>`;
}

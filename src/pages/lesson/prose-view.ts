import { html, mathml, nothing, type TemplateResult } from 'lit';
import { allHold } from '../../lesson/condition.ts';
import type { Block, FormulaPart, Inline, Prose } from '../../lesson/prose.ts';
import { formula } from '../../panels/formula.ts';
import { classOf, highlightOf } from '../../panels/symbols.ts';
import type { ExploreModel } from '../../state/derive.ts';
import { display, shortest } from '../../text/format.ts';
import { subscript } from '../../text/scripts.ts';

/** What a text needs to be shown. */
export interface ProseTools {
  /** The value that is shown beside it; null where there is none. */
  readonly value: (quantity: string) => number | string | null;
  /** Results are hidden: these numbers are not told. */
  readonly isHidden: (quantity: string) => boolean;
  /** For conditions; null on other pages than Explore, where they do not hold. */
  readonly model: ExploreModel | null;
  readonly slider: () => TemplateResult | typeof nothing;
  /** So many characters a live number has needed in this step: its place never gets narrower. */
  readonly room: (quantity: string, length: number) => number;
}

export function proseView(prose: Prose, tools: ProseTools): TemplateResult {
  return html`${prose.map((block) => (isShown(block, tools) ? blockView(block, tools) : nothing))}`;
}

function isShown({ when }: Block, { model }: ProseTools): boolean {
  if (when.length === 0) return true;
  // Which of two texts is shown would tell what is to be predicted.
  return model?.shown.hits === true && allHold(when, model);
}

function blockView(block: Block, tools: ProseTools): TemplateResult | typeof nothing {
  switch (block.type) {
    case 'paragraph':
      return html`<p>${inlines(block.inside, tools)}</p>`;
    case 'display':
      return html`<p class="lesson-display">${formulaView(block.parts, tools)}</p>`;
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

function inlines(parts: readonly Inline[], tools: ProseTools): TemplateResult[] {
  return parts.map((part) => inlineView(part, tools));
}

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

/** Broken at relations and commas, where a line may end. */
function formulaView(parts: readonly FormulaPart[], tools: ProseTools): TemplateResult {
  const pieces: FormulaPart[][] = [[]];
  for (const part of parts) {
    if (part.type === 'sign' && /^[=,<>≤≥≠]$/.test(part.text)) {
      const comma = part.text === ',';
      if (comma) pieces.at(-1)?.push(part);
      pieces.push(comma ? [] : [part]);
    } else pieces.at(-1)?.push(part);
  }
  return html`<span class="lesson-formula">${pieces
    .filter((piece) => piece.length > 0)
    .map((piece) => html`<wbr />${formula(mathml`${raised(piece, tools)}`)}`)}</span>`;
}

const isRoot = (part: FormulaPart | undefined): boolean =>
  part?.type === 'sign' && part.text === '√';

/** A root reaches over the next part; a power belongs to the part before it. */
function raised(parts: readonly FormulaPart[], tools: ProseTools): TemplateResult[] {
  const rows: TemplateResult[] = [];
  for (const [i, part] of parts.entries()) {
    if (isRoot(parts[i - 1])) {
      rows.push(mathml`<msqrt>${part.type === 'power' ? nothing : partView(part, tools)}</msqrt>`);
      continue;
    }
    if (isRoot(part) && i + 1 < parts.length) continue;
    const base = part.type === 'power' ? rows.pop() : undefined;
    if (part.type === 'power') {
      rows.push(mathml`<msup><mrow>${base ?? nothing}</mrow><mn>${part.text}</mn></msup>`);
    } else rows.push(partView(part, tools));
  }
  return rows;
}

function partView(part: Exclude<FormulaPart, { type: 'power' }>, tools: ProseTools) {
  switch (part.type) {
    case 'symbol':
      return symbolView(part.base, part.index);
    case 'number':
      return mathml`<mn>${part.text}</mn>`;
    case 'live':
      return liveInFormula(part.quantity, tools);
    case 'sign':
      return mathml`<mo form=${/^[−+±√]$/.test(part.text) ? 'infix' : nothing}
        stretchy="false">${part.text}</mo>`;
  }
}

/** N of a hit, but the plane's own N without an index. */
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

/** The number as the page shows it: six digits, all of them in data-value. */
function liveOf(name: string, tools: ProseTools): Live {
  const cls = colourOf(name);
  const lights = lightsOf(name);
  if (tools.isHidden(name)) return { text: '?', quantity: nothing, value: nothing, cls, lights };
  const value = tools.value(name);
  if (value === null) return { text: '–', quantity: nothing, value: nothing, cls, lights };
  const full = typeof value === 'number' ? shortest(value) : value;
  const text = typeof value === 'number' ? display(value) : value;
  return { text, quantity: name, value: full, cls, lights };
}

function colourOf(name: string): string {
  const [letter = '', axis] = name.split('.');
  if (/^[tP]\d$/.test(letter)) return 'sym sym-hit';
  if (/^N\d$/.test(letter)) return 'sym sym-normal';
  return classOf(letter, axis === undefined ? 'scalar' : 'vector');
}

const lightsOf = (name: string): string =>
  name.includes('.') ? name : highlightOf(name, 'scalar');

function liveView(name: string, tools: ProseTools): TemplateResult {
  const { text, quantity, value, cls, lights } = liveOf(name, tools);
  if (tools.room(name, text.length) > LONGEST_LINE || !/^[−\d.–?]/.test(text)) {
    return html`<span class="live ${cls}"
      data-symbol=${lights}
      data-quantity=${quantity}
      data-value=${value}>${text}</span>`;
  }
  return html`<span class="live room-${tools.room(name, text.length)} ${cls}"
    data-symbol=${lights}
    data-quantity=${quantity}
    data-value=${value}>${text}</span>`;
}

/** Of more characters no place is kept. */
const LONGEST_LINE = 12;

function liveInFormula(name: string, tools: ProseTools): TemplateResult {
  const { text, quantity, value, cls, lights } = liveOf(name, tools);
  return mathml`<mn class="live ${cls}"
    data-symbol=${lights}
    data-quantity=${quantity}
    data-value=${value}>${text}</mn>`;
}

/** "t₁" for reading aloud and for labels of what is asked. */
export const spokenName = (quantity: string): string =>
  quantity.replace(/^([tPN])([12])/, (_, letter, n) => `${letter}${subscript(Number(n))}`);

import { html, nothing, svg, type TemplateResult } from 'lit';
import { guard } from 'lit/directives/guard.js';
import type { Hit, Intersection, Vec3 } from '../math/index.ts';
import { AXES } from '../math/shapes.ts';
import type { ExploreModel } from '../state/derive.ts';
import type { HitRole } from '../state/scene-model.ts';
import type { HitWords } from '../state/verdict-words.ts';
import { rootTexts } from '../text/distinguish.ts';
import { display } from '../text/format.ts';
import { symbol } from './formula.ts';
import { value } from './value.ts';

/** "8 →", the ghost's number before this ray's; nothing if they are the same as printed. */
export function was(before: number | null | undefined, now: number): unknown {
  const text = display(before ?? now);
  if (text === display(now)) return nothing;
  return html`<span class="was"><span class="visually-hidden">before </span>${text} → </span>`;
}

/** A column group for each root, with rows t, P and N whose components are aligned. */
export function hitTable({ hits, found, exactly, digits, before }: ExploreModel): TemplateResult {
  const texts = rootTexts(hits.map(({ t }) => t));
  const gap = digits?.rootGap(found, exactly) ?? null;
  const beside: Beside = digits?.exactBeside ?? (() => null);
  return html`<div class="hits" data-count=${hits.length}>
    ${hits.map((words, i) =>
      column(words, hitOf(words, i, found), {
        text: texts[i] ?? null,
        exact: exactHit(words, i, found, exactly.found),
        beside,
        was: was(before[`t${words.index}`], words.t),
      }),
    )}
    ${gap === null ? nothing : html`<p class="gap beside">${gap}</p>`}
  </div>`;
}

function hitOf(words: HitWords, i: number, found: Intersection): Hit | null {
  if (words.role !== 'outside') return found.hits[i] ?? null;
  return found.details.family === 'flat' ? found.details.plane : null;
}

/** The same hit in exact arithmetic; null if its class differs. */
function exactHit(words: HitWords, i: number, found: Intersection, exact: Intersection) {
  return exact.class === found.class ? hitOf(words, i, exact) : null;
}

type Beside = (value: number, rounded: number) => string | null;

interface Shown {
  /** t as printed; null for the usual digits. */
  readonly text: string | null;
  readonly exact: Hit | null;
  readonly beside: Beside;
  /** The ghost's root with an arrow. */
  readonly was: unknown;
}

function column({ index, role, text, t }: HitWords, hit: Hit | null, shown: Shown): TemplateResult {
  const { exact, beside } = shown;
  const n = String(index);
  const rejected = role === 'outside';
  const exactT = exact && beside(t, exact.t);
  return html`<section class="hit hit-${role}" role="group"
    data-fate=${role === 'cut' ? 'cut' : nothing}
    aria-label=${`Root ${index}: ${text}`}>
    <p class="chip"
      data-symbol=${`t${n}`}>${mark(role)}${indexed('t', n)} ${text}</p>
    <p class="row t" data-symbol=${`t${n}`}>
      <span class="name">${indexed('t', n)}</span>
      ${rejected ? nothing : shown.was}
      ${value(rejected ? 't' : `t${n}`, t, { text: shown.text, keeps: true })}
      ${exactT ? html`<span class="beside">exact: ${exactT}</span>` : nothing}
    </p>
    ${hit ? row('P', n, hit.point, exact?.point, rejected ? 'X' : `P${n}`, beside) : nothing}
    ${hit && !rejected ? normalRow(n, hit, exact, beside) : nothing}
  </section>`;
}

/** t₁, P₁, N₁ */
const indexed = (letter: 't' | 'P' | 'N', n: string): unknown =>
  guard([n], () => symbol(letter, n, letter === 'N' ? 'sym sym-normal' : 'sym', letter + n));

/** Largest number of characters of three numbers in half the panel's width. */
const LENGTH = 27;

/** The coordinates, and below them exact ones if their shown digits differ. */
function row(
  letter: 'P' | 'N',
  n: string,
  v: Vec3,
  exact: Vec3 | undefined,
  quantity: string,
  exactly: Beside,
): TemplateResult {
  const beside = AXES.flatMap((axis, i) => {
    const text = exact && exactly(v[i] ?? 0, exact[i] ?? 0);
    return text ? [`${axis} ${text}`] : [];
  });
  const length = v.reduce((sum, x) => sum + display(x).length, 0);
  return html`<p class="row ${letter} ${length > LENGTH ? 'fine' : ''}"
    data-symbol=${`${letter}${n}`}>
    <span class="name">${indexed(letter, n)}</span>
    ${AXES.map((axis, i) => value(`${quantity}.${axis}`, v[i] ?? 0))}
    ${beside.length > 0 ? html`<span class="beside">exact: ${beside.join(', ')}</span>` : nothing}
  </p>`;
}

function normalRow(
  n: string,
  { normal, singular }: Hit,
  exact: Hit | null,
  beside: Beside,
): TemplateResult {
  if (!singular) return row('N', n, normal, exact?.normal, `N${n}`, beside);
  return html`<p class="row N">
    <span class="name">${indexed('N', n)}</span>
    <span class="none">zero: no normal at this point</span>
  </p>`;
}

/** The hit's mark as in the scene and on the graph: a disc, a ring or a cross. */
function mark(role: HitRole): TemplateResult {
  const drawn =
    role === 'first' || role === 'other'
      ? svg`<circle r="5.4" class=${role} />`
      : svg`<path d="M-5-5L5 5M-5 5L5-5" class="cross" />`;
  return html`<svg class="mark" viewBox="-8 -8 16 16" width="15" height="15"
    aria-hidden="true">${drawn}</svg>`;
}

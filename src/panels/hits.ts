import { html, nothing, svg, type TemplateResult } from 'lit';
import type { Hit } from '../math/intersection.ts';
import { AXES, type Vec3 } from '../math/vec3.ts';
import type { ExploreModel } from '../state/derive.ts';
import type { HitRole } from '../state/scene-model.ts';
import type { HitWords } from '../state/words.ts';
import { symbol } from './formula.ts';
import { value } from './value.ts';

/** One column group a root, rows t, P and N, so that x, y and z stand under each other. */
export function hitTable({ hits, found }: ExploreModel): TemplateResult {
  return html`<div class="hits" data-count=${hits.length}>
    ${hits.map((words, i) => column(words, hitOf(words, i, found), hits.length === 1 ? 16 : 9))}
  </div>`;
}

function hitOf(words: HitWords, i: number, found: ExploreModel['found']): Hit | null {
  if (words.role !== 'outside') return found.hits[i] ?? null;
  return found.details.family === 'flat' ? found.details.plane : null;
}

/** `room`: characters that a number has space for. */
function column({ index, role, text, t }: HitWords, hit: Hit | null, room: number): TemplateResult {
  const n = String(index);
  const rejected = role === 'outside';
  return html`<section class="hit hit-${role}" aria-label=${`Root ${index}: ${text}`}>
    <p class="chip" data-symbol=${`t${n}`}>${mark(role)}${symbol('t', n, 'sym', `t${n}`)} ${text}</p>
    <p class="row t" data-symbol=${`t${n}`}>
      <span class="name">${symbol('t', n, 'sym', `t${n}`)}</span>
      ${value(rejected ? 't' : `t${n}`, t)}
    </p>
    ${hit ? row('P', n, hit.point, rejected ? 'X' : `P${n}`, room) : nothing}
    ${hit && !rejected ? normalRow(n, hit, room) : nothing}
  </section>`;
}

function row(
  letter: 'P' | 'N',
  n: string,
  v: Vec3,
  quantity: string,
  room: number,
): TemplateResult {
  const cls = letter === 'N' ? 'sym sym-normal' : 'sym';
  return html`<p class="row ${letter}" data-symbol=${`${letter}${n}`}>
    <span class="name">${symbol(letter, n, cls, `${letter}${n}`)}</span>
    ${AXES.map((axis, i) => value(`${quantity}.${axis}`, v[i] ?? 0, room))}
  </p>`;
}

function normalRow(n: string, { normal, singular }: Hit, room: number): TemplateResult {
  if (!singular) return row('N', n, normal, `N${n}`, room);
  return html`<p class="row N">
    <span class="name">${symbol('N', n, 'sym sym-normal', `N${n}`)}</span>
    <span class="none">zero: no normal at this point</span>
  </p>`;
}

/** The same mark as in the scene and on the strip: a disc, a ring, or a cross. */
function mark(role: HitRole): TemplateResult {
  const drawn =
    role === 'first' || role === 'other'
      ? svg`<circle r="5.4" class=${role} />`
      : svg`<path d="M-5-5L5 5M-5 5L5-5" class="cross" />`;
  return html`<svg class="mark" viewBox="-8 -8 16 16" width="15" height="15" aria-hidden="true">${drawn}</svg>`;
}

import { html, nothing, svg, type TemplateResult } from 'lit';
import { exploreLink } from '../state/explore-link.ts';
import type { PixelRay } from '../state/picture/camera-lines.ts';
import type { RootFate } from '../state/picture/root-fates.ts';
import { type SurfaceStep, surfaceSteps } from '../state/picture/surface-steps.ts';
import { RAY_WORDS, type TreeRow } from '../state/picture/tree-rows.ts';
import { display, shortest } from '../text/format.ts';
import type { RayKind } from '../tracer/types.ts';
import { formula } from './formula.ts';
import { cameraRay } from './picture-camera-ray.ts';
import { typesetNumbers, typesetSymbols } from './typeset.ts';
import './picture-pixel.css';

interface PixelModel {
  /** The pixel, its camera ray and how many it has, and the camera. */
  readonly of: PixelRay;
  readonly rows: readonly TreeRow[];
  /** The left side's rows of the same pixel; null without a comparison. */
  readonly left: readonly TreeRow[] | null;
  readonly leftWords: string;
  readonly rightWords: string;
  readonly method: string;
  readonly leftMethod: string;
  /** The path of the row whose algebra is shown. */
  readonly chosen: string | null;
  readonly opened: ReadonlySet<string>;
  /** The path of the ray that is played; those after it are not there yet. Null for all rays. */
  readonly played: string | null;
}

interface PixelTools {
  sample(index: number): void;
  choose(path: string): void;
  toggle(path: string): void;
  close(): void;
  /** Copies how the pixel becomes its ray. */
  copy(as: 'latex' | 'mathml'): void;
}

/** The rays of a pixel, each with where it ended; of two pictures side by side. */
export function pixelPanel(model: PixelModel, tools: PixelTools): TemplateResult {
  const { rows, left, chosen } = model;
  const [x, y] = model.of.pixel;
  const paths = [...new Set([...rows, ...(left ?? [])].map(({ path }) => path))];
  const both = left ? paths.sort(byPath) : paths;
  const later = model.played === null ? both.length : both.indexOf(model.played) + 1;
  const find = (list: readonly TreeRow[] | null, path: string): TreeRow | undefined =>
    list?.find((row) => row.path === path);
  const row = chosen === null ? undefined : find(rows, chosen);
  const other = chosen === null ? undefined : find(left, chosen);
  const open = row ?? rows[0];
  return html`<div class="pixel-head">
      <h2><svg class="pixel-sign" viewBox="0 0 14 14" width="13" height="13"
        aria-hidden="true"><rect x="2" y="2" width="10" height="10" /></svg> Pixel ${x}, ${y}</h2>
      ${samplePicker(model, tools)}
      <span class="pixel-links">${
        open ? openLink(open, model.method, 'Open this ray in Explore') : nothing
      }
      <button type="button" class="textual" @click=${tools.close}>close</button></span>
    </div>
    <div class="rays-room" tabindex="0" role="region" aria-label="rays of the pixel"><table
      class="rays">
      <thead class=${left ? '' : 'visually-hidden'}><tr>
        <th scope="col"><span class="visually-hidden">ray</span></th>
        ${left ? html`<th scope="col">${model.leftWords}</th>` : nothing}
        <th scope="col">${
          left
            ? model.rightWords
            : html`<span
          class="visually-hidden">what became of it</span>`
        }</th>
        <th scope="col" class="weight">weight</th>
      </tr></thead>
      <tbody>
        ${both.map((path, i) =>
          line(path, find(rows, path), find(left, path), i >= later, model, tools),
        )}
      </tbody>
    </table></div>
    ${left && both.some((path) => isAcne(find(left, path), find(rows, path))) ? LESSON : nothing}
    ${row?.kind === 'camera' ? cameraRay(model.of, tools.copy) : nothing}
    ${row ? algebraOf(row, other, model) : nothing}`;
}

function line(
  path: string,
  right: TreeRow | undefined,
  left: TreeRow | undefined,
  isLater: boolean,
  model: PixelModel,
  tools: PixelTools,
): TemplateResult | typeof nothing {
  const row = right ?? left;
  if (!row) return nothing;
  const same = left && right && text(left) === text(right);
  const words = RAY_WORDS[row.kind];
  return html`<tr data-ray=${path} data-kind=${row.kind}
    class=${isLater ? 'later' : path === (model.played ?? model.chosen) ? 'chosen' : ''}>
    <th scope="row" class="depth-${Math.min(row.depth, 6)}">
      <button type="button" class="ray-name" aria-pressed=${model.chosen === path}
        @click=${() => tools.choose(path)}>${swatch(row.kind)} ${
          row.group ? html`${row.group.count} shadow rays` : words
        }</button>
      ${
        row.group
          ? html`<button type="button" class="textual"
        aria-expanded=${model.opened.has(path)}
          @click=${() => tools.toggle(path)}>${model.opened.has(path) ? 'fold' : 'each'}</button>`
          : nothing
      }
    </th>
    ${model.left ? html`<td>${left ? outcome(left) : none()}</td>` : nothing}
    <td>${same ? 'the same' : right ? outcome(right, row.t) : none()}</td>
    <td class="weight" data-quantity="weight"
      data-value=${shortest(row.weight)}>${weightWords(row.weight)}</td>
  </tr>`;
}

/** Whether a shadow ray is blocked by the surface it leaves on one side only: shadow acne. */
function isAcne(a: TreeRow | undefined, b: TreeRow | undefined): boolean {
  const own = (row: TreeRow | undefined): boolean =>
    row?.node.end.end === 'blocked' && row.node.end.surface === row.node.from;
  return a?.kind === 'shadow' && b?.kind === 'shadow' && own(a) !== own(b);
}

const LESSON = html`<p
  class="pixel-lesson"
  >More digits do not cure this: the stored point is rounded, and lies a little inside.</p>`;

const text = (row: TreeRow): string => row.verdict + row.rest;
const none = (): TemplateResult => html`<span class="none">no such ray</span>`;

function outcome({ verdict, rest }: TreeRow, t: number | null = null): TemplateResult {
  const value = t !== null && Number.isFinite(t) ? shortest(t) : nothing;
  return html`<span data-quantity=${value === nothing ? nothing : 't'}
    data-value=${value}><strong>${verdict}</strong>${rest}</span>`;
}

function weightWords(weight: number): string {
  return weight >= 0.9995 ? 'all' : `${display(100 * weight, weight < 0.01 ? 2 : 3)} %`;
}

function samplePicker({ of }: PixelModel, tools: PixelTools): TemplateResult {
  const { sample, samples } = of;
  if (samples === 1) return html`<span class="pixel-note">its ray and what that fires</span>`;
  const options = Array.from({ length: samples }, (_, i) => i);
  return html`<label class="pixel-note">ray
    <select @change=${(e: Event) => tools.sample(Number((e.target as HTMLSelectElement).value))}>
      ${options.map(
        (i) => html`<option value=${i}
        ?selected=${i === sample}>${i + 1} of ${samples}</option>`,
      )}
    </select></label>`;
}

/** A line of this kind of ray, dashed as in the space view. */
function swatch(kind: RayKind): TemplateResult {
  return html`<svg class="ray-swatch ray-${kind}" viewBox="0 0 34 6" width="34" height="6"
    aria-hidden="true">${svg`<path d="M0 3H34" />`}</svg>`;
}

function openLink(row: TreeRow, method: string, words: string): TemplateResult | typeof nothing {
  if (!row.opens) return nothing;
  return html`<a class="textual"
    href=${exploreLink(row.opens.shape, row.ray, method, row.opens)}>${words}</a>`;
}

/** The algebra of the surface where the chosen ray ends, by the method that traced it. */
function algebraOf(row: TreeRow, left: TreeRow | undefined, model: PixelModel): TemplateResult {
  const { node } = row;
  const steps = row.shape ? surfaceSteps(row.shape, row.rootFilter, model.method) : null;
  return html`<section class="hit-algebra" aria-label="Algebra of the chosen ray">
    ${
      steps
        ? html`<p class="hit-equation">${RAY_WORDS[row.kind]}, put into the
            ${steps.title}: ${formula(typesetSymbols(steps.f))} = 0</p>
          ${steps.lines.map((line) => stepLine(line, row, model.method))}
          <p class="hit-verdict">${steps.verdict}</p>
          ${steps.roots.map(rootLine)}`
        : nothing
    }
    ${
      node.end.end === 'hit'
        ? html`<p>point ${triple(node.end.point)}, normal ${triple(node.end.normal)}</p>`
        : nothing
    }
    ${
      left && left.t !== null && row.t !== null && !Object.is(left.t, row.t)
        ? html`<p>left t = ${shortest(left.t)}, right t = ${shortest(row.t)}</p>`
        : nothing
    }
    <p>${openLink(row, model.method, `Open this ${RAY_WORDS[row.kind]} in Explore`)}</p>
  </section>`;
}

function rootLine({ index, t, fate, words }: RootFate): TemplateResult {
  return html`<p class="hit-root" data-fate=${fate} data-quantity=${`t${index}`}
    data-value=${shortest(t)}>${words}</p>`;
}

function stepLine(
  { step, numbers, put }: SurfaceStep,
  { shape, ray, rootFilter: { between } }: TreeRow,
  method: string,
): TemplateResult {
  const { id, letter, expr, worked, value, why: derive } = step;
  const name = letter ? html`${formula(typesetSymbols(letter))} = ` : nothing;
  const sign = put?.isFaithful === false ? '≈' : '=';
  const line = put
    ? formula(typesetNumbers(expr, numbers, { worked, digits: put.digits }))
    : 'a number of it is beyond the doubles';
  return html`<p class="hit-step"
    data-step=${id}>${name}${formula(typesetSymbols(expr))} ${sign} ${line}${
      value === null
        ? nothing
        : html` ${sign} <span class="result" data-quantity=${id} data-value=${shortest(value)}
        title=${shortest(value)}>${display(value)}</span>`
    } ${
      shape
        ? html`<a class="why" aria-label=${`why ${id}, in Explore`}
          href=${exploreLink(shape, ray, method, { between, derive })}>why</a>`
        : nothing
    }</p>`;
}

const triple = (v: readonly [number, number, number]): string =>
  `(${v.map((x) => display(x)).join(', ')})`;

function byPath(a: string, b: string): number {
  const numbers = (path: string) => path.split('.').map((part) => Number.parseInt(part, 10));
  const [p, q] = [numbers(a), numbers(b)];
  for (let i = 0; i < Math.min(p.length, q.length); i++) {
    if (p[i] !== q[i]) return (p[i] ?? 0) - (q[i] ?? 0);
  }
  return p.length - q.length;
}

import { html, nothing, type TemplateResult } from 'lit';
import { algebra } from '../../panels/algebra.ts';
import { endsLines } from '../../panels/ends.ts';
import { formula, symbol } from '../../panels/formula.ts';
import { normalLine } from '../../panels/normal-line.ts';
import { rayHandles, shapeHandles } from '../../panels/params-of.ts';
import { classOf } from '../../panels/symbols.ts';
import { typesetRelation } from '../../panels/typeset.ts';
import { type ExploreModel, type FullModel, isFull } from '../../state/derive.ts';
import { encode } from '../../state/url.ts';
import { display } from '../../text/format.ts';
import { drawScene, graphOf, linkHead, sceneFrame } from './parts.ts';
import { type Handout, printsAs } from './print.ts';

const SCENE = { width: 680, height: 226 };
const GRAPH = { width: 680, height: 110 };

const untouched = (): void => {};

/** Registers a handout of Explore, which is printed while `shown` returns a model. */
export function printExplore(shown: () => ExploreModel | null): void {
  printsAs(() => {
    const model = shown();
    return model && isFull(model) ? exploreHandout(model) : null;
  });
}

/** What Explore shows, on a sheet of paper: what is hidden on the page is hidden here too. */
function exploreHandout(model: FullModel): Handout {
  return {
    content: html`<article class="handout-explore">
      ${linkHead(heading(model), encode(model.state))}
      ${sceneFrame('explore')}${graphOf(model, 'explore', GRAPH)}
      ${given(model)}${algebra(model, untouched, normalLine, endsLines)}
    </article>`,
    drawn: (root) => drawScene(root, 'explore', model.scene, SCENE),
  };
}

/** The example's title, question and, if it is told, answer; of another ray they say nothing. */
function heading({ example, title, state }: ExploreModel): TemplateResult {
  const shown = example && !example.changed && state.revealed === null ? example.entry : null;
  if (!shown) return html`<h1>A ray and a ${title}</h1>`;
  return html`<h1>${shown.title}</h1>
    <p class="handout-caption">${shown.asks}${state.told ? html` ${shown.answer}` : nothing}</p>`;
}

/** The equation of the surface, and all that can be moved. */
function given(model: ExploreModel): TemplateResult {
  const handles = [...rayHandles(model, untouched), ...shapeHandles(model, untouched)];
  return html`<p class="handout-given">
    <span>${formula(typesetRelation(model.derivation.surface))}</span>
    ${handles.map(({ param, value }) => {
      const { symbol: letter, type } = param;
      const cls = classOf(letter, type === 'vector' ? 'vector' : 'scalar');
      const name = type === 'axis' ? 'normal along' : symbol(letter, null, cls, letter);
      const is = type === 'axis' ? ' ' : ' = ';
      return html`<span>${name}${is}${shown(value)}</span>`;
    })}
  </p>`;
}

function shown(value: unknown): string {
  if (typeof value === 'number') return display(value);
  return Array.isArray(value) ? `(${value.map((x) => display(x)).join(', ')})` : String(value);
}

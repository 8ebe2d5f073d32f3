import { html, type TemplateResult } from 'lit';
import { drawStill } from '../../canvas/thumbnail.ts';
import { stillGraph } from '../../charts/graph-view.ts';
import '../../charts/graph.css';
import '../../canvas/scene.css';
import type { FullModel } from '../../state/derive.ts';
import type { SceneModel } from '../../state/scene-model.ts';
import { qrCode } from './qr-code.ts';

/** In CSS pixels; handout.css has the same sizes of type. */
const EM = 11;
const LABEL = 19;
const MARK = 0.84;

/** The element into which drawScene draws. */
export const sceneFrame = (name: string): TemplateResult =>
  html`<div class="handout-scene" data-drawing=${name}></div>`;

/** The scene as lines, into its frame. */
export function drawScene(
  root: HTMLElement,
  name: string,
  scene: SceneModel,
  size: { readonly width: number; readonly height: number },
): void {
  const host = root.querySelector<HTMLElement>(`[data-drawing="${CSS.escape(name)}"]`);
  if (host) drawStill(host, scene, { ...size, scale: MARK, label: LABEL });
}

/** The graph of f; nothing while results are hidden, which it would show. */
export function graphOf(
  { graph }: FullModel,
  name: string,
  size: { readonly width: number; readonly height: number },
): TemplateResult {
  if (graph.concealed) return html``;
  const metrics = { ...size, em: EM, mark: MARK };
  const drawn = stillGraph(graph, metrics, `paper-${name}`);
  return html`<div class="handout-graph graph">${drawn}</div>`;
}

/** The head of a sheet, with the link as text and as a code. */
export function linkHead(head: TemplateResult, hash: string): TemplateResult {
  const link = `${location.href.split(/[?#]/)[0]}${hash}`;
  return html`<header class="handout-head">
    <div>${head}<p class="handout-link"><a href=${link}>${link}</a></p></div>
    ${qrCode(link)}
  </header>`;
}

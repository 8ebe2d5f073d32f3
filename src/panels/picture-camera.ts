import { html, nothing, type TemplateResult } from 'lit';
import './picture-camera.css';

interface CameraLine {
  /** Whether to say how the camera is moved. */
  readonly hint: boolean;
  /** Rays a pixel traced at rest, no fewer at edges; null if the picture is not refined. */
  readonly done: { readonly everywhere: number; readonly edges: number } | null;
  readonly most: number;
  readonly refines: boolean;
  stop(): void;
}

/** Over the picture: how the camera is moved, and how fine the picture has become. */
export function cameraLine({ hint, done, most, refines, stop }: CameraLine): TemplateResult {
  const how = html`<p class="camera-hint"><span aria-hidden="true">⟲</span>
    <span class="by-mouse"><b>drag</b> turns, <b>Shift</b> + drag moves, <b>wheel</b> or pinch comes
      nearer</span>
    <span class="by-finger"><b>sideways</b> turns, <b>two fingers</b> move and come
      nearer</span></p>`;
  return html`${hint ? how : nothing}${done?.edges ? rest(done) : nothing}`;

  function rest({ everywhere, edges }: NonNullable<typeof done>): TemplateResult {
    const words = raysWords(everywhere, edges, refines ? ` of ${most}` : '');
    const bar = html`<svg viewBox="0 0 72 6" width="72" height="6" aria-hidden="true"><rect
      class="all" width="72" height="6" /><rect width=${(72 * everywhere) / most} height="6"
      /></svg> <span class="at-rest">at rest: </span>`;
    return html`<p class="camera-rest" data-quantity="rest" data-value=${everywhere}
      data-edges=${edges}>${refines ? bar : nothing}${words}${
        refines
          ? html` <button type="button" class="textual" @click=${stop}>stop</button>`
          : nothing
      }</p>`;
  }
}

/** '3 of 16 rays a pixel at edges', '2 rays a pixel, 4 at edges', '16 rays a pixel'. */
function raysWords(everywhere: number, edges: number, most: string): string {
  const rays = (n: number): string => `${n}${most} ${n === 1 && !most ? 'ray' : 'rays'} a pixel`;
  if (everywhere === 0) return `${rays(edges)} at edges`;
  return everywhere < edges ? `${rays(everywhere)}, ${edges} at edges` : rays(everywhere);
}

import { html, nothing, type TemplateResult } from 'lit';
import './picture-camera.css';

interface CameraLine {
  /** Whether to say how the camera is moved. */
  readonly hint: boolean;
  /** Rays a pixel that the picture has at rest; null if it is not refined. */
  readonly done: number | null;
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
  return html`${hint ? how : nothing}${done === null || done === 0 ? nothing : rest()}`;

  function rest(): TemplateResult {
    const words = refines ? `at rest: ${done} of ${most} rays a pixel` : `${done} rays a pixel`;
    return html`<p class="camera-rest" data-quantity="rest" data-value=${done}>${
      refines
        ? html`<svg viewBox="0 0 72 6" width="72" height="6" aria-hidden="true"><rect class="all"
          width="72" height="6" /><rect width=${(72 * (done ?? 0)) / most} height="6" /></svg>`
        : nothing
    } ${words}${
      refines ? html` <button type="button" class="textual" @click=${stop}>stop</button>` : nothing
    }</p>`;
  }
}

import { html, type TemplateResult } from 'lit';
import { comparisonWords } from '../../panels/picture-compare.ts';
import { pictureStatus } from '../../panels/picture-status.ts';
import type { ScenePreset } from '../../scene/presets/define.ts';
import { findPreset } from '../../scene/presets/index.ts';
import type { PictureModel } from './picture-model.ts';
import type { TraceQueue } from './trace-queue.ts';

/** The line below the picture: how far it is, why this scene, or what the comparison found. */
export function statusLine(
  model: PictureModel,
  traceQueue: TraceQueue,
  moves: boolean,
  compare: () => void,
): TemplateResult {
  const { picture, requests, main, other, comparison, trustsLeft } = model;
  const current = traceQueue.current();
  const what = current?.key === requests.main.key ? 'tracing' : 'tracing to compare';
  const running = current && traceQueue.seen(current);
  const { against, scene, sceneText } = picture;
  const middle = against
    ? comparisonWords(scene, requests.main.settings, against, { found: comparison, trustsLeft })
    : reasonWords(findPreset(sceneText), `${scene.title}, edited`, compare);
  return pictureStatus(moves ? null : (running ?? main), what, middle, other);
}

/** What there is to see, and the comparison that shows it. */
function reasonWords(
  preset: ScenePreset | undefined,
  otherwise: string,
  compare: () => void,
): TemplateResult {
  if (!preset?.compare) return html`<p>${preset?.reason ?? otherwise}</p>`;
  return html`<p>${preset.reason} <button type="button" class="textual"
    @click=${compare}>with and without</button></p>`;
}

import { html, type TemplateResult } from 'lit';
import { comparisonWords } from '../../panels/picture-compare.ts';
import { pictureStatus } from '../../panels/picture-status.ts';
import { findPreset } from '../../scene/presets/index.ts';
import type { PictureModel } from './picture-model.ts';
import type { TraceQueue } from './trace-queue.ts';

/** The line below the picture: how far it is, why this scene, or what the comparison found. */
export function statusLine(
  model: PictureModel,
  traceQueue: TraceQueue,
  moves: boolean,
): TemplateResult {
  const { picture, requests, main, other, comparison, trustsLeft } = model;
  const current = traceQueue.current();
  const what = current?.key === requests.main.key ? 'tracing' : 'tracing to compare';
  const running = current && traceQueue.seen(current);
  const { against, scene, sceneText } = picture;
  const middle = against
    ? comparisonWords(requests.main.settings, against, { found: comparison, trustsLeft })
    : html`<p>${findPreset(sceneText)?.reason ?? `${scene.title}, edited`}</p>`;
  return pictureStatus(moves ? null : (running ?? main), what, middle, other);
}

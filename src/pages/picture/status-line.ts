import { html, type TemplateResult } from 'lit';
import { type CompareTools, comparisonWords } from '../../panels/picture-compare.ts';
import { pictureStatus } from '../../panels/picture-status.ts';
import { findPreset } from '../../scene/presets/index.ts';
import type { PictureModel } from './picture-model.ts';
import type { TraceQueue } from './trace-queue.ts';

/** The line below the picture: how far it is, why this scene, or what the comparison found. */
export function statusLine(
  model: PictureModel,
  traceQueue: TraceQueue,
  tools: CompareTools,
): TemplateResult {
  const { picture, requests, main, other, comparison, trustsLeft } = model;
  const current = traceQueue.current();
  const what = current?.key === requests.main.key ? 'tracing' : 'tracing to compare';
  const running = current && traceQueue.seen(current);
  const { against, show, scene, sceneText } = picture;
  const middle = against
    ? comparisonWords(
        requests.main.settings,
        against,
        { found: comparison, trustsLeft, show },
        tools,
      )
    : html`<p>${findPreset(sceneText)?.reason ?? `${scene.title}, edited`}</p>`;
  return pictureStatus(running ?? main, what, middle, other);
}

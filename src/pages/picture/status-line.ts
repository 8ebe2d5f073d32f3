import { html, type TemplateResult } from 'lit';
import { type CompareTools, comparisonWords } from '../../panels/picture-compare.ts';
import { pictureStatus } from '../../panels/picture-status.ts';
import { findPreset } from '../../scene/presets/index.ts';
import type { Sight } from './picture-model.ts';
import type { Darkroom } from './trace-queue.ts';

/** The line below the picture: how far it is, why this scene, or what the comparison found. */
export function below(sight: Sight, darkroom: Darkroom, tools: CompareTools): TemplateResult {
  const { picture, shots, main, other, comparison, trustsLeft } = sight;
  const current = darkroom.current();
  const what = current?.key === shots.main.key ? 'tracing' : 'tracing to compare';
  const running = current && darkroom.seen(current);
  const { against, show, scene, sceneText } = picture;
  const middle = against
    ? comparisonWords(shots.main.settings, against, { found: comparison, trustsLeft, show }, tools)
    : html`<p>${findPreset(sceneText)?.reason ?? `${scene.title}, edited`}</p>`;
  return pictureStatus(running ?? main, what, middle, other);
}

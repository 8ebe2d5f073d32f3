import { html, nothing, type TemplateResult } from 'lit';
import { EARLIER, PRESETS } from '../scene/presets/index.ts';
import { isPacked } from '../state/picture/scene-link.ts';
import {
  LIGHT_SAMPLES,
  type PictureKey,
  type PictureSettings,
  SAMPLES,
  SIZES,
} from '../state/picture/settings.ts';
import './picture-bar.css';

interface BarTools {
  set(values: Readonly<Partial<Record<PictureKey, string>>>): void;
  compare(): void;
  again(): void;
  cancel(): void;
  readonly isTracing: boolean;
  /** Whether a light of the scene has a size, so that its number of rays can be chosen. */
  readonly hasSoftLight: boolean;
}

/** The bar above the picture: scene, size, samples, and buttons. */
export function pictureBar(picture: PictureSettings, tools: BarTools): TemplateResult {
  const { sceneText, scene, width, height, samples, lightSamples, against } = picture;
  const size = `${width}x${height}`;
  const sizes: readonly string[] = SIZES.includes(size as never) ? SIZES : [...SIZES, size];
  return html`<div class="bar-choices">
      <label class="choice-scene"><span class="visually-hidden">scene:</span>
        <select
          @change=${(e: Event) => tools.set({ scene: chosenIn(e), pixel: '', on: '', off: '' })}>
          ${
            isPacked(sceneText)
              ? html`<option value=${sceneText}
            selected>${scene.title}, edited</option>`
              : nothing
          }
          ${EARLIER.filter(({ id }) => id === sceneText).map(
            ({ id, scene: before }) => html`<option value=${id}
            selected>${before.title}, as it was</option>`,
          )}
          ${PRESETS.map(
            ({ id, scene: preset }) => html`<option value=${id}
            ?selected=${id === sceneText}>${preset.title}</option>`,
          )}
        </select></label>
      ${picker(
        'size',
        sizes.map((text) => [text, text.replace('x', ' × ')]),
        size,
        (text) => tools.set({ size: text, pixel: '' }),
      )}
      ${picker(
        'rays a pixel',
        SAMPLES.map((n) => [String(n), n === 1 ? '1 ray a pixel' : `${n} rays a pixel`]),
        String(samples),
        (text) => tools.set({ samples: text }),
      )}
      ${
        tools.hasSoftLight
          ? picker(
              'rays to a light with a size',
              LIGHT_SAMPLES.map((n) => [String(n), `${n} to a light`]),
              String(lightSamples),
              (text) => tools.set({ light: text }),
            )
          : nothing
      }
    </div>
    <div class="bar-acts">
      <button type="button" class="plain-button" aria-pressed=${against !== null}
        @click=${tools.compare}>Compare</button>
      ${
        tools.isTracing
          ? html`<button type="button" class="plain-button primary"
            @click=${tools.cancel}>Cancel</button>`
          : html`<button type="button" class="plain-button primary"
            @click=${tools.again}>Trace again</button>`
      }
    </div>`;
}

function picker(
  label: string,
  options: readonly (readonly [value: string, words: string])[],
  current: string,
  pick: (value: string) => void,
): TemplateResult {
  return html`<select aria-label=${label} @change=${(e: Event) => pick(chosenIn(e))}>
    ${options.map(
      ([value, words]) => html`<option value=${value}
      ?selected=${value === current}>${words}</option>`,
    )}
  </select>`;
}

const chosenIn = (event: Event): string => (event.target as HTMLSelectElement).value;

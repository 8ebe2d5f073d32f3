import { html, type TemplateResult } from 'lit';
import type { Camera, Scene } from '../scene/types.ts';
import { refusalOf } from '../state/picture/edits.ts';
import { colourField, numberField, tripleField } from './picture-fields.ts';

export function cameraForm(scene: Scene, change: (scene: Scene) => void): TemplateResult {
  const { camera } = scene;
  const put = (next: Camera): Scene => ({ ...scene, camera: next });
  const check = (next: Camera): string | null => refusalOf(put(next));
  const send = (next: Camera): void => change(put(next));
  return html`${tripleField({
    label: 'eye',
    value: camera.eye,
    step: 0.1,
    check: (eye) => check({ ...camera, eye }),
    send: (eye) => send({ ...camera, eye }),
  })}
  ${tripleField({
    label: 'looks at',
    value: camera.target,
    step: 0.1,
    check: (target) => check({ ...camera, target }),
    send: (target) => send({ ...camera, target }),
  })}
  ${numberField({
    label: 'angle in °',
    value: camera.angle,
    range: [5, 100],
    step: 1,
    check: (angle) => check({ ...camera, angle }),
    send: (angle) => send({ ...camera, angle }),
  })}`;
}

export function worldForm(scene: Scene, change: (scene: Scene) => void): TemplateResult {
  const { background } = scene;
  return html`<div class="field-line">
      ${colourField('straight down', background.low, (low) => change({ ...scene, background: { ...background, low } }))}
      ${colourField('straight up', background.high, (high) => change({ ...scene, background: { ...background, high } }))}
    </div>
    ${numberField({
      label: 'light from all sides',
      value: scene.ambient,
      range: [0, 1],
      step: 0.05,
      check: (ambient) => refusalOf({ ...scene, ambient }),
      send: (ambient) => change({ ...scene, ambient }),
    })}`;
}

import { html, type TemplateResult } from 'lit';
import type { Background, Camera, Scene } from '../scene/types.ts';
import { refusalOf } from '../state/picture/edits.ts';
import { effectFields } from './picture-effect-fields.ts';
import { type ChangeScene, colourField, numberField, tripleField } from './picture-fields.ts';

export function cameraForm(scene: Scene, change: ChangeScene): TemplateResult {
  const { camera } = scene;
  const as =
    (edit: (now: Camera) => Camera) =>
    (now: Scene): Scene => ({ ...now, camera: edit(now.camera) });
  const check = (edit: (now: Camera) => Camera): string | null => refusalOf(as(edit)(scene));
  const send = (edit: (now: Camera) => Camera): void => change(as(edit));
  const place = (label: string, key: 'eye' | 'target'): TemplateResult =>
    tripleField({
      label,
      value: camera[key],
      step: 0.1,
      check: (edit) => check((now) => ({ ...now, [key]: edit(now[key]) })),
      send: (edit) => send((now) => ({ ...now, [key]: edit(now[key]) })),
    });
  return html`${place('eye', 'eye')} ${place('looks at', 'target')}
  ${numberField({
    label: 'angle in °',
    value: camera.angle,
    range: [5, 100],
    step: 1,
    check: (angle) => check((now) => ({ ...now, angle })),
    send: (angle) => send((now) => ({ ...now, angle })),
  })}`;
}

export function worldForm(scene: Scene, change: ChangeScene): TemplateResult {
  const { background } = scene;
  const colour = (label: string, key: keyof Background): TemplateResult =>
    colourField(label, background[key], (value) =>
      change((now) => ({ ...now, background: { ...now.background, [key]: value } })),
    );
  return html`<div class="field-line">
      ${colour('straight down', 'low')} ${colour('straight up', 'high')}
    </div>
    ${numberField({
      label: 'light from all sides',
      value: scene.ambient,
      range: [0, 1],
      step: 0.05,
      check: (ambient) => refusalOf({ ...scene, ambient }),
      send: (ambient) => change((now) => ({ ...now, ambient })),
    })}
    ${effectFields('scene', scene, { check: (edit) => refusalOf(edit(scene)), send: change })}`;
}

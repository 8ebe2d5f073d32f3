import { html, nothing, type TemplateResult } from 'lit';
import type { Vec3 } from '../math/index.ts';
import { changeLight } from '../scene/edit.ts';
import type { Light, Scene } from '../scene/types.ts';
import { asLight, LIGHT_KINDS, LIGHT_WORDS, refusalOf } from '../state/picture/edits.ts';
import { effectFields } from './picture-effect-fields.ts';
import {
  type ChangeScene,
  choiceField,
  colourField,
  numberField,
  tripleField,
} from './picture-fields.ts';

type Edit = (now: Light) => Light;

/** Kind, colour, strength and place of a light. */
export function lightForm(scene: Scene, light: Light, change: ChangeScene): TemplateResult {
  const check = (edit: Edit): string | null => refusalOf(changeLight(scene, light.id, edit));
  const send = (edit: Edit): void => change((now) => changeLight(now, light.id, edit));
  const number = (
    label: 'strength' | 'radius',
    value: number,
    range: readonly [number, number],
  ): TemplateResult =>
    numberField({
      ...{ label, value, range },
      step: 0.05,
      check: (x) => check((now) => ({ ...now, [label]: x })),
      send: (x) => send((now) => ({ ...now, [label]: x })),
    });
  const triple = (label: 'towards' | 'at', value: Vec3): TemplateResult => {
    // If the light has another kind when the edit arrives, it has no such vector and is kept.
    const as =
      (edit: (now: Vec3) => Vec3): Edit =>
      (now) => {
        const given = (now as Partial<Readonly<Record<typeof label, Vec3>>>)[label];
        return given ? { ...now, [label]: edit(given) } : now;
      };
    return tripleField({
      ...{ label, value },
      step: 0.1,
      check: (edit) => check(as(edit)),
      send: (edit) => send(as(edit)),
    });
  };
  return html`<div class="field-line">
      ${choiceField(
        'kind',
        LIGHT_KINDS.map((kind) => [kind, LIGHT_WORDS[kind]] as const),
        light.light,
        (kind) =>
          change((now) =>
            changeLight(now, light.id, (one) => asLight(one, kind, now.camera.target)),
          ),
      )}
      ${colourField('colour', light.colour, (colour) => send((now) => ({ ...now, colour })))}
    </div>
    ${number('strength', light.strength, [0, 2])}
    ${light.light === 'sun' ? triple('towards', light.towards) : triple('at', light.at)}
    ${light.light === 'sphere' ? number('radius', light.radius, [0.05, 3]) : nothing}
    ${effectFields('light', light, { check, send })}`;
}

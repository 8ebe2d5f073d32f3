import { html, nothing, type TemplateResult } from 'lit';
import { changeLight } from '../scene/edit.ts';
import type { Light, Scene } from '../scene/types.ts';
import { asLight, LIGHT_KINDS, LIGHT_WORDS, refusalOf } from '../state/picture/edits.ts';
import { choiceField, colourField, numberField, tripleField } from './picture-fields.ts';

/** Kind, colour, strength and place of a light. */
export function lightForm(
  scene: Scene,
  light: Light,
  change: (scene: Scene) => void,
): TemplateResult {
  const put = (next: Light): Scene => changeLight(scene, light.id, () => next);
  const check = (next: Light): string | null => refusalOf(put(next));
  const send = (next: Light): void => {
    if (check(next) === null) change(put(next));
  };
  return html`<div class="field-line">
      ${choiceField(
        'kind',
        LIGHT_KINDS.map((kind) => [kind, LIGHT_WORDS[kind]] as const),
        light.light,
        (kind) => send(asLight(light, kind, scene.camera.target)),
      )}
      ${colourField('colour', light.colour, (colour) => send({ ...light, colour }))}
    </div>
    ${numberField({
      label: 'strength',
      value: light.strength,
      range: [0, 2],
      step: 0.05,
      check: (strength) => check({ ...light, strength }),
      send: (strength) => send({ ...light, strength }),
    })}
    ${
      light.light === 'sun'
        ? tripleField({
            label: 'towards',
            value: light.towards,
            step: 0.1,
            check: (towards) => check({ ...light, towards }),
            send: (towards) => send({ ...light, towards }),
          })
        : tripleField({
            label: 'at',
            value: light.at,
            step: 0.1,
            check: (at) => check({ ...light, at }),
            send: (at) => send({ ...light, at }),
          })
    }
    ${
      light.light === 'sphere'
        ? numberField({
            label: 'radius',
            value: light.radius,
            range: [0.05, 3],
            step: 0.05,
            check: (radius) => check({ ...light, radius }),
            send: (radius) => send({ ...light, radius }),
          })
        : nothing
    }`;
}

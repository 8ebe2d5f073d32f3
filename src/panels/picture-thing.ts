import { html, nothing, type TemplateResult } from 'lit';
import { definitionOf } from '../math/shapes/lookup.ts';
import { AXES } from '../math/vec3.ts';
import { changeThing } from '../scene/edit.ts';
import type { Material, Paint, Placed, Scene } from '../scene/types.ts';
import {
  canBeCapped,
  refusalOf,
  withGlass,
  withHeights,
  withParam,
  withPattern,
} from '../state/picture/edits.ts';
import { initialShape, paramValue } from '../state/state.ts';
import { paramRow } from './param-rows.ts';
import {
  checkField,
  choiceField,
  colourField,
  numberField,
  tripleField,
} from './picture-fields.ts';

const PATTERNS = [
  ['plain', 'one colour'],
  ['checker', 'checker'],
  ['stripes', 'stripes'],
] as const satisfies readonly (readonly [Paint['pattern'], string])[];

/** Shape, heights and material of a thing. */
export function thingForm(
  scene: Scene,
  thing: Placed,
  change: (scene: Scene) => void,
): TemplateResult {
  const put = (next: Placed): Scene => changeThing(scene, thing.id, () => next);
  const send = (next: Placed): void => {
    if (refusalOf(put(next)) === null) change(put(next));
  };
  const initial = initialShape(thing.shape.kind);
  return html`${definitionOf(thing.shape).params.map((param) =>
    paramRow({
      param,
      value: paramValue(thing.shape, param.key),
      send: (value) => send(withParam(thing, param, value)),
      reset: () => send(withParam(thing, param, paramValue(initial, param.key))),
      quantities: true,
    }),
  )}
  ${heights(thing, put, send)}${materialForm(thing, put, send)}`;
}

type Put = (next: Placed) => Scene;
type Send = (next: Placed) => void;

function heights(thing: Placed, put: Put, send: Send): TemplateResult {
  const { between, capped } = thing;
  return html`<div class="field-line">
    ${checkField('only between two heights', between !== undefined, (on) => send(withHeights(thing, on)))}
    ${between && canBeCapped(thing.shape) ? checkField('closed by circles', capped ?? false, (on) => send({ ...thing, capped: on })) : nothing}
  </div>
  ${
    between
      ? html`<div class="field-pair">${(['from y', 'to y'] as const).map((label, i) => {
          const changed = (y: number): Placed => ({
            ...thing,
            between: i === 0 ? [y, between[1]] : [between[0], y],
          });
          return numberField({
            label,
            value: between[i] ?? 0,
            range: [-5, 5],
            step: 0.1,
            check: (y) => refusalOf(put(changed(y))),
            send: (y) => send(changed(y)),
          });
        })}</div>`
      : nothing
  }`;
}

function materialForm(thing: Placed, put: Put, send: Send): TemplateResult {
  const { material } = thing;
  const { paint, shine, mirror, glass } = material;
  const as = (next: Material): Placed => ({ ...thing, material: next });
  const share = (label: string, value: number, next: (x: number) => Material): TemplateResult =>
    numberField({
      label,
      value,
      range: [0, 1],
      step: 0.05,
      check: (x) => refusalOf(put(as(next(x)))),
      send: (x) => send(as(next(x))),
    });
  return html`<div class="field-line">
      ${choiceField('paint', PATTERNS, paint.pattern, (pattern) => send(as(withPattern(material, pattern))))}
      ${colourField('colour', paint.colour, (colour) => send(as({ ...material, paint: { ...paint, colour } })))}
      ${paint.pattern === 'plain' ? nothing : colourField('and', paint.other, (other) => send(as({ ...material, paint: { ...paint, other } })))}
      ${
        paint.pattern === 'stripes'
          ? choiceField(
              'across',
              AXES.map((axis) => [axis, axis] as const),
              paint.axis,
              (axis) => send(as({ ...material, paint: { ...paint, axis } })),
            )
          : nothing
      }
    </div>
    ${
      paint.pattern === 'plain'
        ? nothing
        : numberField({
            label: 'width',
            value: paint.size,
            range: [0.05, 4],
            step: 0.05,
            check: (size) => refusalOf(put(as({ ...material, paint: { ...paint, size } }))),
            send: (size) => send(as({ ...material, paint: { ...paint, size } })),
          })
    }
    ${share('mirror', mirror, (x) => ({ ...material, mirror: x }))}
    ${share('highlight', shine.strength, (x) => ({ ...material, shine: { ...shine, strength: x } }))}
    ${
      shine.strength > 0
        ? numberField({
            label: 'exponent',
            value: shine.exponent,
            range: [1, 200],
            step: 1,
            check: (x) => refusalOf(put(as({ ...material, shine: { ...shine, exponent: x } }))),
            send: (x) => send(as({ ...material, shine: { ...shine, exponent: x } })),
          })
        : nothing
    }
    <div class="field-line">${checkField('glass', glass !== undefined, (on) => send(as(withGlass(material, on))))}</div>
    ${
      glass
        ? html`${numberField({
            label: 'index',
            value: glass.index,
            range: [1, 2.5],
            step: 0.01,
            check: (index) => refusalOf(put(as({ ...material, glass: { ...glass, index } }))),
            send: (index) => send(as({ ...material, glass: { ...glass, index } })),
          })}
          ${tripleField({
            label: 'absorption',
            value: glass.absorption,
            names: ['R', 'G', 'B'],
            step: 0.05,
            check: (absorption) =>
              refusalOf(put(as({ ...material, glass: { ...glass, absorption } }))),
            send: (absorption) => send(as({ ...material, glass: { ...glass, absorption } })),
          })}`
        : nothing
    }`;
}

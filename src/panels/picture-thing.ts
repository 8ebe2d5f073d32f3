import { html, nothing, type TemplateResult } from 'lit';
import { AXES, definitionOf } from '../math/shapes.ts';
import { changeThing } from '../scene/edit.ts';
import type { Glass, Material, Paint, Scene, Thing } from '../scene/types.ts';
import { applied } from '../state/actions.ts';
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
import { effectFields } from './picture-effect-fields.ts';
import {
  type ChangeScene,
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

type Edit = (now: Thing) => Thing;

/**
 * `send` applies an edit to the thing when it arrives; `check` says why the drawn one refuses it.
 */
interface Tools {
  readonly send: (edit: Edit) => void;
  readonly check: (edit: Edit) => string | null;
}

/** Shape, heights and material of a thing. */
export function thingForm(scene: Scene, thing: Thing, change: ChangeScene): TemplateResult {
  const tools: Tools = {
    send: (edit) => change((now) => changeThing(now, thing.id, edit)),
    check: (edit) => refusalOf(changeThing(scene, thing.id, edit)),
  };
  const initial = initialShape(thing.shape.kind);
  return html`${definitionOf(thing.shape).params.map((param) =>
    paramRow({
      param,
      value: paramValue(thing.shape, param.key),
      send: (value) =>
        tools.send((now) =>
          withParam(now, param, applied(value, paramValue(now.shape, param.key))),
        ),
      typed: () => '',
      reset: () => tools.send((now) => withParam(now, param, paramValue(initial, param.key))),
      quantities: true,
      locked: false,
    }),
  )}
  ${heights(thing, tools)}${materialForm(thing.material, tools)}`;
}

interface Numbers {
  readonly label: string;
  readonly value: number;
  readonly range: readonly [number, number];
  readonly step: number;
}

/** A field for a number of the thing; `edit` gives the edit that sets it. */
const numberOf = (
  { send, check }: Tools,
  field: Numbers,
  edit: (x: number) => Edit,
): TemplateResult =>
  numberField({ ...field, check: (x) => check(edit(x)), send: (x) => send(edit(x)) });

function heights({ shape, between, capped }: Thing, tools: Tools): TemplateResult {
  const { send } = tools;
  return html`<div class="field-line">
    ${checkField('only between two heights', between !== undefined, (on) =>
      send((now) => withHeights(now, on)),
    )}
    ${
      between && canBeCapped(shape)
        ? checkField('closed by circles', capped ?? false, (on) =>
            send((now) => ({ ...now, capped: on })),
          )
        : nothing
    }
  </div>
  ${
    between
      ? html`<div class="field-pair">${(['from y', 'to y'] as const).map((label, i) =>
          numberOf(
            tools,
            { label, value: between[i] ?? 0, range: [-5, 5], step: 0.1 },
            (y) => (now) => {
              if (!now.between) return now;
              const [low, high] = now.between;
              return { ...now, between: i === 0 ? [y, high] : [low, y] };
            },
          ),
        )}</div>`
      : nothing
  }`;
}

function materialForm(material: Material, tools: Tools): TemplateResult {
  const { paint, shine, mirror, glass } = material;
  const of =
    (edit: (now: Material) => Material): Edit =>
    (now) => ({ ...now, material: edit(now.material) });
  // If the paint or glass was replaced meanwhile and has no such part, the scene is invalid and the
  // edit is refused.
  const painted = (part: object): Edit =>
    of((now) => ({ ...now, paint: { ...now.paint, ...part } as Paint }));
  const glassy = (edit: (now: Glass) => Glass): Edit =>
    of((now) => (now.glass ? { ...now, glass: edit(now.glass) } : now));
  const { send, check } = tools;
  const SHARE = { range: [0, 1], step: 0.05 } as const;
  return html`<div class="field-line">
      ${choiceField('paint', PATTERNS, paint.pattern, (pattern) =>
        send(of((now) => withPattern(now, pattern))),
      )}
      ${colourField('colour', paint.colour, (colour) => send(painted({ colour })))}
      ${
        paint.pattern === 'plain'
          ? nothing
          : colourField('and', paint.other, (other) => send(painted({ other })))
      }
      ${
        paint.pattern === 'stripes'
          ? choiceField(
              'across',
              AXES.map((axis) => [axis, axis] as const),
              paint.axis,
              (axis) => send(painted({ axis })),
            )
          : nothing
      }
    </div>
    ${
      paint.pattern === 'plain'
        ? nothing
        : numberOf(
            tools,
            { label: 'width', value: paint.size, range: [0.05, 4], step: 0.05 },
            (size) => painted({ size }),
          )
    }
    ${numberOf(tools, { label: 'mirror', value: mirror, ...SHARE }, (x) =>
      of((now) => ({ ...now, mirror: x })),
    )}
    ${numberOf(tools, { label: 'highlight', value: shine.strength, ...SHARE }, (strength) =>
      of((now) => ({ ...now, shine: { ...now.shine, strength } })),
    )}
    ${
      shine.strength > 0
        ? numberOf(
            tools,
            { label: 'exponent', value: shine.exponent, range: [1, 200], step: 1 },
            (exponent) => of((now) => ({ ...now, shine: { ...now.shine, exponent } })),
          )
        : nothing
    }
    <div class="field-line">${checkField('glass', glass !== undefined, (on) =>
      send(of((now) => withGlass(now, on))),
    )}</div>
    ${
      glass
        ? html`${numberOf(
            tools,
            { label: 'index', value: glass.index, range: [1, 2.5], step: 0.01 },
            (index) => glassy((now) => ({ ...now, index })),
          )}
          ${tripleField({
            label: 'absorption',
            value: glass.absorption,
            names: ['R', 'G', 'B'],
            step: 0.05,
            check: (edit) => check(glassy((now) => ({ ...now, absorption: edit(now.absorption) }))),
            send: (edit) => send(glassy((now) => ({ ...now, absorption: edit(now.absorption) }))),
          })}`
        : nothing
    }
    ${effectFields('material', material, {
      check: (edit) => check(of(edit)),
      send: (edit) => send(of(edit)),
    })}`;
}

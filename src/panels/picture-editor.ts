import { html, nothing, type TemplateResult } from 'lit';
import { live } from 'lit/directives/live.js';
import { SHAPES, type Shape } from '../math/index.ts';
import { findShape } from '../math/shapes.ts';
import { addLight, addThing } from '../scene/edit.ts';
import { nameIn, wordFor } from '../scene/names.ts';
import type { Scene, Thing } from '../scene/types.ts';
import { DRAG_PLANES, type DragPlane } from '../state/picture/drag.ts';
import {
  LIGHT_KINDS,
  LIGHT_WORDS,
  newLight,
  newThing,
  thingWords,
} from '../state/picture/edits.ts';
import { initialShape } from '../state/state.ts';
import type { ChangeScene } from './picture-fields.ts';
import { lightForm } from './picture-light.ts';
import { thingForm } from './picture-thing.ts';
import { cameraForm, worldForm } from './picture-world.ts';
import './picture-editor.css';

export interface EditorTools {
  /** Applies an edit to the scene as it is when the edit arrives. */
  change: ChangeScene;
  /** Applies an edit that adds a thing or light, and opens the form of its id. */
  add(edit: (scene: Scene) => readonly [next: Scene, id: string]): void;
  remove(id: string): void;
  edit(id: string | null): void;
  save(): void;
  open(): void;
  /** What drags keep to. */
  readonly along: DragPlane;
  drag(along: DragPlane): void;
}

const ALONG_WORDS: Readonly<Record<DragPlane, string>> = { floor: 'the floor', wall: 'a wall' };

/** The shape of Explore, and what it becomes in a scene. */
interface Explored {
  readonly shape: Shape;
  thing(scene: Scene): Thing;
}

/** Ids of the forms of camera and world; @ keeps them apart from ids of things and lights. */
const CAMERA = '@camera';
const WORLD = '@world';

/** A list of everything in the scene, each with its form, and buttons to add something. */
export function editor(
  scene: Scene,
  edit: string | null,
  explored: Explored,
  tools: EditorTools,
): TemplateResult {
  const addOne = (make: (now: Scene) => Thing): void =>
    tools.add((now) => {
      const thing = make(now);
      return [addThing(now, thing), thing.id];
    });
  return html`<p class="editor-acts">
      <button type="button" class="plain-button" @click=${tools.save}>Save scene</button>
      <button type="button" class="plain-button" @click=${tools.open}>Open a scene</button>
    </p>
    <fieldset class="drag-along"><legend>Shapes and lights are dragged in the picture, only lights
      among the rays of a pixel, along</legend>${DRAG_PLANES.map(
        (along) =>
          html`<label><input type="radio" name="drag-along" .checked=${live(
            tools.along === along,
          )} @change=${() => tools.drag(along)} /> ${ALONG_WORDS[along]}</label>`,
      )}</fieldset>
    <div class="adding" role="group" aria-label="Add a shape">
      <span>Add</span>
      ${SHAPES.map(({ kind, icon }) => {
        const word = wordFor(initialShape(kind));
        return html`<button type="button" class="add" aria-label=${`add a ${word}`}
          @click=${() => addOne((now) => newThing(now, kind))}><svg viewBox="0 0 24 24" width="24"
          height="24" aria-hidden="true"><path d=${icon} /></svg>${word}</button>`;
      })}
      <button type="button" class="textual"
        @click=${() => addOne(explored.thing)}>the ${wordFor(explored.shape)} of Explore</button>
    </div>
    <div class="adding" role="group" aria-label="Add a light">
      <span>Add</span>
      ${LIGHT_KINDS.map(
        (kind) =>
          html`<button type="button" class="textual" @click=${() =>
            tools.add((now) => {
              const light = newLight(now, kind);
              return [addLight(now, light), light.id];
            })}>${LIGHT_WORDS[kind]}</button>`,
      )}
    </div>
    <ul class="parts">
      ${scene.things.map((thing) =>
        part(
          thing.id,
          nameIn(scene, thing.id),
          html`<svg viewBox="0 0 24 24" width="20" height="20" aria-hidden="true"><path
            d=${findShape(thing.shape.kind)?.icon ?? ''} /></svg>`,
          thingWords(scene, thing),
          edit === thing.id ? thingForm(scene, thing, tools.change) : null,
          tools,
          () => tools.remove(thing.id),
        ),
      )}
      ${scene.lights.map((light) =>
        part(
          light.id,
          nameIn(scene, light.id),
          LAMP,
          light.light === 'sun'
            ? 'sun'
            : light.light === 'sphere'
              ? `light of radius ${light.radius}`
              : 'light',
          edit === light.id ? lightForm(scene, light, tools.change) : null,
          tools,
          () => tools.remove(light.id),
        ),
      )}
      ${part(
        CAMERA,
        'camera',
        EYE,
        `${scene.camera.angle}°`,
        edit === CAMERA ? cameraForm(scene, tools.change) : null,
        tools,
        null,
      )}
      ${part(
        WORLD,
        'background',
        nothing,
        'what a ray sees that meets nothing',
        edit === WORLD ? worldForm(scene, tools.change) : null,
        tools,
        null,
      )}
    </ul>`;
}

function part(
  id: string,
  name: string,
  icon: TemplateResult | typeof nothing,
  words: string,
  form: TemplateResult | null,
  tools: EditorTools,
  take: (() => void) | null,
): TemplateResult {
  return html`<li class="part" data-part=${id}>
    <div class="part-line">
      <button type="button" class="part-name" aria-expanded=${form !== null}
        @click=${() => tools.edit(form ? null : id)}>
        <span class="part-icon">${icon}</span><strong>${name}</strong><span
          class="part-words">${words}</span>
      </button>
      ${
        take
          ? html`<button type="button" class="textual" aria-label=${`remove ${name}`}
        @click=${take}>remove</button>`
          : nothing
      }
    </div>
    ${form ? html`<div class="part-form">${form}</div>` : nothing}
  </li>`;
}

const LAMP = html`<svg viewBox="0 0 24 24" width="20" height="20" aria-hidden="true"><path
  d="M12 3v3M12 18v3M3 12h3M18 12h3M5.6 5.6l2.2 2.2M16.200 16.200l2.200 2.200
    M5.600 18.400l2.200-2.200M16.200 7.800l2.200-2.200
    M15.500 12a3.500 3.500 0 1 1-7 0a3.500 3.500 0 1 1 7 0" /></svg>`;
const EYE = html`<svg viewBox="0 0 24 24" width="20" height="20" aria-hidden="true"><path
  d="M3 12C6 7 9 5.500 12 5.500S18 7 21 12C18 17 15 18.500 12 18.500S6 17 3 12
    M15 12a3 3 0 1 1-6 0a3 3 0 1 1 6 0" /></svg>`;

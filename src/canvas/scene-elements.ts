import type { Dispatch } from '../state/actions.ts';
import type { SceneModel } from '../state/scene-model.ts';
import { viewSwitcher } from './view-switcher.ts';

const SVG = 'http://www.w3.org/2000/svg';
const KEYS = 'Arrow keys turn it, plus and minus zoom, 0 goes back.';
const HANDLE_KEYS =
  'Left and right move it along x, up and down along y, Page Up and Page Down along z; with ' +
  'Shift in small steps.';

let count = 0;

/** The elements of a scene, without what changes from frame to frame. */
interface SceneElements {
  readonly root: HTMLElement;
  readonly canvas: HTMLCanvasElement;
  /** Lines in place of the canvas, if there is no WebGL. */
  readonly paths: SVGSVGElement;
  readonly overlay: SVGSVGElement;
  readonly handles: SVGSVGElement;
  /** Id of the sentence that says what keys do to a handle. */
  readonly keys: string;
  /** `missing`: a sentence on what the browser cannot show, or ''. */
  tell(model: SceneModel, missing: string): void;
  resize(width: number, height: number): void;
}

export function createSceneElements(host: HTMLElement, dispatch: Dispatch): SceneElements {
  const root = document.createElement('div');
  root.className = 'scene-root';
  root.tabIndex = 0;
  root.setAttribute('role', 'group');
  const canvas = document.createElement('canvas');
  canvas.className = 'scene-canvas';
  canvas.setAttribute('aria-hidden', 'true');
  const paths = svg('scene-fallback');
  const overlay = svg('scene-overlay');
  const handles = svg('scene-handles-over');
  handles.removeAttribute('aria-hidden');
  const notes = document.createElement('div');
  notes.className = 'scene-notes';
  const description = document.createElement('p');
  description.className = 'scene-description';
  description.id = `scene-description-${++count}`;
  root.setAttribute('aria-describedby', description.id);
  const keys = paragraph(HANDLE_KEYS);
  keys.className = 'scene-description';
  keys.id = `scene-keys-${count}`;
  keys.hidden = true;
  root.append(canvas, paths, overlay, handles, notes, description, keys);
  const press = viewSwitcher(root, dispatch);
  host.append(root);
  let told: readonly string[] = [];
  return {
    ...{ root, canvas, paths, overlay, handles, keys: keys.id },
    tell(model, missing) {
      press(model.view);
      root.setAttribute('aria-label', `${model.shapeTitle} and ray, a picture. ${KEYS}`);
      if (description.textContent !== model.description)
        description.textContent = model.description;
      const lines = missing ? [missing, ...model.notes] : model.notes;
      if (lines.length === told.length && lines.every((line, k) => line === told[k])) return;
      told = [...lines];
      notes.replaceChildren(...told.map(paragraph));
    },
    resize(width, height) {
      for (const element of [paths, overlay, handles])
        element.setAttribute('viewBox', `0 0 ${width} ${height}`);
    },
  };
}

function svg(name: string): SVGSVGElement {
  const element = document.createElementNS(SVG, 'svg');
  element.setAttribute('class', name);
  element.setAttribute('aria-hidden', 'true');
  return element;
}

function paragraph(text: string): HTMLElement {
  const element = document.createElement('p');
  element.textContent = text;
  return element;
}

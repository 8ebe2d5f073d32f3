import type { Handle } from '../state/handles.ts';
import { coordinate } from '../text/coordinate.ts';
import { ARROW_LENGTH, axisArrowSegments, drawAxisArrows } from './axis-arrows.ts';
import { italic } from './captions.ts';
import type { Caption } from './figures.ts';
import type { ShownHandle } from './handle-drag.ts';
import type { HandlePlace } from './handle-place.ts';
import type { Segment } from './labels.ts';
import { type Attributes, Layer, type Part } from './layer.ts';
import { heading, isInside } from './off-screen-pointer.ts';
import type { Projection } from './projection.ts';
import type { Theme } from './theme.ts';

/** Distance in px from the tip of d back to the middle of its arrow head. */
const BEHIND_TIP = 9;

const ROOM: readonly Part[] = [
  ['circle', { class: 'scene-focus', r: 20 }],
  ['circle', { class: 'scene-hit', r: 22 }],
];
/** Mark of a handle for which the picture has none. */
const GRIP: Part = ['circle', { class: 'scale-handle', r: 4.5 }];

/**
 * The handles over the picture; each can be focused, has a label with its value, and a touch area.
 */
export class DragHandles {
  readonly #arrows: Layer;
  readonly #handles: Layer;

  constructor(svg: Element) {
    this.#arrows = new Layer(svg, 'axis-arrows');
    this.#handles = new Layer(svg, 'scene-handles');
  }

  /** `keys`: id of the sentence on what keys do. */
  draw(
    all: readonly HandlePlace[],
    held: ShownHandle,
    projection: Projection,
    theme: Theme,
    keys: string,
  ): void {
    const active = inUse(all, held, projection);
    this.#arrows.begin();
    if (active?.handle.type === 'point') drawAxisArrows(this.#arrows, active, projection, theme);
    this.#arrows.end();
    this.#handles.begin();
    for (const found of all) this.#show(found, held, projection, theme.scale, keys);
    this.#handles.end();
  }

  #show(
    found: HandlePlace,
    held: ShownHandle,
    projection: Projection,
    scale: number,
    keys: string,
  ): void {
    const { handle, spot } = found;
    const isActive = held.active === handle.symbol;
    const { x, y } = middle(found, projection, scale);
    const place = spot && isInside(spot, projection) ? '' : ' away';
    const state = `${place}${isActive && held.dragged ? ' dragged' : ''}`;
    this.#handles.show(
      handle.symbol,
      'g',
      {
        class: `scene-handle${state}`,
        'data-handle': handle.symbol,
        'data-symbol': handle.symbol,
        ...spoken(handle, isActive ? held.reason : '', keys),
        transform: `translate(${coordinate(x)} ${coordinate(y)})`,
      },
      handle.type === 'reach' ? [...ROOM, GRIP] : ROOM,
    );
  }
}

function inUse(
  all: readonly HandlePlace[],
  held: ShownHandle,
  projection: Projection,
): HandlePlace | undefined {
  const active = all.find(({ handle }) => handle.symbol === held.active);
  return active?.spot && isInside(active.spot, projection) ? active : undefined;
}

/** The arrows that are shown. */
export function shownArrows(
  all: readonly HandlePlace[],
  held: ShownHandle,
  projection: Projection,
  theme: Theme,
): Segment[] {
  const active = inUse(all, held, projection);
  return active?.handle.type === 'point' ? axisArrowSegments(active, projection, theme) : [];
}

/** Words beside the handle in use: what it snapped to, or the number it sets. */
export function handleCaptions(
  all: readonly HandlePlace[],
  held: ShownHandle,
  projection: Projection,
  scale: number,
): Caption[] {
  const active = inUse(all, held, projection);
  if (!active?.spot) return [];
  const { handle, spot } = active;
  const isPoint = handle.type === 'point';
  const letter = held.reason || (isPoint ? '' : `${italic(handle.symbol)} = ${handle.text}`);
  if (!letter) return [];
  const clear = (isPoint ? ARROW_LENGTH + 8 : 14) * scale;
  const name = { key: 'words', symbol: '', letter, sub: '', tone: 'words' } as const;
  return [{ ...name, x: spot.x, y: spot.y, clear, angle: Math.PI / 2 }];
}

/** The handle's centre, moved into the frame if it is outside, so that it can keep the focus. */
function middle(
  { handle, place, spot }: HandlePlace,
  projection: Projection,
  scale: number,
): { x: number; y: number } {
  let [x, y] = spot ? [spot.x, spot.y] : [projection.width / 2, projection.height / 2];
  if (place && handle.type === 'point' && handle.origin) {
    const course = heading(place, handle.here, projection);
    if (course) [x, y] = [x - BEHIND_TIP * scale * course[0], y - BEHIND_TIP * scale * course[1]];
  }
  return {
    x: Math.min(Math.max(x, 0), projection.width),
    y: Math.min(Math.max(y, 0), projection.height),
  };
}

function spoken(handle: Handle, reason: string, keys: string): Attributes {
  const now = typeof handle.value === 'number' ? handle.value : handle.value[0];
  return {
    role: 'slider',
    tabindex: 0,
    'aria-roledescription': 'handle',
    'aria-label': handle.label,
    'aria-valuenow': String(now),
    'aria-valuetext': reason ? `${handle.text}, ${reason}` : handle.text,
    'aria-describedby': keys,
  };
}

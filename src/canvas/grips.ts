import type { Handle } from '../state/handles.ts';
import { coordinate } from '../text/coordinate.ts';
import { ARM, armSegments, drawArms } from './arms.ts';
import { italic } from './captions.ts';
import type { Caption } from './figures.ts';
import type { Held } from './grab.ts';
import type { Segment } from './labels.ts';
import { type Attributes, Layer, type Part } from './layer.ts';
import type { Lens } from './lens.ts';
import { heading, isInside } from './offstage.ts';
import type { Placed } from './placed.ts';
import type { Theme } from './theme.ts';

/** The head of d lies so far behind its tip. */
const BEHIND_TIP = 9;

const ROOM: readonly Part[] = [
  ['circle', { class: 'scene-focus', r: 20 }],
  ['circle', { class: 'scene-hit', r: 22 }],
];
/** What has no mark of its own in the picture. */
const GRIP: Part = ['circle', { class: 'scene-grip', r: 4.5 }];

/** The handles over the picture: each can be focused and says its value, and has room for a finger. */
export class Grips {
  readonly #arms: Layer;
  readonly #handles: Layer;

  constructor(svg: Element) {
    this.#arms = new Layer(svg, 'scene-arms');
    this.#handles = new Layer(svg, 'scene-handles');
  }

  /** `keys`: id of the sentence on what keys do. */
  draw(all: readonly Placed[], held: Held, lens: Lens, theme: Theme, keys: string): void {
    const active = inUse(all, held, lens);
    this.#arms.begin();
    if (active?.handle.type === 'point') drawArms(this.#arms, active, lens, theme);
    this.#arms.end();
    this.#handles.begin();
    for (const found of all) this.#show(found, held, lens, theme.scale, keys);
    this.#handles.end();
  }

  #show(found: Placed, held: Held, lens: Lens, scale: number, keys: string): void {
    const { handle, spot } = found;
    const isActive = held.active === handle.symbol;
    const { x, y } = middle(found, lens, scale);
    const state = `${spot && isInside(spot, lens) ? '' : ' away'}${isActive && held.dragged ? ' dragged' : ''}`;
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

function inUse(all: readonly Placed[], held: Held, lens: Lens): Placed | undefined {
  const active = all.find(({ handle }) => handle.symbol === held.active);
  return active?.spot && isInside(active.spot, lens) ? active : undefined;
}

/** The arrows that are shown. */
export function armsShown(all: readonly Placed[], held: Held, lens: Lens, theme: Theme): Segment[] {
  const active = inUse(all, held, lens);
  return active?.handle.type === 'point' ? armSegments(active, lens, theme) : [];
}

/** What is said beside the handle in use: why it is where it is, or which number it is. */
export function sayings(all: readonly Placed[], held: Held, lens: Lens, scale: number): Caption[] {
  const active = inUse(all, held, lens);
  if (!active?.spot) return [];
  const { handle, spot } = active;
  const isPoint = handle.type === 'point';
  const letter = held.reason || (isPoint ? '' : `${italic(handle.symbol)} = ${handle.text}`);
  if (!letter) return [];
  const clear = (isPoint ? ARM + 8 : 14) * scale;
  const name = { key: 'words', symbol: '', letter, sub: '', tone: 'words' } as const;
  return [{ ...name, x: spot.x, y: spot.y, clear, angle: Math.PI / 2 }];
}

/** Where its mark is, brought into the frame when it lies outside: a handle that is focused must not go away. */
function middle(
  { handle, place, spot }: Placed,
  lens: Lens,
  scale: number,
): { x: number; y: number } {
  let [x, y] = spot ? [spot.x, spot.y] : [lens.width / 2, lens.height / 2];
  if (place && handle.type === 'point' && handle.origin) {
    const course = heading(place, handle.here, lens);
    if (course) [x, y] = [x - BEHIND_TIP * scale * course[0], y - BEHIND_TIP * scale * course[1]];
  }
  return { x: Math.min(Math.max(x, 0), lens.width), y: Math.min(Math.max(y, 0), lens.height) };
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

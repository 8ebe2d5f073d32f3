import type { Dispatch } from '../state/actions.ts';
import type { Handle } from '../state/handles.ts';
import type { Offer, Value } from '../state/snap.ts';
import type { Lens } from './lens.ts';
import { nudged } from './nudge.ts';
import type { Placed } from './placed.ts';
import { axisOffers, type Modifiers, type Settled, settle } from './settle.ts';
import type { Space } from './space.ts';
import { type Track, trackOf } from './track.ts';

/** So many pixels make a drag; less is a click, or a finger that trembles. */
const DRAG_FROM = 3;

/** What the scene shows of the handles. */
export interface Held {
  /** The handle whose arrows are shown. */
  readonly active: string | null;
  readonly dragged: boolean;
  /** Why the value is not where the pointer is, or '' . */
  readonly reason: string;
}

/** What the handles need of the scene. */
export interface Ground {
  space(): Space;
  lens(): Lens;
  dispatch: Dispatch;
  /** The picture stands still from now on, until it is let go. */
  hold(): void;
  release(): void;
  changed(): void;
}

interface Drag {
  readonly pointer: number;
  readonly handle: Handle;
  readonly track: Track;
  readonly from: { readonly x: number; readonly y: number };
  readonly axes: (value: Value, dx: number, dy: number) => readonly Offer[];
  readonly radius: number;
  at: { readonly x: number; readonly y: number };
  moved: boolean;
  last: Settled;
}

/** One handle at a time is hovered, focused or dragged. A drag counts from where it began; a key press is a drag of one step. */
export class Grab {
  readonly #ground: Ground;
  #drag: Drag | null = null;
  #hovered: string | null = null;
  #focused: string | null = null;
  #reason = '';

  constructor(ground: Ground) {
    this.#ground = ground;
  }

  get shown(): Held {
    const active = this.#drag?.handle.symbol ?? this.#hovered ?? this.#focused;
    return { active, dragged: this.#drag !== null, reason: this.#reason };
  }

  get pointer(): number | null {
    return this.#drag?.pointer ?? null;
  }

  hover(symbol: string | null): void {
    if (symbol === this.#hovered) return;
    this.#hovered = symbol;
    if (!this.#drag) this.#reason = '';
    this.#ground.changed();
  }

  focus(symbol: string | null): void {
    if (symbol === this.#focused) return;
    this.#focused = symbol;
    this.#reason = '';
    this.#ground.changed();
  }

  /** Takes a handle; with an axis it moves along that one only. */
  take(found: Placed, axis: 0 | 1 | 2 | null, pointer: number, x: number, y: number): void {
    const [space, lens] = [this.#ground.space(), this.#ground.lens()];
    const { handle, spot } = found;
    const track = trackOf(found, axis, space, lens);
    if (!spot || !track) return;
    this.#ground.hold();
    this.#drag = {
      ...{ pointer, handle, track, from: { x, y }, at: { x, y }, moved: false },
      radius: space.stage.radius,
      last: { value: handle.value, reason: null, held: null },
      axes: (value, dx, dy) =>
        axis === null
          ? axisOffers(handle, value, { x: spot.x + dx, y: spot.y + dy }, space, lens)
          : [],
    };
    this.#ground.changed();
  }

  move(x: number, y: number, modifiers: Modifiers): void {
    const drag = this.#drag;
    if (!drag) return;
    drag.at = { x, y };
    const [dx, dy] = [x - drag.from.x, y - drag.from.y];
    drag.moved ||= Math.hypot(dx, dy) >= DRAG_FROM;
    if (!drag.moved) return;
    const { handle, track, last } = drag;
    const axes = modifiers.free ? [] : drag.axes(track.to(dx, dy), dx, dy);
    const next = settle(handle, track, [dx, dy], modifiers, axes, last.held, drag.radius);
    const refusal = handle.refusal(next.value);
    if (refusal === null) {
      drag.last = next;
      if (!sameValue(next.value, last.value)) this.#ground.dispatch(handle.action(next.value));
    }
    this.#say(refusal ?? next.reason ?? '');
  }

  /** The keys beside the pointer have changed. */
  modify(modifiers: Modifiers): void {
    if (this.#drag) this.move(this.#drag.at.x, this.#drag.at.y, modifiers);
  }

  end(): void {
    if (!this.#drag) return;
    this.#drag = null;
    this.#reason = '';
    this.#ground.release();
    this.#ground.changed();
  }

  /** Back to where it began. */
  cancel(): void {
    const drag = this.#drag;
    if (drag && !sameValue(drag.last.value, drag.handle.value)) {
      this.#ground.dispatch(drag.handle.action(drag.handle.value));
    }
    this.end();
  }

  /** A key press on a handle; false if the key means nothing to it. */
  press(handle: Handle, event: KeyboardEvent): boolean {
    const nudge = nudged(handle, event, this.#ground.space().stage.radius);
    if (nudge === null) return false;
    const refusal = handle.refusal(nudge(handle.value));
    if (refusal === null) this.#ground.dispatch(handle.action(nudge));
    this.#say(refusal ?? '');
    return true;
  }

  #say(reason: string): void {
    if (reason === this.#reason) return;
    this.#reason = reason;
    this.#ground.changed();
  }
}

function sameValue(a: Value, b: Value): boolean {
  if (typeof a === 'number' || typeof b === 'number') return a === b;
  return a.every((x, i) => x === b[i]);
}

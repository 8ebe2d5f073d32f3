import type { Dispatch } from '../state/actions.ts';
import type { Handle } from '../state/handles.ts';
import type { SnapTarget, Value } from '../state/snap.ts';
import { type DragTrack, trackOf } from './drag-track.ts';
import type { HandlePlace } from './handle-place.ts';
import { nudged } from './nudge.ts';
import type { Projection } from './projection.ts';
import { axisTargets, type Modifiers, type Snapped, snapDrag } from './snap-drag.ts';
import type { StageUnits } from './stage-units.ts';

/** Pixels that the pointer must move before a press is a drag; less is a click. */
const DRAG_THRESHOLD = 3;

/** The state of the handles, as drawn. */
export interface ShownHandle {
  /** The handle whose arrows are shown. */
  readonly active: string | null;
  readonly dragged: boolean;
  /** Why the value is not where the pointer is, or '' . */
  readonly reason: string;
}

/** What the handles need from the scene. */
interface DragContext {
  units(): StageUnits;
  projection(): Projection;
  dispatch: Dispatch;
  /** Keeps camera and stage fixed until `release`. */
  hold(): void;
  release(): void;
  changed(): void;
}

interface Drag {
  readonly pointer: number;
  readonly handle: Handle;
  readonly track: DragTrack;
  readonly from: { readonly x: number; readonly y: number };
  readonly axes: (value: Value, dx: number, dy: number) => readonly SnapTarget[];
  readonly radius: number;
  at: { readonly x: number; readonly y: number };
  moved: boolean;
  last: Snapped;
}

/**
 * The handle that is hovered, focused or dragged. Movements are relative to the start of the drag;
 * a key press is a drag of one step.
 */
export class HandleDrag {
  readonly #context: DragContext;
  #drag: Drag | null = null;
  #hovered: string | null = null;
  #focused: string | null = null;
  #reason = '';

  constructor(ground: DragContext) {
    this.#context = ground;
  }

  get shown(): ShownHandle {
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
    this.#context.changed();
  }

  focus(symbol: string | null): void {
    if (symbol === this.#focused) return;
    this.#focused = symbol;
    this.#reason = '';
    this.#context.changed();
  }

  /** Starts a drag; with an axis along that axis only. */
  take(found: HandlePlace, axis: 0 | 1 | 2 | null, pointer: number, x: number, y: number): void {
    const [units, projection] = [this.#context.units(), this.#context.projection()];
    const { handle, spot } = found;
    const track = trackOf(found, axis, units, projection);
    if (!spot || !track) return;
    this.#context.hold();
    this.#drag = {
      ...{ pointer, handle, track, from: { x, y }, at: { x, y }, moved: false },
      radius: units.stage.radius,
      last: { value: handle.value, reason: null, held: null },
      axes: (value, dx, dy) =>
        axis === null
          ? axisTargets(handle, value, { x: spot.x + dx, y: spot.y + dy }, units, projection)
          : [],
    };
    this.#context.changed();
  }

  move(x: number, y: number, modifiers: Modifiers): void {
    const drag = this.#drag;
    if (!drag) return;
    drag.at = { x, y };
    const [dx, dy] = [x - drag.from.x, y - drag.from.y];
    drag.moved ||= Math.hypot(dx, dy) >= DRAG_THRESHOLD;
    if (!drag.moved) return;
    const { handle, track, last } = drag;
    const axes = modifiers.free ? [] : drag.axes(track.to(dx, dy), dx, dy);
    const next = snapDrag(handle, track, [dx, dy], modifiers, axes, last.held, drag.radius);
    const refusal = handle.refusal(next.value);
    if (refusal === null) {
      drag.last = next;
      if (!sameValue(next.value, last.value)) this.#context.dispatch(handle.action(next.value));
    }
    this.#say(refusal ?? next.reason ?? '');
  }

  /** Updates the drag after Shift or Alt was pressed or released. */
  modify(modifiers: Modifiers): void {
    if (this.#drag) this.move(this.#drag.at.x, this.#drag.at.y, modifiers);
  }

  end(): void {
    if (!this.#drag) return;
    this.#drag = null;
    this.#reason = '';
    this.#context.release();
    this.#context.changed();
  }

  /** Ends the drag with the value before it. */
  cancel(): void {
    const drag = this.#drag;
    if (drag && !sameValue(drag.last.value, drag.handle.value)) {
      this.#context.dispatch(drag.handle.action(drag.handle.value));
    }
    this.end();
  }

  /** Handles a key press; false if the key has no meaning for the handle. */
  press(handle: Handle, event: KeyboardEvent): boolean {
    const nudge = nudged(handle, event, this.#context.units().stage.radius);
    if (nudge === null) return false;
    const refusal = handle.refusal(nudge(handle.value));
    if (refusal === null) this.#context.dispatch(handle.action(nudge));
    this.#say(refusal ?? '');
    return true;
  }

  #say(reason: string): void {
    if (reason === this.#reason) return;
    this.#reason = reason;
    this.#context.changed();
  }
}

function sameValue(a: Value, b: Value): boolean {
  if (typeof a === 'number' || typeof b === 'number') return a === b;
  return a.every((x, i) => x === b[i]);
}

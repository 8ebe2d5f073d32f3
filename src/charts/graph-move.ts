import type { Dispatch } from '../state/actions.ts';
import type { GraphModel } from '../state/graph-model.ts';
import { placeIn } from '../ui/zoom.ts';
import { type AxisStep, clamp, niceStep, snap, stepSize } from './axis-steps.ts';
import type { Scales } from './graph-scales.ts';

/** The shown model with its scales. */
export interface DrawnGraph {
  readonly model: GraphModel;
  readonly scales: Scales;
}

/** Steps in the shown range of t: of an arrow key, and of the grid that a drag snaps to. */
const [KEY_PARTS, DRAG_PARTS] = [100, 200];
/** Radius in px in which a press grabs the bead with its offset; farther off it moves the bead. */
const GRAB = { mouse: 10, touch: 22 };
/** px of sideways movement after which a finger drags the bead instead of scrolling. */
const SIDEWAYS = 5;

/** t after a slider's key; null for other keys. With Shift arrows are ten times finer. */
export function keyTarget(event: KeyboardEvent, { model }: DrawnGraph): number | null {
  const { from, to, bead } = model;
  const step = niceStep((to - from) / KEY_PARTS);
  const fine: AxisStep = { digit: step.digit, power: step.power - 1 };
  const length = stepSize(event.shiftKey ? fine : step);
  const by = (steps: number) => clamp(snap(bead.t + steps * length, fine), from, to);
  const targets: Record<string, () => number> = {
    ArrowRight: () => by(1),
    ArrowUp: () => by(1),
    ArrowLeft: () => by(-1),
    ArrowDown: () => by(-1),
    PageUp: () => by(10),
    PageDown: () => by(-10),
    Home: () => from,
    End: () => to,
  };
  return targets[event.key]?.() ?? null;
}

/**
 * Pointer handlers for the plot: press or drag moves the bead. `shown` gives what is on screen now.
 */
export function pointerMoves(shown: () => DrawnGraph | null, dispatch: Dispatch) {
  let drag: Drag | null = null;
  const move = (event: PointerEvent) => {
    const now = shown();
    if (now === null || drag === null) return;
    const t = beadAt(pointerX(event) + drag.offset, now);
    if (t !== now.model.bead.t) dispatch({ type: 'bead', t });
  };
  return {
    down(event: PointerEvent) {
      const now = shown();
      if (now === null || !event.isPrimary || event.button !== 0) return;
      drag = startOf(event, now);
      picture(event)?.setPointerCapture(event.pointerId);
      if (!drag.waits) move(event);
    },
    move(event: PointerEvent) {
      if (drag?.waits && Math.abs(event.clientX - drag.startX) > SIDEWAYS) drag.waits = false;
      if (drag && !drag.waits) move(event);
    },
    up(event: PointerEvent) {
      if (drag === null) return;
      if (drag.waits) move(event);
      drag = null;
      // Focus the bead, so that arrow keys continue from here.
      picture(event)?.querySelector<SVGElement>('.graph-bead')?.focus({ preventScroll: true });
    },
    cancel() {
      drag = null;
    },
  };
}

interface Drag {
  /** px from the pointer to the bead, so that it does not jump when it is grabbed. */
  readonly offset: number;
  readonly startX: number;
  /** Whether a finger beside the bead may still scroll: until it moves sideways or is lifted. */
  waits: boolean;
}

function startOf(event: PointerEvent, now: DrawnGraph): Drag {
  const offset = grabOffset(event, now);
  const waits = event.pointerType === 'touch' && offset === null;
  return { offset: offset ?? 0, startX: event.clientX, waits };
}

/** px from the pointer to the bead; null if the pointer is not on it. */
function grabOffset(event: PointerEvent, { model, scales }: DrawnGraph): number | null {
  const onBead = event.target instanceof Element && event.target.closest('.graph-bead') !== null;
  const x = clamp(scales.x(model.bead.t), scales.frame.left, scales.frame.right);
  const offset = x - pointerX(event);
  const reach = event.pointerType === 'touch' ? GRAB.touch : GRAB.mouse;
  return onBead && Math.abs(offset) <= reach ? offset : null;
}

/** The element that listens: the picture of the graph. */
function picture(event: PointerEvent): Element | null {
  return event.currentTarget instanceof Element ? event.currentTarget : null;
}

function pointerX(event: PointerEvent): number {
  const element = picture(event);
  return element ? placeIn(element, event).x : event.clientX;
}

function beadAt(px: number, { model: { from, to }, scales }: DrawnGraph): number {
  const step = niceStep((to - from) / DRAG_PARTS);
  return clamp(snap(scales.t(px), step), from, to);
}

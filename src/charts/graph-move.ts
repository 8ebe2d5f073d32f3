import type { Dispatch } from '../state/actions.ts';
import type { GraphModel } from '../state/graph-model.ts';
import type { Scales } from './graph-scales.ts';
import { clamp, niceStep, type Step, snap, stepSize } from './steps.ts';

/** What a gesture or a key needs to know of the picture that is shown. */
export interface Shown {
  readonly model: GraphModel;
  readonly scales: Scales;
}

/**
 * Parts of the shown range: one arrow key, and what a drag snaps to, so that the numbers stay
 * short.
 */
const [KEY_PARTS, DRAG_PARTS] = [100, 200];
/**
 * A mouse that grabs the bead keeps its offset; a press farther off moves it there. Fingers cover
 * more.
 */
const GRAB = { mouse: 10, touch: 22 };
/** A finger that has moved so far sideways drags the bead; up or down it scrolls the page. */
const SIDEWAYS = 5;

/** The keys of a slider; null for any other key. Shift makes the arrows ten times finer. */
export function keyTarget(event: KeyboardEvent, { model }: Shown): number | null {
  const { from, to, bead } = model;
  const step = niceStep((to - from) / KEY_PARTS);
  const fine: Step = { digit: step.digit, power: step.power - 1 };
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
export function pointerMoves(shown: () => Shown | null, dispatch: Dispatch) {
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
      // The arrows go on from where the pointer has put it.
      picture(event)?.querySelector<SVGElement>('.graph-bead')?.focus({ preventScroll: true });
    },
    cancel() {
      drag = null;
    },
  };
}

interface Drag {
  /** From the pointer to the bead, so that the bead does not jump when it is grabbed. */
  readonly offset: number;
  readonly startX: number;
  /**
   * A finger beside the bead may be about to scroll: nothing moves until it goes sideways or is
   * lifted.
   */
  waits: boolean;
}

function startOf(event: PointerEvent, now: Shown): Drag {
  const offset = grabOffset(event, now);
  const waits = event.pointerType === 'touch' && offset === null;
  return { offset: offset ?? 0, startX: event.clientX, waits };
}

/** Null when the pointer is not on the bead. */
function grabOffset(event: PointerEvent, { model, scales }: Shown): number | null {
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
  return event.clientX - (picture(event)?.getBoundingClientRect().left ?? 0);
}

function beadAt(px: number, { model: { from, to }, scales }: Shown): number {
  const step = niceStep((to - from) / DRAG_PARTS);
  return clamp(snap(scales.t(px), step), from, to);
}

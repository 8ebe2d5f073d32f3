import type { Dispatch } from '../state/actions.ts';
import type { StripModel } from '../state/strip-model.ts';
import { clamp, niceStep, type Step, snap, stepSize } from './steps.ts';
import type { Scales } from './strip-scales.ts';

/** What a gesture or a key needs to know of the picture that is shown. */
export interface Shown {
  readonly model: StripModel;
  readonly scales: Scales;
}

/** Parts of the shown range: one arrow key, and what a drag snaps to, so that the numbers stay short. */
const [KEY_PARTS, DRAG_PARTS] = [100, 200];
/** A mouse that grabs the bead keeps its offset; a press farther off moves it there. Fingers cover more. */
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

/** Pointer handlers for the plot: press or drag moves the bead. `shown` gives what is on screen now. */
export function pointerMoves(shown: () => Shown | null, dispatch: Dispatch) {
  /** Between bead and pointer, so that the bead does not jump when it is grabbed; `waits` until a finger goes sideways. */
  let drag: { offset: number; startX: number; waits: boolean } | null = null;
  const move = (clientX: number, svg: Element) => {
    const now = shown();
    if (now === null || drag === null) return;
    const t = beadAt(clientX - svg.getBoundingClientRect().left + drag.offset, now);
    if (t !== now.model.bead.t) dispatch({ type: 'bead', t });
  };
  return {
    down(event: PointerEvent, svg: Element) {
      const now = shown();
      if (now === null || !event.isPrimary || event.button !== 0) return;
      const offset = grabOffset(event, svg, now);
      const waits = event.pointerType === 'touch' && offset === null;
      drag = { offset: offset ?? 0, startX: event.clientX, waits };
      svg.setPointerCapture(event.pointerId);
      if (!waits) move(event.clientX, svg);
    },
    move(event: PointerEvent, svg: Element) {
      if (drag?.waits && Math.abs(event.clientX - drag.startX) > SIDEWAYS) drag.waits = false;
      if (drag && !drag.waits) move(event.clientX, svg);
    },
    up(event: PointerEvent, svg: Element) {
      if (drag === null) return;
      if (drag.waits) move(event.clientX, svg);
      drag = null;
      // The arrows go on from where the pointer has put it.
      svg.querySelector<SVGElement>('.strip-bead')?.focus({ preventScroll: true });
    },
    cancel() {
      drag = null;
    },
  };
}

function grabOffset(event: PointerEvent, svg: Element, { model, scales }: Shown): number | null {
  const onBead = event.target instanceof Element && event.target.closest('.strip-bead') !== null;
  const x = clamp(scales.x(model.bead.t), scales.frame.left, scales.frame.right);
  const offset = x - (event.clientX - svg.getBoundingClientRect().left);
  const reach = event.pointerType === 'touch' ? GRAB.touch : GRAB.mouse;
  return onBead && Math.abs(offset) <= reach ? offset : null;
}

function beadAt(px: number, { model: { from, to }, scales }: Shown): number {
  const step = niceStep((to - from) / DRAG_PARTS);
  return clamp(snap(scales.t(px), step), from, to);
}

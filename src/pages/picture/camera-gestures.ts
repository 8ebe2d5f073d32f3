import { type CameraEdit, nearer, shifted, turned } from '../../state/picture/camera-edits.ts';
import { type Grip, watchDrags } from '../../ui/drags.ts';
import { wantsWheel, wheelFactor } from '../../ui/wheel.ts';

/** Radians of a drag over the picture's width, and of a key. */
const PER_WIDTH = Math.PI;
const PER_KEY = Math.PI / 36;
const PER_SHIFT_KEY = 0.05;
const PER_ZOOM_KEY = 1.2;

interface CameraTools {
  /** Whether a press is left to the camera, and not to a thing under it. */
  free(event: PointerEvent): boolean;
  move(edit: CameraEdit): void;
  hold(): void;
  /** A drag has ended; one that the browser took for a scroll of the page has moved nothing. */
  release(isCancelled: boolean): void;
}

/**
 * Turns the camera by a drag, shifts it by one with Shift or with two fingers, comes nearer by
 * wheel and pinch, and all of that by keys. Returns whether the last press was a drag.
 */
export function listenToCamera(element: HTMLElement, tools: CameraTools): () => boolean {
  let last: Grip | null = null;
  let dragged = false;
  watchDrags(element, {
    takes(event) {
      dragged = false;
      return event.button <= 1 && tools.free(event);
    },
    begin() {
      last = null;
    },
    drags() {
      dragged = true;
      tools.hold();
    },
    move(now, from, event) {
      const before = last ?? from;
      last = now;
      const [dx, dy] = [now.x - before.x, now.y - before.y];
      const { width, height } = element.getBoundingClientRect();
      const pinch = before.spread > 0 && now.spread > 0;
      if (pinch) tools.move(nearer(before.spread / now.spread));
      if (pinch || event.shiftKey || event.buttons === 4) {
        tools.move(shifted(-dx / height, dy / height));
      } else tools.move(turned((-dx / width) * PER_WIDTH, (dy / width) * PER_WIDTH));
    },
    end: tools.release,
  });
  element.addEventListener(
    'wheel',
    (event) => {
      if (!wantsWheel(element, event)) return;
      event.preventDefault();
      tools.move(nearer(1 / wheelFactor(event)));
    },
    { passive: false },
  );
  element.addEventListener('keydown', (event) => {
    if (event.altKey || event.metaKey) return;
    const edit = keyEdit(event);
    if (!edit) return;
    event.preventDefault();
    event.stopImmediatePropagation();
    tools.move(edit);
  });
  return () => dragged;
}

/** Shift and an arrow turn it, with Ctrl too they shift it; + and − come nearer and go back. */
function keyEdit({ key, shiftKey, ctrlKey }: KeyboardEvent): CameraEdit | null {
  if (!ctrlKey && (key === '+' || key === '=')) return nearer(1 / PER_ZOOM_KEY);
  if (!ctrlKey && (key === '-' || key === '\u2212')) return nearer(PER_ZOOM_KEY);
  const way = ARROWS[key];
  if (!way || !shiftKey) return null;
  const [x, y] = way;
  if (ctrlKey) return shifted(PER_SHIFT_KEY * x, PER_SHIFT_KEY * y);
  return turned(PER_KEY * x, PER_KEY * y);
}

const ARROWS: Readonly<Record<string, readonly [number, number]>> = {
  ArrowLeft: [-1, 0],
  ArrowRight: [1, 0],
  ArrowUp: [0, 1],
  ArrowDown: [0, -1],
};

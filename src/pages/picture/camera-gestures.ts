import { type CameraEdit, nearer, shifted, turned } from '../../state/picture/camera-edits.ts';
import { wantsWheel, wheelFactor } from '../../ui/wheel.ts';

/** Radians of a drag over the picture's width, and of a key. */
const PER_WIDTH = Math.PI;
const PER_KEY = Math.PI / 36;
const PER_SHIFT_KEY = 0.05;
const PER_ZOOM_KEY = 1.2;
/** px of movement from which a press is a drag and not a click; a finger is less steady. */
const DRAG_FROM = { mouse: 3, pen: 3, touch: 9 } as const;

interface CameraTools {
  /** Whether a press is left to the camera, and not to a thing under it. */
  free(event: PointerEvent): boolean;
  move(edit: CameraEdit): void;
  hold(): void;
  release(): void;
}

/**
 * Turns the camera by a drag, shifts it by one with Shift or with two fingers, comes nearer by
 * wheel and pinch, and all of that by keys. Returns whether the last press was a drag.
 */
export function listenToCamera(element: HTMLElement, tools: CameraTools): () => boolean {
  const pointers = new Map<number, { x: number; y: number }>();
  let last: { x: number; y: number; spread: number } | null = null;
  let dragging = false;
  let dragged = false;

  const grip = () => {
    const [a, b] = [...pointers.values()];
    if (!a) return null;
    return b
      ? { x: (a.x + b.x) / 2, y: (a.y + b.y) / 2, spread: Math.hypot(a.x - b.x, a.y - b.y) }
      : { ...a, spread: 0 };
  };
  const begin = (): void => {
    dragging = true;
    dragged = true;
    tools.hold();
  };

  element.addEventListener('pointerdown', (event) => {
    dragged = false;
    if (event.button > 1 || pointers.size === 2 || !tools.free(event)) return;
    pointers.set(event.pointerId, { x: event.clientX, y: event.clientY });
    last = grip();
    if (pointers.size === 2 && !dragging) begin();
  });
  element.addEventListener('pointermove', (event) => {
    const pointer = pointers.get(event.pointerId);
    if (!pointer || !last) return;
    [pointer.x, pointer.y] = [event.clientX, event.clientY];
    const now = grip();
    if (!now) return;
    const [dx, dy] = [now.x - last.x, now.y - last.y];
    if (!dragging) {
      const kind = event.pointerType as keyof typeof DRAG_FROM;
      if (Math.hypot(dx, dy) < (DRAG_FROM[kind] ?? DRAG_FROM.mouse)) return;
      if (kind === 'touch' && Math.abs(dy) > Math.abs(dx)) {
        // One finger up or down scrolls the page, whatever it does then.
        pointers.delete(event.pointerId);
        last = grip();
        return;
      }
      begin();
      element.setPointerCapture(event.pointerId);
    }
    const { width, height } = element.getBoundingClientRect();
    if (pointers.size === 2 && last.spread > 0 && now.spread > 0) {
      tools.move(nearer(last.spread / now.spread));
      tools.move(shifted(-dx / height, dy / height));
    } else if (event.shiftKey || event.buttons === 4) {
      tools.move(shifted(-dx / height, dy / height));
    } else tools.move(turned((-dx / width) * PER_WIDTH, (dy / width) * PER_WIDTH));
    last = now;
  });
  const up = (event: PointerEvent): void => {
    if (!pointers.delete(event.pointerId)) return;
    last = grip();
    if (pointers.size > 0 || !dragging) return;
    dragging = false;
    tools.release();
  };
  element.addEventListener('pointerup', up);
  element.addEventListener('pointercancel', up);
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

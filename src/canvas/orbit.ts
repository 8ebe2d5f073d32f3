import { type FreeView, ZOOM_RANGE } from '../state/view.ts';
import { Ahead } from '../ui/ahead.ts';
import { wantsWheel, wheelFactor } from '../ui/wheel.ts';
import { wrapped } from './camera.ts';

/**
 * Degrees per px of a drag and per key press; the factor of the zoom per key press.
 */
const PER_PIXEL = 0.4;
const PER_KEY = 5;
const PER_FINE_KEY = 1;
const PER_ZOOM_KEY = 1.2;
/** px of movement from which a press is a drag and not a click; a finger is less steady. */
const DRAG_FROM = { mouse: 3, pen: 3, touch: 9 } as const;

interface Orbit {
  /** The present camera as angles. */
  current(): FreeView;
  /** Keeps the view as it is now; what is returned puts it back. */
  keep(): () => void;
  turn(view: FreeView): void;
  /** Returns to the initial view. */
  home(): void;
}

/**
 * Turns the scene by drag and arrow keys, zooms by wheel, pinch, + and −. It only requests views:
 * the camera is part of the state. Movements are relative to the start of a gesture, so that views
 * that come back rounded or late cause no drift.
 */
export function listenToOrbit(element: HTMLElement, orbit: Orbit): () => void {
  const ahead = new Ahead<FreeView>();
  const step = (turn: number, lift: number, factor: number): void => {
    const view = limited(ahead.of(orbit.current()), turn, lift, factor);
    ahead.set(view);
    orbit.turn(view);
  };
  const pointers = new Map<number, { x: number; y: number }>();
  let start: { view: FreeView; back: () => void; x: number; y: number; spread: number } | null =
    null;
  let isDragging = false;

  const grip = () => {
    const [a, b] = [...pointers.values()];
    if (!a) return null;
    return b
      ? { x: (a.x + b.x) / 2, y: (a.y + b.y) / 2, spread: Math.hypot(a.x - b.x, a.y - b.y) }
      : { ...a, spread: 0 };
  };
  const begin = () => {
    const now = grip();
    start = now && { view: orbit.current(), back: orbit.keep(), ...now };
  };
  const down = (event: PointerEvent) => {
    if (event.button !== 0 || pointers.size === 2 || isControl(event.target)) return;
    pointers.set(event.pointerId, { x: event.clientX, y: event.clientY });
    isDragging = pointers.size > 1;
    begin();
  };
  const move = (event: PointerEvent) => {
    const pointer = pointers.get(event.pointerId);
    if (!pointer || !start) return;
    [pointer.x, pointer.y] = [event.clientX, event.clientY];
    const now = grip();
    if (!now) return;
    const [dx, dy] = [now.x - start.x, now.y - start.y];
    if (!isDragging) {
      const kind = event.pointerType as keyof typeof DRAG_FROM;
      if (Math.hypot(dx, dy) < (DRAG_FROM[kind] ?? DRAG_FROM.mouse)) return;
      if (kind === 'touch' && Math.abs(dy) > Math.abs(dx)) {
        // One finger up or down scrolls the page, whatever it does then.
        pointers.delete(event.pointerId);
        begin();
        return;
      }
      isDragging = true;
      // Captured only now, so that a click reaches the element under the pointer.
      element.setPointerCapture(event.pointerId);
    }
    const pinch = start.spread > 0 && now.spread > 0 ? now.spread / start.spread : 1;
    orbit.turn(limited(start.view, -dx * PER_PIXEL, dy * PER_PIXEL, pinch));
  };
  const up = (event: PointerEvent) => {
    if (!pointers.delete(event.pointerId)) return;
    // After a pinch the remaining finger starts a new gesture.
    begin();
    if (pointers.size === 0) isDragging = false;
  };
  /** The browser has taken it for a scroll or a zoom of the page: then nothing has been turned. */
  const cancel = (event: PointerEvent) => {
    if (isDragging && start && pointers.has(event.pointerId)) start.back();
    up(event);
  };
  const wheel = (event: WheelEvent) => {
    if (!wantsWheel(element, event)) return;
    event.preventDefault();
    step(0, 0, wheelFactor(event));
  };
  const key = (event: KeyboardEvent) => {
    if (event.target !== element || event.ctrlKey || event.metaKey || event.altKey) return;
    const by = event.shiftKey ? PER_FINE_KEY : PER_KEY;
    const actions: Record<string, () => void> = {
      ArrowLeft: () => step(-by, 0, 1),
      ArrowRight: () => step(by, 0, 1),
      ArrowUp: () => step(0, by, 1),
      ArrowDown: () => step(0, -by, 1),
      '+': () => step(0, 0, PER_ZOOM_KEY),
      '=': () => step(0, 0, PER_ZOOM_KEY),
      '-': () => step(0, 0, 1 / PER_ZOOM_KEY),
      '\u2212': () => step(0, 0, 1 / PER_ZOOM_KEY),
      '0': () => {
        ahead.forget();
        orbit.home();
      },
    };
    const action = actions[event.key];
    if (!action) return;
    event.preventDefault();
    event.stopPropagation();
    action();
  };

  const controller = new AbortController();
  const { signal } = controller;
  element.addEventListener('pointerdown', down, { signal });
  element.addEventListener('pointermove', move, { signal });
  element.addEventListener('pointerup', up, { signal });
  element.addEventListener('pointercancel', cancel, { signal });
  element.addEventListener('wheel', wheel, { signal, passive: false });
  element.addEventListener('keydown', key, { signal });
  return () => controller.abort();
}

function limited(from: FreeView, turn: number, lift: number, factor: number): FreeView {
  const between = (x: number, least: number, most: number) => Math.min(Math.max(x, least), most);
  return {
    azimuth: rounded(wrapped(from.azimuth + turn), 10),
    elevation: rounded(between(from.elevation + lift, -90, 90), 10),
    zoom: rounded(between(from.zoom * factor, ZOOM_RANGE.least, ZOOM_RANGE.most), 1000),
  };
}

/**
 * Rounds a number of the view, so that it is short in the link; a tenth of a degree is below 1 px.
 */
function rounded(x: number, parts: number): number {
  return Math.round(x * parts) / parts;
}

/** Whether the target is a button or handle, which handles its own presses. */
function isControl(target: EventTarget | null): boolean {
  return target instanceof Element && target.closest('button, a, input, [data-handle]') !== null;
}

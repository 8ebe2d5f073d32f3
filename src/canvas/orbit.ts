import { type FreeView, ZOOM_RANGE } from '../state/camera-view.ts';
import { Ahead } from '../ui/ahead.ts';
import { watchDrags } from '../ui/drags.ts';
import { wantsWheel, wheelFactor } from '../ui/wheel.ts';
import { wrapped } from './camera.ts';

/**
 * Degrees per px of a drag and per key press; the factor of the zoom per key press.
 */
const PER_PIXEL = 0.4;
const PER_KEY = 5;
const PER_FINE_KEY = 1;
const PER_ZOOM_KEY = 1.2;

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
  let start: { readonly view: FreeView; readonly back: () => void } | null = null;
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
  watchDrags(
    element,
    {
      takes: (event) => event.button === 0 && !isControl(event.target),
      begin() {
        start = { view: orbit.current(), back: orbit.keep() };
      },
      move(now, from) {
        if (!start) return;
        const pinch = from.spread > 0 && now.spread > 0 ? now.spread / from.spread : 1;
        const [dx, dy] = [now.x - from.x, now.y - from.y];
        orbit.turn(limited(start.view, -dx * PER_PIXEL, dy * PER_PIXEL, pinch));
      },
      // A drag that the browser has taken for a scroll or a zoom of the page has turned nothing.
      end: (isCancelled) => isCancelled && start?.back(),
    },
    signal,
  );
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

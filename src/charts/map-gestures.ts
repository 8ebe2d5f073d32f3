import { SIDE } from '../lab/atlas/window.ts';
import { wantsWheel, wheelPixels } from '../ui/wheel.ts';
import { placeIn, sizeOf } from '../ui/zoom.ts';

/** Column and row of a pixel, rows from the bottom. */
export type Cell = readonly [column: number, row: number];

/** Two opposite corners. */
export type Corners = readonly [Cell, Cell];

/** What is done on a map. Each is told where it happens; none changes anything by itself. */
export interface Gestures {
  point(cell: Cell | null): void;
  pick(cell: Cell): void;
  /** Zooms in by so many decades about a pixel. */
  zoom(decades: number, about: Cell): void;
  /** Moves the window by so many pixels. */
  pan(columns: number, rows: number): void;
  /** Marks a rectangle; null takes the mark away. */
  mark(corners: Corners | null): void;
  /** Back to the present ray. */
  home(): void;
  /** The pixel that is pointed at now. */
  cursor(): Cell | null;
  /** Whether a drag marks a rectangle in place of moving the window. */
  marks(): boolean;
}

/** px from which a press is a drag. */
const DRAG_FROM = 4;
/** Decades per wheel pixel, and per press of + or −. */
const PER_WHEEL_PIXEL = 0.0025;
const PER_KEY = 0.25;
/** Pixels of the map that Shift and an arrow move the window; Ctrl and an arrow, the pointer. */
const PAN_KEY = SIDE / 16;
const JUMP = 16;
const CENTRE: Cell = [SIDE / 2, SIDE / 2];

/**
 * Watches a map's element: mouse, wheel, fingers and keys. One finger scrolls the page; two move
 * and zoom the map.
 */
export function watchMap(element: HTMLElement, gestures: Gestures): () => void {
  const pointers = new Map<number, { x: number; y: number }>();
  let start: { readonly cell: Cell; readonly x: number; readonly y: number } | null = null;
  let isDragging = false;
  let pinch: { spread: number; x: number; y: number } | null = null;
  let corner: Cell | null = null;

  const scale = (): number => SIDE / Math.max(1, sizeOf(element).width);
  const cellAt = (event: Pick<MouseEvent, 'clientX' | 'clientY'>): Cell => {
    const { x, y } = placeIn(element, event);
    return within([Math.floor(x * scale()), SIDE - 1 - Math.floor(y * scale())]);
  };

  const down = (event: PointerEvent): void => {
    if (event.button !== 0) return;
    const place = placeIn(element, event);
    pointers.set(event.pointerId, { ...place });
    isDragging = false;
    pinch = spreadOf(pointers);
    start = pointers.size === 1 ? { cell: cellAt(event), ...place } : null;
    element.focus({ preventScroll: true });
  };
  const move = (event: PointerEvent): void => {
    const pointer = pointers.get(event.pointerId);
    if (!pointer) {
      gestures.point(cellAt(event));
      return;
    }
    const before = { ...pointer };
    Object.assign(pointer, placeIn(element, event));
    if (pinch) {
      moveTwo();
      return;
    }
    if (!start || event.pointerType === 'touch') return;
    if (!isDragging) {
      if (Math.hypot(pointer.x - start.x, pointer.y - start.y) < DRAG_FROM) return;
      isDragging = true;
      element.setPointerCapture(event.pointerId);
    }
    if (gestures.marks() || event.shiftKey) gestures.mark([start.cell, cellAt(event)]);
    else panBy(pointer.x - before.x, pointer.y - before.y);
  };
  let rest = { x: 0, y: 0 };
  /** Whole pixels at a time; what is left waits for the next move. */
  const panBy = (dx: number, dy: number): void => {
    rest = { x: rest.x - dx * scale(), y: rest.y + dy * scale() };
    const [columns, rows] = [Math.trunc(rest.x), Math.trunc(rest.y)];
    rest = { x: rest.x - columns, y: rest.y - rows };
    if (columns !== 0 || rows !== 0) gestures.pan(columns, rows);
  };
  const moveTwo = (): void => {
    const now = spreadOf(pointers);
    if (!now || !pinch) return;
    panBy(now.x - pinch.x, now.y - pinch.y);
    const decades = Math.log10(now.spread / pinch.spread);
    const about = within([Math.floor(now.x * scale()), SIDE - 1 - Math.floor(now.y * scale())]);
    if (Number.isFinite(decades) && decades !== 0) gestures.zoom(decades, about);
    pinch = now;
  };
  const up = (event: PointerEvent): void => {
    if (!pointers.delete(event.pointerId)) return;
    if (start && !isDragging && !pinch && event.type === 'pointerup') gestures.pick(start.cell);
    pinch = spreadOf(pointers);
    start = null;
    isDragging = false;
    rest = { x: 0, y: 0 };
  };
  const leave = (): void => {
    if (pointers.size === 0 && document.activeElement !== element) gestures.point(null);
  };
  const wheel = (event: WheelEvent): void => {
    if (!wantsWheel(element, event)) return;
    event.preventDefault();
    gestures.zoom(wheelPixels(event) * PER_WHEEL_PIXEL, cellAt(event));
  };
  const key = (event: KeyboardEvent): void => {
    if (event.altKey || event.metaKey) return;
    const at = gestures.cursor() ?? CENTRE;
    const go = (columns: number, rows: number): void => {
      if (event.shiftKey) {
        gestures.pan(columns * PAN_KEY, rows * PAN_KEY);
        return;
      }
      const by = event.ctrlKey ? JUMP : 1;
      const next = within([at[0] + columns * by, at[1] + rows * by]);
      gestures.point(next);
      if (corner) gestures.mark([corner, next]);
    };
    const mark = (): void => {
      if (corner) {
        gestures.mark([corner, at]);
        corner = null;
      } else {
        corner = at;
        gestures.mark([at, at]);
      }
    };
    const actions: Readonly<Record<string, () => void>> = {
      ArrowLeft: () => go(-1, 0),
      ArrowRight: () => go(1, 0),
      ArrowUp: () => go(0, 1),
      ArrowDown: () => go(0, -1),
      '+': () => gestures.zoom(PER_KEY, at),
      '=': () => gestures.zoom(PER_KEY, at),
      '-': () => gestures.zoom(-PER_KEY, at),
      '\u2212': () => gestures.zoom(-PER_KEY, at),
      PageUp: () => gestures.zoom(1, at),
      PageDown: () => gestures.zoom(-1, at),
      '0': () => gestures.home(),
      Home: () => gestures.home(),
      Enter: () => gestures.pick(at),
      ' ': () => gestures.pick(at),
      r: mark,
      Escape: () => {
        corner = null;
        gestures.mark(null);
      },
    };
    const action = actions[event.key];
    if (!action || (event.ctrlKey && !event.key.startsWith('Arrow'))) return;
    event.preventDefault();
    event.stopPropagation();
    action();
  };

  const controller = new AbortController();
  const { signal } = controller;
  element.addEventListener('pointerdown', down, { signal });
  element.addEventListener('pointermove', move, { signal });
  element.addEventListener('pointerup', up, { signal });
  element.addEventListener('pointercancel', up, { signal });
  element.addEventListener('pointerleave', leave, { signal });
  element.addEventListener('wheel', wheel, { signal, passive: false });
  element.addEventListener('keydown', key, { signal });
  element.addEventListener('focus', () => gestures.point(gestures.cursor() ?? CENTRE), { signal });
  return () => controller.abort();
}

const within = ([column, row]: Cell): Cell => [
  Math.min(Math.max(column, 0), SIDE - 1),
  Math.min(Math.max(row, 0), SIDE - 1),
];

/** Middle and distance of two fingers; null for fewer or more. */
function spreadOf(pointers: ReadonlyMap<number, { readonly x: number; readonly y: number }>) {
  const [a, b] = [...pointers.values()];
  if (!a || !b || pointers.size > 2) return null;
  return { spread: Math.hypot(a.x - b.x, a.y - b.y), x: (a.x + b.x) / 2, y: (a.y + b.y) / 2 };
}

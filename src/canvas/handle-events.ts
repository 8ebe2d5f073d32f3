import type { Handle } from '../state/handles.ts';
import { placeIn } from '../ui/zoom.ts';
import type { HandleDrag } from './handle-drag.ts';
import type { HandlePlace } from './handle-place.ts';
import type { Modifiers } from './snap-drag.ts';

/** Radius in px in which a press hits a handle, by pointer type; as in scene.css. */
const HIT_RADIUS = { fine: 16, coarse: 22 } as const;

/** Listens to pointers and keys on the handles. `placed`: the handles as drawn last. */
export function listenToHandles(
  svg: SVGElement,
  drag: HandleDrag,
  placed: () => readonly HandlePlace[],
): () => void {
  const controller = new AbortController();
  const { signal } = controller;
  /** The handle that was focused by a mouse press, which shows no focus ring. */
  let byMouse: Element | null = null;
  const setByMouse = (element: Element | null) => {
    byMouse = element;
    svg.classList.toggle('by-mouse', element !== null);
  };

  const where = (event: PointerEvent) => placeIn(svg, event);
  /** The handle whose centre is nearest to the pointer. */
  const under = (event: PointerEvent): HandlePlace | undefined => {
    const symbol = symbolOf(event.target);
    const hit = placed().find(({ handle }) => handle.symbol === symbol);
    if (!hit || axisOf(event.target) !== null) return hit;
    const { x, y } = where(event);
    const far = matchMedia('(any-pointer: coarse)').matches ? HIT_RADIUS.coarse : HIT_RADIUS.fine;
    const distance = ({ spot }: HandlePlace) =>
      spot ? Math.hypot(spot.x - x, spot.y - y) : Infinity;
    const nearest = placed().reduce((a, b) => (distance(b) < distance(a) ? b : a), hit);
    return distance(nearest) <= far ? nearest : hit;
  };
  const down = (event: PointerEvent) => {
    const found = under(event);
    if (!found || event.button !== 0 || drag.pointer !== null) return;
    // The browser's default would focus the topmost handle, or scroll.
    event.preventDefault();
    const element = elementOf(svg, found.handle);
    setByMouse(event.pointerType === 'mouse' ? element : null);
    element?.focus({ preventScroll: true });
    svg.setPointerCapture(event.pointerId);
    const { x, y } = where(event);
    drag.take(found, axisOf(event.target), event.pointerId, x, y);
  };
  const move = (event: PointerEvent) => {
    if (drag.pointer === event.pointerId) {
      const { x, y } = where(event);
      drag.move(x, y, modifiers(event));
    } else if (drag.pointer === null && event.pointerType === 'mouse') {
      drag.hover(under(event)?.handle.symbol ?? null);
    }
  };
  const up = (event: PointerEvent) => {
    if (drag.pointer === event.pointerId) drag.end();
  };
  const focus = (event: FocusEvent) => {
    const symbol = symbolOf(event.target);
    drag.focus(event.target === byMouse ? null : symbol);
  };
  const blur = (event: FocusEvent) => {
    if (event.target === byMouse) setByMouse(null);
    drag.focus(null);
  };
  const key = (event: KeyboardEvent) => {
    const symbol = symbolOf(event.target);
    const handle = placed().find((found) => found.handle.symbol === symbol)?.handle;
    if (!handle || drag.pointer !== null) return;
    if (!drag.press(handle, event)) return;
    event.preventDefault();
    event.stopPropagation();
    setByMouse(null);
    drag.focus(symbol);
  };
  /** Keys during a drag. */
  const duringDrag = (event: KeyboardEvent) => {
    if (drag.pointer === null) return;
    if (event.key === 'Escape' && event.type === 'keydown') drag.cancel();
    else if (event.key === 'Alt' || event.key === 'Shift') drag.modify(modifiers(event));
    else return;
    event.preventDefault();
    event.stopPropagation();
  };

  svg.addEventListener('pointerdown', down, { signal });
  // The browser's default would focus the topmost element.
  svg.addEventListener('mousedown', (event) => event.preventDefault(), { signal });
  // Chromium ignores touch-action inside of an SVG, so the page would scroll during a drag.
  const still = (event: TouchEvent) => event.preventDefault();
  svg.addEventListener('touchstart', still, { signal, passive: false });
  svg.addEventListener('pointermove', move, { signal });
  svg.addEventListener('pointerup', up, { signal });
  svg.addEventListener('pointercancel', up, { signal });
  svg.addEventListener('lostpointercapture', up, { signal });
  svg.addEventListener('pointerleave', () => drag.hover(null), { signal });
  // Not on the drawing itself: Chromium would make that a Tab stop.
  svg.parentElement?.addEventListener('focusin', focus, { signal });
  svg.parentElement?.addEventListener('focusout', blur, { signal });
  svg.addEventListener('keydown', key, { signal });
  window.addEventListener('keydown', duringDrag, { signal, capture: true });
  window.addEventListener('keyup', duringDrag, { signal, capture: true });
  return () => controller.abort();
}

function symbolOf(target: EventTarget | null): string | null {
  const element = target instanceof Element ? target.closest('[data-handle]') : null;
  return element?.getAttribute('data-handle') ?? null;
}

function axisOf(target: EventTarget | null): 0 | 1 | 2 | null {
  const element = target instanceof Element ? target.closest('[data-axis]') : null;
  return element ? (Number(element.getAttribute('data-axis')) as 0 | 1 | 2) : null;
}

function elementOf(svg: SVGElement, { symbol }: Handle): SVGElement | null {
  return svg.querySelector(`[role=slider][data-handle="${CSS.escape(symbol)}"]`);
}

function modifiers(event: PointerEvent | KeyboardEvent): Modifiers {
  return { free: event.altKey, fine: event.shiftKey };
}

/** px of movement from which a press is a drag and not a click; a finger is less steady. */
const DRAG_FROM = { mouse: 3, pen: 3, touch: 9 } as const;

/** Middle of the pointers that are down, and their distance, in px; 0 for one. */
export interface Grip {
  readonly x: number;
  readonly y: number;
  readonly spread: number;
}

interface Drags {
  /** Whether a press is one, and not that of a control or a thing at this place. */
  takes(event: PointerEvent): boolean;
  /** One finger drags whichever way it goes: nothing scrolls here. */
  readonly everyWay?: boolean;
  /** Pointers were put down or lifted: what follows is told from here. */
  begin?(): void;
  /** The press has become a drag. */
  drags?(): void;
  move(now: Grip, from: Grip, event: PointerEvent): void;
  /** The last pointer of a drag is lifted, or the browser took the drag for a scroll of its own. */
  end?(isCancelled: boolean): void;
}

/**
 * Drags with one pointer and pinches with two. One finger that goes up or down first scrolls the
 * page, whatever it does then.
 */
export function watchDrags(element: HTMLElement, drags: Drags, signal?: AbortSignal): void {
  const pointers = new Map<number, { x: number; y: number }>();
  let from: Grip | null = null;
  let isDragging = false;

  const grip = (): Grip | null => {
    const [a, b] = [...pointers.values()];
    if (!a) return null;
    return b
      ? { x: (a.x + b.x) / 2, y: (a.y + b.y) / 2, spread: Math.hypot(a.x - b.x, a.y - b.y) }
      : { ...a, spread: 0 };
  };
  const begin = (): void => {
    from = grip();
    if (from) drags.begin?.();
  };
  const drag = (): void => {
    isDragging = true;
    drags.drags?.();
  };
  const down = (event: PointerEvent): void => {
    if (pointers.size === 2 || !drags.takes(event)) return;
    pointers.set(event.pointerId, { x: event.clientX, y: event.clientY });
    // As a finger is by itself: its moves are heard however far the first one goes. By what is
    // pressed, so that a click reaches that.
    (event.target as Element).setPointerCapture(event.pointerId);
    begin();
    if (pointers.size === 2 && !isDragging) drag();
  };
  const move = (event: PointerEvent): void => {
    const pointer = pointers.get(event.pointerId);
    if (!pointer || !from) return;
    [pointer.x, pointer.y] = [event.clientX, event.clientY];
    const now = grip();
    if (!now) return;
    if (!isDragging) {
      const [dx, dy] = [now.x - from.x, now.y - from.y];
      const kind = event.pointerType as keyof typeof DRAG_FROM;
      if (Math.hypot(dx, dy) < (DRAG_FROM[kind] ?? DRAG_FROM.mouse)) return;
      if (kind === 'touch' && !drags.everyWay && Math.abs(dy) > Math.abs(dx)) {
        pointers.delete(event.pointerId);
        begin();
        return;
      }
      drag();
      // What was pressed may be drawn anew meanwhile.
      element.setPointerCapture(event.pointerId);
    }
    drags.move(now, from, event);
  };
  const up = (event: PointerEvent): void => {
    if (!pointers.delete(event.pointerId)) return;
    const isEnd = isDragging && pointers.size === 0;
    if (pointers.size === 0) isDragging = false;
    // After a pinch the remaining finger starts a new gesture.
    begin();
    if (isEnd) drags.end?.(false);
  };
  const cancel = (event: PointerEvent): void => {
    if (!pointers.delete(event.pointerId)) return;
    if (isDragging) drags.end?.(true);
    if (pointers.size === 0) isDragging = false;
    begin();
  };
  const options = signal ? { signal } : {};
  element.addEventListener('pointerdown', down, options);
  element.addEventListener('pointermove', move, options);
  element.addEventListener('pointerup', up, options);
  element.addEventListener('pointercancel', cancel, options);
}

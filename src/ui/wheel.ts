/** px per unit of a wheel event, by its deltaMode: pixels, lines, pages. */
const UNITS = [1, 16, 400] as const;
const PER_PIXEL = 1.0015;

/** px that a wheel event stands for, above 0 forwards. */
export function wheelPixels(event: WheelEvent): number {
  const pixels = -event.deltaY * UNITS[event.deltaMode as 0 | 1 | 2];
  // A pinch on a touchpad arrives as a wheel with ctrl and small steps.
  return pixels * (event.ctrlKey ? 6 : 1);
}

/** By which a wheel event brings nearer: above 1 forwards. */
export const wheelFactor = (event: WheelEvent): number => PER_PIXEL ** wheelPixels(event);

/**
 * Whether a wheel event zooms: if the page cannot scroll, if the element has the focus, or with
 * ctrl, as in a touchpad's pinch. Else it scrolls the page.
 */
export function wantsWheel(element: HTMLElement, event: WheelEvent): boolean {
  const page = document.scrollingElement;
  const canScroll = page !== null && page.scrollHeight > page.clientHeight + 1;
  return (
    !canScroll ||
    event.ctrlKey ||
    event.metaKey ||
    element.contains((element.getRootNode() as Document | ShadowRoot).activeElement)
  );
}

/**
 * The factor of the style sheet's `zoom` on an element; 1 in browsers that do not tell it. The
 * browser gives rectangles and pointers as they are seen, and sizes like clientWidth without it.
 */
export const zoomOf = (element: Element): number => element.currentCSSZoom ?? 1;

/** Where a pointer is, from the element's upper left corner, in the element's own CSS pixels. */
export function placeIn(
  element: Element,
  { clientX, clientY }: Pick<MouseEvent, 'clientX' | 'clientY'>,
): { x: number; y: number } {
  const { left, top } = element.getBoundingClientRect();
  const zoom = zoomOf(element);
  return { x: (clientX - left) / zoom, y: (clientY - top) / zoom };
}

/** The size of an element in its own CSS pixels, to a fraction of one. */
export function sizeOf(element: Element): { width: number; height: number } {
  const { width, height } = element.getBoundingClientRect();
  const zoom = zoomOf(element);
  return { width: width / zoom, height: height / zoom };
}

/** The element whose data-theme decides on the colours of `place`. */
export function themed(place: Element): Element {
  const root = place.getRootNode();
  return root instanceof ShadowRoot ? root.host : document.documentElement;
}

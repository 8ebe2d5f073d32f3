/**
 * Highlights every occurrence of a symbol while one of them is hovered or focused. An element names
 * its symbol by data-symbol="E" (or "E.x", of which the part before the dot counts); highlighted
 * elements have the class `lit`. Views that draw on a canvas listen to `onHighlight`.
 */
type Highlight = string | null;

type Listener = (symbol: Highlight) => void;

/** Where each listener draws. */
const listeners = new Map<Listener, Element>();
/** What is lit below each element that is watched. */
const lit = new Map<Element, string>();

/** Calls back when what is lit around `place` has changed. */
export function onHighlight(place: Element, listener: Listener): () => void {
  listeners.set(listener, place);
  return () => listeners.delete(listener);
}

/** The symbol that is highlighted now around `place`, for elements that are created meanwhile. */
export function highlighted(place: Element): Highlight {
  for (const [root, symbol] of lit) if (root.contains(place)) return symbol;
  return null;
}

function baseSymbol(symbol: string): string {
  return symbol.split('.')[0] ?? symbol;
}

/** Watches pointer and focus below `root`. Returns a function that stops it. */
export function watchHighlight(root: HTMLElement): () => void {
  const enter = (event: Event) => set(root, symbolOf(event.target));
  const leave = () => {
    const { activeElement } = root.getRootNode() as Document | ShadowRoot;
    set(root, symbolOf(activeElement));
  };
  root.addEventListener('pointerover', enter);
  root.addEventListener('pointerleave', leave);
  root.addEventListener('focusin', enter);
  root.addEventListener('focusout', leave);
  return () => {
    root.removeEventListener('pointerover', enter);
    root.removeEventListener('pointerleave', leave);
    root.removeEventListener('focusin', enter);
    root.removeEventListener('focusout', leave);
  };
}

function symbolOf(target: EventTarget | null): Highlight {
  const element = target instanceof Element ? target.closest('[data-symbol]') : null;
  const symbol = element?.getAttribute('data-symbol');
  return symbol ? baseSymbol(symbol) : null;
}

function set(root: HTMLElement, symbol: Highlight): void {
  if (symbol === (lit.get(root) ?? null)) return;
  if (symbol === null) lit.delete(root);
  else lit.set(root, symbol);
  for (const element of root.querySelectorAll('.lit')) element.classList.remove('lit');
  if (symbol) {
    const escaped = CSS.escape(symbol);
    const found = root.querySelectorAll(`[data-symbol="${escaped}"], [data-symbol^="${escaped}."]`);
    for (const element of found) element.classList.add('lit');
  }
  for (const [listener, place] of listeners) if (root.contains(place)) listener(symbol);
}

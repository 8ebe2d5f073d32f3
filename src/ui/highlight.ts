/**
 * Highlights every occurrence of a symbol while one of them is hovered or focused. An element names
 * its symbol by data-symbol="E" (or "E.x", of which the part before the dot counts); highlighted
 * elements have the class `lit`. Views that draw on a canvas listen to `onHighlight`.
 */
type Highlight = string | null;

type Listener = (symbol: Highlight) => void;

const listeners = new Set<Listener>();
let current: Highlight = null;

export function onHighlight(listener: Listener): () => void {
  listeners.add(listener);
  return () => listeners.delete(listener);
}

/** The symbol that is highlighted now, for elements that are created meanwhile. */
export function highlighted(): Highlight {
  return current;
}

function baseSymbol(symbol: string): string {
  return symbol.split('.')[0] ?? symbol;
}

/** Watches pointer and focus below `root`. Returns a function that stops it. */
export function watchHighlight(root: HTMLElement): () => void {
  const enter = (event: Event) => set(root, symbolOf(event.target));
  const leave = () => set(root, symbolOf(document.activeElement));
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
  if (symbol === current) return;
  current = symbol;
  for (const element of root.querySelectorAll('.lit')) element.classList.remove('lit');
  if (symbol) {
    const escaped = CSS.escape(symbol);
    const lit = root.querySelectorAll(`[data-symbol="${escaped}"], [data-symbol^="${escaped}."]`);
    for (const element of lit) element.classList.add('lit');
  }
  for (const listener of listeners) listener(symbol);
}

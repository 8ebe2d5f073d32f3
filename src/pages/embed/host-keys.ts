/**
 * Passes keys that no control of Graze needs to the host: Page Up and Page Down everywhere, arrows
 * on the scene itself. Returns a function that removes the listener.
 */
export function leaveKeys(root: EventTarget, pass: (event: KeyboardEvent) => void): () => void {
  const before = (event: Event): void => {
    const { key, target } = event as KeyboardEvent;
    const onScene = target instanceof Element && target.classList.contains('scene-root');
    if (!/^Page/.test(key) && !(onScene && /^Arrow/.test(key))) return;
    event.stopImmediatePropagation();
    event.preventDefault();
    pass(event as KeyboardEvent);
  };
  root.addEventListener('keydown', before, true);
  return () => root.removeEventListener('keydown', before, true);
}

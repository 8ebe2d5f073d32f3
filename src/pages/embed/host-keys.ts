/**
 * Leaves to the host what no control of Graze needs: Page Up and Page Down anywhere, arrows on the
 * scene itself, and whatever was pressed on nothing. Returns a function that stops it.
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

/** Largest ms between key presses on one control that count as one gesture. */
const PAUSE_MS = 1000;

/**
 * Returns a function that names the gesture in progress: from pointer down to pointer up, or a run
 * of key presses on one control; null outside of any gesture.
 */
export function watchGestures(root: HTMLElement): () => string | null {
  let count = 0;
  let held: string | null = null;
  let run: { name: string; target: EventTarget | null; until: number } | null = null;
  const begin = (): void => {
    held = `pointer ${++count}`;
    run = null;
  };
  // The click after a release belongs to the gesture as well.
  const end = (): void => {
    setTimeout(() => {
      held = null;
    });
  };
  const key = (event: KeyboardEvent): void => {
    const now = event.timeStamp;
    const same = run !== null && run.target === event.target && now < run.until;
    const name = same && run && /^(Arrow|Page)/.test(event.key) ? run.name : `keys ${++count}`;
    run = { name, target: event.target, until: now + PAUSE_MS };
  };
  root.addEventListener('pointerdown', begin, true);
  window.addEventListener('pointerup', end, true);
  window.addEventListener('pointercancel', end, true);
  root.addEventListener('keydown', key, true);
  return () => held ?? (run && performance.now() < run.until ? run.name : null);
}

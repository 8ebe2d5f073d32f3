/** Largest ms between key presses on one control, or turns of the wheel, in one gesture. */
const PAUSE_MS = 1000;

/**
 * Returns a function that names the gesture in progress: from pointer down to pointer up, or a run
 * of key presses on one control, or of the wheel; null outside of any gesture.
 */
export function watchGestures(
  root: EventTarget,
  everywhere: EventTarget = window,
): () => string | null {
  let count = 0;
  let held: string | null = null;
  let run: { name: string; target: EventTarget | null; until: number } | null = null;
  const begin = (event: Event): void => {
    // A second finger belongs to the gesture of the first one.
    if ((event as PointerEvent).isPrimary === false && held !== null) return;
    held = `pointer ${++count}`;
    run = null;
  };
  // The click after a release belongs to the gesture as well. On a busy machine the next press
  // comes before this timer: its gesture goes on.
  const end = (): void => {
    const ended = held;
    setTimeout(() => {
      if (held === ended) held = null;
    });
  };
  const key = (given: Event): void => {
    const event = given as KeyboardEvent;
    const now = event.timeStamp;
    const same = run !== null && run.target === event.target && now < run.until;
    const isRun = /^(Arrow|Page|[-+=\u2212]$)/.test(event.key);
    const name = same && run && isRun ? run.name : `keys ${++count}`;
    run = { name, target: event.target, until: now + PAUSE_MS };
  };
  const wheel = ({ target, timeStamp: now }: Event): void => {
    const same = run?.name.startsWith('wheel') && now < run.until;
    const name = same && run ? run.name : `wheel ${++count}`;
    run = { name, target, until: now + PAUSE_MS };
  };
  root.addEventListener('pointerdown', begin, true);
  everywhere.addEventListener('pointerup', end, true);
  everywhere.addEventListener('pointercancel', end, true);
  root.addEventListener('keydown', key, true);
  root.addEventListener('wheel', wheel, { capture: true, passive: true });
  return () => held ?? (run && performance.now() < run.until ? run.name : null);
}

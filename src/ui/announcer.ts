/** Pause before a text is announced, in ms: longer than the time between two steps of a slider. */
const QUIET_MS = 500;

/** The live region of the page: the last text is announced once no new one has come for a while. */
export function createAnnouncer(host: HTMLElement): (text: string) => void {
  const region = document.createElement('div');
  region.className = 'visually-hidden announcer';
  region.setAttribute('role', 'status');
  region.setAttribute('aria-live', 'polite');
  host.append(region);
  let timer = 0;
  return (text) => {
    clearTimeout(timer);
    timer = window.setTimeout(() => {
      // A screen reader is silent on an unchanged text: a no-break space makes a repeated one new.
      region.textContent = region.textContent === text ? `${text}\u00a0` : text;
    }, QUIET_MS);
  };
}

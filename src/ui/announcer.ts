/** Long enough that a slider under way is not read out at every step. */
const QUIET_MS = 500;

/** The one voice of the page: what is said last, after a pause, is what is read. */
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
      // The same words again are not read unless the text was another one in between.
      region.textContent = region.textContent === text ? `${text}\u00a0` : text;
    }, QUIET_MS);
  };
}

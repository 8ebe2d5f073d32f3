/** Pause before something is announced, in ms: longer than the time between two slider steps. */
const QUIET_MS = 500;

/** What is announced; words that are made when it is say what is so then. '' says nothing. */
type Words = string | (() => string);

/** Takes the place of what waits under the same `about`; a 'deed' is said before what it did. */
export type Announce = (words: Words, about?: string) => void;

/** The live region of the page: what waits is announced once nothing new has come for a while. */
export function createAnnouncer(host: HTMLElement): Announce {
  const region = document.createElement('div');
  region.className = 'visually-hidden announcer';
  region.setAttribute('role', 'status');
  region.setAttribute('aria-live', 'polite');
  host.append(region);
  const waiting = new Map<string, Words>();
  let timer = 0;
  const speak = (): void => {
    const deed = waiting.get('deed') ?? '';
    waiting.delete('deed');
    const all = [deed, ...waiting.values()].map((one) => (typeof one === 'string' ? one : one()));
    waiting.clear();
    const text = all.filter(Boolean).join(' ');
    // A screen reader is silent on an unchanged text: a no-break space makes a repeated one new.
    if (text) region.textContent = region.textContent === text ? `${text}\u00a0` : text;
  };
  return (words, about = 'news') => {
    waiting.set(about, words);
    clearTimeout(timer);
    timer = window.setTimeout(speak, QUIET_MS);
  };
}

import { wordsOf } from './words-of.ts';

/** Pause before something is announced, in ms: longer than the time between two slider steps. */
const QUIET_MS = 500;

/** What is said when it comes or gets other words, by whatever view it stands in. */
const SAID = '[data-say]';

/** What is announced; words that are made when it is say what is so then. '' says nothing. */
type Words = string | (() => string);

/** Takes the place of what waits under the same `about`; a 'deed' is said before what it did. */
export type Announce = (words: Words, about?: unknown) => void;

/**
 * The live region of the page, the only one: what waits is announced once nothing new has come for
 * a while. It says too what stands within `host` in an element with `data-say` ("problem" for what
 * went wrong), whenever that has other words than before, and again if its form is handed in and
 * gets the same answer. Behind a modal dialog nothing is heard: while one is open the region
 * stands in it.
 */
export function createAnnouncer(host: HTMLElement): Announce {
  const region = document.createElement('div');
  region.className = 'visually-hidden announcer';
  region.setAttribute('role', 'status');
  region.setAttribute('aria-live', 'polite');
  host.append(region);
  const waiting = new Map<unknown, Words>();
  let timer = 0;
  const wait = (): void => {
    clearTimeout(timer);
    timer = window.setTimeout(speak, QUIET_MS);
  };
  /** Puts the region where it is heard; true if it was there. */
  const isAtHome = (): boolean => {
    const home = [...host.querySelectorAll('dialog:modal')].at(-1) ?? host;
    if (region.parentNode === home) return true;
    // What is in a region when it comes is not heard.
    region.textContent = '';
    home.append(region);
    return false;
  };
  const speak = (): void => {
    if (!isAtHome()) {
      wait();
      return;
    }
    const inTurn = [...waiting].sort(([a], [b]) => rank(a) - rank(b));
    waiting.clear();
    const all = inTurn.map(([, one]) => (typeof one === 'string' ? one : one()));
    const text = [...new Set(all)].filter(Boolean).join(' ');
    // A screen reader is silent on an unchanged text: a no-break space makes a repeated one new.
    if (text) region.textContent = region.textContent === text ? `${text}\u00a0` : text;
  };
  const announce: Announce = (words, about = 'news') => {
    waiting.set(about, words);
    wait();
  };

  const heard = new WeakMap<Element, string>();
  const notice = (found: Iterable<Element>): void => {
    for (const one of found) {
      announce(() => {
        if (!one.isConnected || !one.checkVisibility()) return '';
        const words = wordsOf(one);
        const isNew = heard.get(one) !== words;
        heard.set(one, words);
        return isNew ? words : '';
      }, one);
    }
  };
  notice(host.querySelectorAll(SAID));
  new MutationObserver((records) => notice(changedIn(records))).observe(host, {
    subtree: true,
    childList: true,
    characterData: true,
  });
  host.addEventListener('submit', ({ target }) => {
    const asked = [...(target as Element).querySelectorAll(SAID)];
    for (const one of asked) heard.delete(one);
    notice(asked);
  });
  return announce;
}

/** A deed, then what went wrong, then the rest. */
const rank = (about: unknown): number =>
  about === 'deed' ? 0 : about instanceof Element && about.matches('[data-say="problem"]') ? 1 : 2;

/** What is said of what these changes have touched or brought. */
function changedIn(records: readonly MutationRecord[]): Set<Element> {
  const found = new Set<Element>();
  for (const { target, addedNodes } of records) {
    const at = target instanceof Element ? target : target.parentElement;
    const around = at?.closest(SAID);
    if (around) found.add(around);
    for (const node of addedNodes) {
      if (!(node instanceof Element)) continue;
      if (node.matches(SAID)) found.add(node);
      for (const one of node.querySelectorAll(SAID)) found.add(one);
    }
  }
  return found;
}

import { zoomOf } from '../../ui/zoom.ts';

/*
 * A term of the derivation keeps its identity from step to step: `data-terms` of an element are the
 * numbers of the products that are in it.
 */

const TRAVEL_MS = 300;

/** The rectangle of each term of the present step. */
type Places = readonly { readonly terms: readonly string[]; readonly at: DOMRect }[];

const termsOf = (element: Element): string[] =>
  (element.getAttribute('data-terms') ?? '').split(' ').filter(Boolean);

const ofPresent = (host: Element): HTMLElement[] => [
  ...host.querySelectorAll<HTMLElement>('.walk-step.present [data-terms]'),
];

export const placesOf = (host: Element): Places =>
  ofPresent(host).map((element) => ({
    terms: termsOf(element),
    at: element.getBoundingClientRect(),
  }));

/** Moves each term of the present step from where it, or the term it is part of, was before. */
export function travel(host: Element, before: Places): void {
  if (matchMedia('(prefers-reduced-motion: reduce)').matches) return;
  for (const element of ofPresent(host)) {
    const terms = termsOf(element);
    const from = before.find((place) => place.terms.some((term) => terms.includes(term)));
    if (!from) continue;
    const to = element.getBoundingClientRect();
    const zoom = zoomOf(element);
    const [dx, dy] = [(from.at.left - to.left) / zoom, (from.at.top - to.top) / zoom];
    if (dx === 0 && dy === 0) continue;
    element.animate([{ transform: `translate(${dx}px, ${dy}px)` }, { transform: 'none' }], {
      duration: TRAVEL_MS,
      easing: 'ease-out',
    });
  }
}

const LIT = 'term-lit';

/** Highlights a hovered or focused term in every step, with the terms it came from. */
export function lightTerms(host: HTMLElement): void {
  const light = (target: EventTarget | null): void => {
    const chosen = target instanceof Element ? target.closest('[data-terms]') : null;
    const terms = chosen && host.contains(chosen) ? termsOf(chosen) : [];
    for (const element of host.querySelectorAll('[data-terms]')) {
      element.classList.toggle(
        LIT,
        termsOf(element).some((term) => terms.includes(term)),
      );
    }
  };
  host.addEventListener('pointerover', ({ target }) => light(target));
  host.addEventListener('pointerleave', () => light(document.activeElement));
  // A finger leaves before its click, and takes the focus away from a term.
  host.addEventListener('click', ({ target }) => light(target));
  host.addEventListener('focusin', ({ target }) => light(target));
  host.addEventListener('focusout', ({ relatedTarget }) => light(relatedTarget));
}

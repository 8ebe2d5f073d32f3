import { zoomOf } from '../../ui/zoom.ts';
import { termsOf, threadTo } from './walk-threads.ts';

/*
 * A term of the derivation keeps its identity from step to step: `data-terms` of an element are the
 * numbers of the products that are in it.
 */

const ANIMATION_MS = 300;

/** The rectangle of each term of the present step. */
type TermRectangles = readonly { readonly terms: readonly string[]; readonly at: DOMRect }[];

const ofPresent = (host: Element): HTMLElement[] => [
  ...host.querySelectorAll<HTMLElement>('.walk-step.present [data-terms]'),
];

export const termRectangles = (host: Element): TermRectangles =>
  ofPresent(host).map((element) => ({
    terms: termsOf(element),
    at: element.getBoundingClientRect(),
  }));

/**
 * Moves each term of the present step from where it, or the term it is part of, was before. `done`
 * is called when all have arrived.
 */
export function animateTerms(host: Element, before: TermRectangles, done: () => void): void {
  const ways: Promise<unknown>[] = [];
  if (matchMedia('(prefers-reduced-motion: reduce)').matches) return;
  for (const element of ofPresent(host)) {
    const terms = termsOf(element);
    const from = before.find((place) => place.terms.some((term) => terms.includes(term)));
    if (!from) continue;
    const to = element.getBoundingClientRect();
    const zoom = zoomOf(element);
    const [dx, dy] = [(from.at.left - to.left) / zoom, (from.at.top - to.top) / zoom];
    if (dx === 0 && dy === 0) continue;
    const way = along(threadTo(host, terms), dx, dy);
    const { finished } = element.animate(
      way.map(([x, y]) => ({ transform: `translate(${x}px, ${y}px)` })),
      { duration: ANIMATION_MS, easing: 'ease-out' },
    );
    // The promise of an element that is removed during its animation rejects.
    ways.push(finished.catch(() => null));
  }
  void Promise.all(ways).then(done);
}

/** Number of straight pieces that a way along a thread is made of. */
const PIECES = 16;

/**
 * The displacements of a term on its way from (dx, dy) to (0, 0): along its thread, where it has
 * one, else straight.
 */
function along(
  thread: SVGGeometryElement | null,
  dx: number,
  dy: number,
): readonly (readonly [number, number])[] {
  if (!thread)
    return [
      [dx, dy],
      [0, 0],
    ];
  const length = thread.getTotalLength();
  const place = (share: number) => thread.getPointAtLength(share * length);
  const [start, end] = [place(0), place(1)];
  // A term begins and ends a little beside its thread's ends.
  const [besideX, besideY] = [dx - start.x + end.x, dy - start.y + end.y];
  return Array.from({ length: PIECES + 1 }, (_, i) => {
    const share = i / PIECES;
    const { x, y } = place(share);
    return [x - end.x + (1 - share) * besideX, y - end.y + (1 - share) * besideY] as const;
  });
}

export const isAnimating = (host: Element): boolean =>
  ofPresent(host).some((element) => element.getAnimations().length > 0);

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

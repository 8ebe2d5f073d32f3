import './tab-stops.css';

/*
 * One Tab stop a group. A group is an element with the role of one that cannot be focused itself;
 * its items are the controls in it that Tab would stop at. Arrows, Home and End go from one to the
 * next, as in a toolbar of the ARIA Authoring Practices. What moves by arrows itself is no item:
 * a slider stays a stop of its own, as each thumb of theirs does, unless a box of its group sets
 * the same number by the same keys.
 */

const GROUP = '[role="group"]:not([tabindex])';
const CONTROL = 'a[href], button, input, select, textarea, summary, [tabindex]';
const SLIDER = 'input[type="range"], [role="slider"]';
const BOX = 'input:not([type="range"], [type="checkbox"], [type="radio"]), textarea';

/** Which way a key goes: along the items, or to the row above or below. */
export type Move = 'next' | 'previous' | 'first' | 'last' | 'above' | 'below';

const MOVES: Readonly<Record<string, Move>> = {
  ArrowRight: 'next',
  ArrowLeft: 'previous',
  ArrowDown: 'below',
  ArrowUp: 'above',
  Home: 'first',
  End: 'last',
};

/** Where an item stands, in px. */
export type ItemBox = Pick<DOMRect, 'left' | 'right' | 'top' | 'bottom'>;

/**
 * The index that a key leads to from `at`. Along the items it goes round; so do up and down where
 * they stand in one row or one column, else they lead to the nearest item of the row above or
 * below, or nowhere. `places` are asked for only then.
 */
export function target(
  move: Move,
  at: number,
  count: number,
  places: () => readonly ItemBox[],
): number {
  if (move === 'first') return 0;
  if (move === 'last') return count - 1;
  const by = move === 'next' || move === 'below' ? 1 : -1;
  const along = (at + by + count) % count;
  if (move === 'next' || move === 'previous') return along;
  const all = places();
  const here = all[at] as ItemBox;
  const others = all.filter((place) => place !== here);
  if (others.every((place) => !isApart(place, here))) return along;
  if (all.every((a) => all.every((b) => a === b || isApart(a, b)))) return along;
  const beyond = ({ top, bottom }: ItemBox): number =>
    move === 'below' ? top - here.bottom : here.top - bottom;
  const there = all.filter((place) => place !== here && beyond(place) > -SLACK);
  const nearest = Math.min(...there.map(beyond));
  const aside = (place: ItemBox): number => Math.abs(middle(place) - middle(here));
  const row = there.filter((place) => beyond(place) < nearest + SLACK);
  const best = row.reduce((a, b) => (aside(b) < aside(a) ? b : a), row[0] ?? here);
  return all.indexOf(best);
}

/** So much items of one row may differ in height, and rows overlap, in px. */
const SLACK = 4;

const isApart = (a: ItemBox, b: ItemBox): boolean =>
  a.top > b.bottom - SLACK || b.top > a.bottom - SLACK;

const middle = ({ left, right }: ItemBox): number => (left + right) / 2;

/** Whether an arrow leaves a box: its caret is at that end, or all of its text is selected. */
export function leavesBox(
  move: Move,
  box: Pick<HTMLInputElement, 'value' | 'selectionStart' | 'selectionEnd'>,
): boolean {
  const { value, selectionStart: from, selectionEnd: to } = box;
  if (move !== 'next' && move !== 'previous') return false;
  if (from === 0 && to === value.length) return true;
  return from === to && from === (move === 'next' ? value.length : 0);
}

/** Controls that this module has taken out of the order, which had been in it. */
const rested = new WeakSet<Element>();
const lastUsed = new WeakMap<Element, Element>();

/** The controls of a group that can be used now, sliders among them. */
const controlsIn = (group: Element): HTMLElement[] =>
  [...group.querySelectorAll<HTMLElement>(CONTROL)].filter(
    (control) =>
      control.parentElement?.closest(GROUP) === group &&
      (control.getAttribute('tabindex') !== '-1' || rested.has(control)) &&
      !control.matches(':disabled') &&
      control.checkVisibility({ visibilityProperty: true }),
  );

const itemsIn = (group: Element): HTMLElement[] =>
  controlsIn(group).filter((control) => !control.matches(SLIDER));

/** What of alternatives is chosen, where each of them says whether it is. */
function chosenOf(items: readonly Element[]): Element | undefined {
  const current = items.find((item) => item.matches('[aria-current]'));
  const isChoice = items.every((item) => item.hasAttribute('aria-pressed'));
  return current ?? (isChoice ? items.find((item) => item.ariaPressed === 'true') : undefined);
}

/** Where Tab enters: the box beside the slider in use, what is chosen, or where it was left. */
function stopOf(group: Element, controls: readonly Element[], items: readonly Element[]) {
  const at = document.activeElement;
  const beside = at?.matches(SLIDER) ? controls[controls.indexOf(at) - 1] : undefined;
  const last = lastUsed.get(group);
  return beside ?? chosenOf(items) ?? items.find((item) => item === last) ?? items[0];
}

/** Done when Tab is pressed, which is when it matters: no redrawing can spoil it. */
function setStops(): void {
  for (const group of document.querySelectorAll(GROUP)) {
    const controls = controlsIn(group);
    const items = controls.filter((control) => !control.matches(SLIDER));
    const hasBox = items.some((item) => item.matches(BOX));
    const stop = stopOf(group, controls, items);
    for (const control of controls) {
      const isSet = !control.matches(SLIDER) || (hasBox && control.matches('input'));
      if (!isSet) continue;
      if (control !== stop) rested.add(control);
      control.tabIndex = control === stop ? 0 : -1;
    }
  }
}

/**
 * Watches the keys of the page: one Tab stop a group, arrows in it, the focus kept where what had
 * it goes away, and, where there is a header, a first stop that leads past it to `main`. To be
 * called once.
 */
export function watchTabStops(main: HTMLElement, hasHeader: boolean): void {
  /** What is pressed after a click is the page's: arrows turn its examples. */
  let byPointer = false;
  addEventListener(
    'pointerdown',
    () => {
      byPointer = true;
    },
    true,
  );
  addEventListener(
    'keydown',
    ({ key }) => {
      if (key !== 'Tab') return;
      byPointer = false;
      setStops();
    },
    true,
  );
  document.body.addEventListener('keydown', (event) => {
    const at = event.target as HTMLElement;
    const move = MOVES[event.key];
    const group = at.parentElement?.closest(GROUP);
    if (!move || !group || event.defaultPrevented || at.matches(SLIDER)) return;
    if (event.altKey || event.ctrlKey || event.metaKey || event.shiftKey) return;
    const isBox = at.matches(BOX);
    if (isBox ? !leavesBox(move, at as HTMLInputElement) : byPointer) return;
    // Up and down are a list's own.
    if (at.matches('select') && event.key !== 'ArrowLeft' && event.key !== 'ArrowRight') return;
    const items = itemsIn(group);
    const from = items.indexOf(at);
    if (from < 0 || items.length < 2) return;
    const to = target(move, from, items.length, () =>
      items.map((item) => item.getBoundingClientRect()),
    );
    event.preventDefault();
    items[to]?.focus();
  });
  keepFocus(main);
  if (hasHeader) skipTo(main);
}

/** A control that had the focus, and what it was part of. */
interface LostFocus {
  readonly control: Element;
  readonly group: Element | null;
  /** What the group had, in order. */
  readonly items: readonly HTMLElement[];
  readonly around: readonly Element[];
}

/** Where a control with the focus goes away, the next of its group gets it, or what it was in. */
function keepFocus(main: HTMLElement): void {
  let held: LostFocus | null = null;
  const lost = new MutationObserver(() => {
    if (!held || held.control.isConnected) return;
    const { control, group, items, around } = held;
    held = null;
    if (document.activeElement !== document.body) return;
    // Others may have come or gone in the same group: its place is told by those beside it.
    const left = group?.isConnected ? itemsIn(group) : [];
    const index = items.indexOf(control as never);
    const after = items.slice(index + 1).find((item) => left.includes(item));
    const next = after ?? items.slice(0, index).findLast((item) => left.includes(item)) ?? left[0];
    if (next) next.focus({ preventScroll: true });
    else focusOn(around.find((element) => element.isConnected && main.contains(element)) ?? main);
  });
  document.body.addEventListener('focusin', ({ target: control }) => {
    if (!(control instanceof Element)) return;
    const group = control.parentElement?.closest(GROUP) ?? null;
    if (group && !control.matches(SLIDER)) lastUsed.set(group, control);
    const around: Element[] = [];
    for (let at = control.parentElement; at; at = at.parentElement) around.push(at);
    held = { control, group, around, items: group ? itemsIn(group) : [] };
    lost.observe(document.body, { childList: true, subtree: true });
  });
  document.body.addEventListener('focusout', ({ target: control }) => {
    // Browsers differ in whether what goes away is told so; by then it has gone.
    queueMicrotask(() => {
      if (held?.control !== control || !held.control.isConnected) return;
      held = null;
      lost.disconnect();
    });
  });
}

/** The focus on something that Tab does not stop at. */
function focusOn(element: Element): void {
  if (!(element instanceof HTMLElement)) return;
  element.tabIndex = -1;
  element.focus({ preventScroll: true });
  element.addEventListener('blur', () => element.removeAttribute('tabindex'), { once: true });
}

/** The first stop of the page, seen only while it has the focus. */
function skipTo(main: HTMLElement): void {
  const skip = document.createElement('button');
  skip.type = 'button';
  skip.className = 'skip';
  skip.textContent = 'Skip to the content';
  skip.addEventListener('click', () => {
    focusOn(main);
    main.scrollIntoView();
  });
  main.parentElement?.prepend(skip);
}

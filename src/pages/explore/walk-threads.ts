import { nothing, render, svg } from 'lit';
import { zoomOf } from '../../ui/zoom.ts';

/*
 * Threads are drawn lines from each term of the expanded line to its row in the column of its power
 * of t, and from each square to the terms that it was expanded to. They cross no text, which needs
 * lines of one row at both ends.
 */

/** The numbers of the products that are in a term. */
export const termsOf = (element: Element): string[] =>
  (element.getAttribute('data-terms') ?? '').split(' ').filter(Boolean);

/** Of a rectangle, in CSS pixels from the upper left corner of the steps. */
interface Box {
  readonly left: number;
  readonly right: number;
  readonly top: number;
  readonly bottom: number;
}

interface TermBox {
  readonly terms: readonly string[];
  readonly box: Box;
}

interface Thread {
  readonly terms: readonly string[];
  readonly path: string;
}

/** Lengths in pixels: between lanes, of a curve's handles, of a corner. */
const [LANE, HANDLE, CORNER] = [7, 46, 5];
/** Room for lanes left of a column, and between a term and what is drawn under or over it. */
const [GUTTER, CLEAR] = [20, 2];

/** Least scale of a line that is made smaller to fit into one row. */
const LEAST = 0.7;

/** Makes lines that would break just so much smaller that they do not. */
export function fitLines(host: Element): void {
  const isOn = isWide(host);
  for (const line of host.querySelectorAll<HTMLElement>('.walk-fits > .walk-symbols')) {
    const key = `${isOn} ${line.clientWidth} ${line.closest('.present') ? 'present' : ''}`;
    if (line.dataset.fitted === key) continue;
    line.classList.add('one-row');
    let fit = 1;
    // Twice, as the space between terms keeps its width.
    for (let i = 0; i < 3; i++) {
      line.style.setProperty('--fit', String(fit));
      if (line.scrollWidth <= line.clientWidth) break;
      fit *= (line.clientWidth - CLEAR) / line.scrollWidth;
    }
    const fits = isOn && fit >= LEAST;
    line.classList.toggle('one-row', fits);
    if (!fits) line.style.removeProperty('--fit');
    line.dataset.fitted = key;
  }
}

/** Whether columns stand beside each other; the style sheet hides the threads where they do not. */
function isWide(host: Element): boolean {
  const board = host.querySelector('.walk-threads');
  return board !== null && getComputedStyle(board).display !== 'none';
}

/** Draws the threads to the present step from the one before it. */
export function drawThreads(host: Element): void {
  const board = host.querySelector<SVGSVGElement>('.walk-threads');
  if (!board) return;
  const steps = [...host.querySelectorAll('[data-derivation-step]')];
  const present = steps.at(-1);
  const columns = [...(present?.querySelectorAll('.walk-column') ?? [])];
  const [put, expanded] = columns.length > 0 ? steps.slice(-3) : steps.slice(-2);
  const all =
    put && expanded && isWide(host)
      ? [
          ...squaresTo(placed(board, put), placed(board, expanded)),
          ...columns.flatMap((column) => rowsOf(board, column, placed(board, expanded))),
        ]
      : [];
  render(
    all.length > 0
      ? all.map(
          ({ terms, path }) => svg`<g class="walk-thread" data-terms=${terms.join(' ')}>
            <path class="walk-thread-hit" d=${path}></path><path d=${path}></path></g>`,
        )
      : nothing,
    board,
  );
}

/** The path that leads to a term of the present step, if one is drawn. */
export function threadTo(host: Element, terms: readonly string[]): SVGGeometryElement | null {
  return host.querySelector(`.walk-thread[data-terms="${terms.join(' ')}"] > path`);
}

function boxIn(board: Element, element: Element): Box {
  const { left, top, right, bottom } = element.getBoundingClientRect();
  const from = board.getBoundingClientRect();
  const zoom = zoomOf(board);
  return {
    left: (left - from.left) / zoom,
    right: (right - from.left) / zoom,
    top: (top - from.top) / zoom,
    bottom: (bottom - from.top) / zoom,
  };
}

function placed(board: Element, step: Element): readonly TermBox[] {
  return [...step.querySelectorAll('.term[data-terms]')].map((term) => ({
    terms: termsOf(term),
    box: boxIn(board, term.querySelector('math') ?? term),
  }));
}

const middle = ({ left, right }: Box): number => (left + right) / 2;

/** The boxes with no other box of their line below them; `highest`: above them. */
const lowest = (all: readonly TermBox[]): readonly TermBox[] =>
  all.filter(({ box }) => all.every((other) => other.box.top < box.bottom));
const highest = (all: readonly TermBox[]): readonly TermBox[] =>
  all.filter(({ box }) => all.every((other) => other.box.bottom > box.top));

/** A bracket over the terms that a square was expanded to, and a stem to it from the square. */
function squaresTo(squares: readonly TermBox[], terms: readonly TermBox[]): readonly Thread[] {
  const free = highest(terms);
  // All brackets are at one height, clear of the highest term.
  const y = Math.min(...free.map(({ box }) => box.top)) - CLEAR - CORNER;
  return lowest(squares).flatMap((square) => {
    const own = terms.filter((term) => term.terms.every((one) => square.terms.includes(one)));
    if (own.length < 2 || own.some((term) => !free.includes(term))) return [];
    const [left, right] = [
      Math.min(...own.map(({ box }) => box.left)) + CLEAR,
      Math.max(...own.map(({ box }) => box.right)) - CLEAR,
    ];
    const [x, foot] = [middle(square.box), square.box.bottom + CLEAR];
    const [top, half] = [(left + right) / 2, (y - foot) * 0.8];
    if (half <= 0) return [];
    const path =
      `M${at(x)} ${at(foot)}C${at(x)} ${at(foot + half)} ${at(top)} ${at(y - half)} ` +
      `${at(top)} ${at(y)}M${at(left)} ${at(y + CORNER)}V${at(y + 3)}q0 -3 3 -3` +
      `H${at(right - 3)}q3 0 3 3V${at(y + CORNER)}`;
    return [{ terms: square.terms, path }];
  });
}

/** From the terms of the expanded line into the rows of a column, each by a lane of its own. */
function rowsOf(board: Element, column: Element, terms: readonly TermBox[]): readonly Thread[] {
  const rows = [...column.querySelectorAll('.walk-row')];
  const { left, top } = boxIn(board, column);
  const free = lowest(terms);
  const pitch = Math.min(LANE, (GUTTER - CLEAR) / Math.max(rows.length - 1, 1));
  return rows.flatMap((row, i) => {
    const to = placed(board, row)[0];
    const from = to && free.find((term) => term.terms.join() === to.terms.join());
    const sign = row.querySelector('.walk-plus');
    if (!to || !from || !sign) return [];
    const [x, y] = [middle(from.box), from.box.bottom + CLEAR];
    // The first row's lane is next to the column, so that no lane crosses the way into a row.
    const lane = left + GUTTER - i * pitch;
    const across = (to.box.top + to.box.bottom) / 2;
    const end = sign.textContent?.trim() ? boxIn(board, sign).left : to.box.left;
    const path =
      `M${at(x)} ${at(y)}C${at(x)} ${at(y + HANDLE)} ${at(lane)} ${at(top - HANDLE)} ` +
      `${at(lane)} ${at(top)}V${at(across - CORNER)}q0 ${CORNER} ${CORNER} ${CORNER}` +
      `H${at(Math.max(end - CLEAR, lane + CORNER))}`;
    return [{ terms: to.terms, path }];
  });
}

const at = (x: number): string => x.toFixed(1);

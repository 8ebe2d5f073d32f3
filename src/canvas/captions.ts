import { coordinate } from '../text/coordinate.ts';
import type { Caption, Figures } from './figures.ts';
import { type Box, type Obstacles, placeLabels } from './labels.ts';
import type { Layer } from './layer.ts';
import type { Theme } from './theme.ts';

/** What of the theme words need. */
type Sizes = Pick<Theme, 'scale' | 'label'>;

const SVG = 'http://www.w3.org/2000/svg';

// STIX italics: a capital is about 0.68 em wide and 0.66 em high, t and d are narrower; a subscript
// adds 0.36 em.
const WIDE = 0.68;
const NARROW = 0.5;
const SUB = 0.36;
const HIGH = 0.82;
/** Width of a letter of a word, which is set in small type. */
const WORD = 0.29;

type Symbolic = Pick<Caption, 'letter' | 'sub'>;

function captionSize({ letter, sub }: Symbolic, font: number): { w: number; h: number } {
  if (letter.length > 1) return { w: WORD * font * letter.length, h: 0.6 * font };
  const wide = letter === letter.toUpperCase() ? WIDE : NARROW;
  return { w: font * (wide + (sub ? SUB : 0)), h: font * (HIGH + (sub ? 0.12 : 0)) };
}

/** Boxes for the symbols beside their marks, at this type size. */
export function captionBoxes(
  captions: readonly Caption[],
  obstacles: Obstacles,
  places: Map<string, string>,
  label: number,
): Box[] {
  const wishes = captions.map((caption) => ({ ...caption, ...captionSize(caption, label) }));
  return placeLabels(wishes, obstacles, places);
}

export function drawCaptions(
  layer: Layer,
  captions: readonly Caption[],
  boxes: readonly Box[],
  theme: Sizes,
  lit: string | null,
): void {
  captions.forEach((caption, k) => {
    const box = boxes[k];
    if (box) write(layer, caption, box, theme, lit);
  });
}

/** Boxes for pointers ("E →") to points outside of the picture. */
export function pointerBoxes(pointers: Figures['pointers'], label: number): Box[] {
  const boxes: Box[] = [];
  const arm = label * 0.95;
  for (const pointer of pointers) {
    const [dx, dy] = pointer.direction;
    const size = captionSize(pointer, label);
    let box = { x: pointer.x - dx * arm * 0.6, y: pointer.y - dy * arm * 0.6, ...size };
    // Pointers at the same side are put one below the other.
    while (
      boxes.some((other) => Math.abs(other.x - box.x) < box.w && Math.abs(other.y - box.y) < box.h)
    ) {
      box = { ...box, y: box.y + box.h * 1.3 };
    }
    boxes.push(box);
  }
  return boxes;
}

export function drawPointers(
  layer: Layer,
  pointers: Figures['pointers'],
  boxes: readonly Box[],
  theme: Sizes,
  lit: string | null,
): void {
  pointers.forEach((pointer, k) => {
    const box = boxes[k];
    if (!box) return;
    const [dx, dy] = pointer.direction;
    write(layer, pointer, box, theme, lit);
    const [ex, ey] = [Math.abs(dx) * box.w, Math.abs(dy) * box.h];
    const from = (ex + ey) / 2 + 0.15 * theme.label;
    const angle = (Math.atan2(dy, dx) * 180) / Math.PI;
    layer.show(`${pointer.key} arrow`, 'path', {
      class: `scene-pointer scene-tone-${pointer.tone}`,
      d: 'M0 0H14M9 -4.5L14 0L9 4.5',
      transform:
        `translate(${coordinate(box.x + from * dx)} ${coordinate(box.y + from * dy)}) ` +
        `rotate(${angle.toFixed(2)}) scale(${theme.scale})`,
    });
  });
}

function write(
  layer: Layer,
  { key, symbol, letter, sub, tone }: Pick<Caption, 'key' | 'symbol' | 'letter' | 'sub' | 'tone'>,
  box: Box,
  theme: Sizes,
  lit: string | null,
): void {
  const isLit = symbol === lit;
  const element = layer.show(`${key} ${tone} ${letter}`, 'text', {
    class:
      `${letter.length > 1 ? 'scene-label scene-word' : 'scene-label'} ` +
      `scene-tone-${tone}${isLit ? ' lit' : ''}`,
    'data-symbol': symbol,
    x: box.x,
    y: box.y + theme.label * (sub ? 0.2 : 0.27),
  });
  if (element.firstChild) return;
  element.append(letter.length > 1 ? letter : italic(letter));
  if (!sub) return;
  const subscript = document.createElementNS(SVG, 'tspan');
  subscript.setAttribute('class', 'scene-sub');
  subscript.setAttribute('dy', '0.24em');
  subscript.textContent = sub;
  element.append(subscript);
}

/**
 * The mathematical italic of a Latin letter: the font has no italic face, but these code points.
 */
export function italic(letter: string): string {
  if (letter === 'h') return '\u210e';
  const code = letter.codePointAt(0) ?? 0;
  if (code >= 65 && code <= 90) return String.fromCodePoint(0x1d434 + code - 65);
  if (code >= 97 && code <= 122) return String.fromCodePoint(0x1d44e + code - 97);
  return letter;
}

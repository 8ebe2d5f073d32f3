import { svgText } from '../ui/svg-text.ts';

/** Pixels of the picture for one of the page's: sharp in print and on every screen. */
export const PNG_SCALE = 2;

/**
 * The scene as a PNG: `painted` (canvas or SVG of lines), the overlay over it, on the scene's
 * colour.
 */
export async function scenePng(
  root: HTMLElement,
  painted: HTMLCanvasElement | SVGSVGElement,
  overlay: SVGSVGElement,
): Promise<Blob | null> {
  const { clientWidth: width, clientHeight: height } = root;
  const paper = document.createElement('canvas');
  [paper.width, paper.height] = [width * PNG_SCALE, height * PNG_SCALE];
  const context = paper.getContext('2d');
  if (!context || width === 0 || height === 0) return null;
  context.fillStyle = getComputedStyle(root).backgroundColor;
  context.fillRect(0, 0, paper.width, paper.height);
  context.scale(PNG_SCALE, PNG_SCALE);
  // WebGL forgets what it has drawn when this task ends: nothing is awaited before.
  if (painted instanceof HTMLCanvasElement) context.drawImage(painted, 0, 0, width, height);
  const marks = wordless(overlay);
  const words = wordsOf(overlay);
  const layers = painted instanceof SVGSVGElement ? [svgText(painted, 'none'), marks] : [marks];
  for (const layer of layers) context.drawImage(await imageOf(layer), 0, 0, width, height);
  for (const word of words) write(context, word);
  return new Promise((resolve) => paper.toBlob(resolve, 'image/png'));
}

/**
 * An SVG in an <img> does not see the page's fonts, so its words are left out and written by the
 * canvas, which does.
 */
function wordless(overlay: SVGSVGElement): string {
  overlay.classList.add('scene-wordless');
  try {
    return svgText(overlay, 'none');
  } finally {
    overlay.classList.remove('scene-wordless');
  }
}

interface Word {
  readonly text: string;
  readonly x: number;
  readonly y: number;
  readonly font: string;
  readonly fill: string;
  readonly halo: string;
  readonly haloWidth: number;
}

/** Every piece of text where the page has placed it; a subscript is a piece of its own. */
function wordsOf(overlay: SVGSVGElement): Word[] {
  const words: Word[] = [];
  for (const element of overlay.querySelectorAll('text')) {
    const style = getComputedStyle(element);
    if (style.visibility === 'hidden' || !element.getClientRects().length) continue;
    let index = 0;
    for (const node of element.childNodes) {
      const text = node.textContent ?? '';
      if (text === '') continue;
      const { x, y } = element.getStartPositionOfChar(index);
      index += text.length;
      const own = node instanceof Element ? getComputedStyle(node) : style;
      // Not the shorthand: it is empty where it cannot tell everything (tabular figures).
      const font = `${own.fontWeight} ${own.fontSize} ${own.fontFamily}`;
      const haloWidth = Number.parseFloat(style.strokeWidth);
      words.push({ text, x, y, font, fill: style.fill, halo: style.stroke, haloWidth });
    }
  }
  return words;
}

function write(context: CanvasRenderingContext2D, word: Word): void {
  context.font = word.font;
  context.textAlign = 'left';
  context.textBaseline = 'alphabetic';
  context.lineJoin = 'round';
  if (word.halo !== 'none') {
    context.strokeStyle = word.halo;
    context.lineWidth = word.haloWidth;
    context.strokeText(word.text, word.x, word.y);
  }
  context.fillStyle = word.fill;
  context.fillText(word.text, word.x, word.y);
}

async function imageOf(svg: string): Promise<HTMLImageElement> {
  const url = URL.createObjectURL(new Blob([svg], { type: 'image/svg+xml' }));
  const image = new Image();
  image.src = url;
  try {
    await image.decode();
  } finally {
    URL.revokeObjectURL(url);
  }
  return image;
}

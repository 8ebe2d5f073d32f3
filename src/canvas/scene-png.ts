import { svgText } from '../ui/svg-text.ts';

/** px of the PNG per CSS px, for print. */
export const PNG_SCALE = 2;

/** The scene as a PNG: background, `painted` (canvas or SVG of lines), and the overlay. */
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
  // The canvas is cleared at the end of this task, so nothing may be awaited before.
  if (painted instanceof HTMLCanvasElement) context.drawImage(painted, 0, 0, width, height);
  const marks = wordless(overlay);
  const words = wordsOf(overlay);
  const layers = painted instanceof SVGSVGElement ? [svgText(painted, 'none'), marks] : [marks];
  for (const layer of layers) context.drawImage(await imageOf(layer), 0, 0, width, height);
  for (const word of words) write(context, word);
  return new Promise((resolve) => paper.toBlob(resolve, 'image/png'));
}

/** The SVG without words: in an <img> it has no access to the page's fonts; a canvas has. */
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

/** Every piece of text with its place; a subscript is a piece of its own. */
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
      // Not `font`, which is empty if it cannot express everything (tabular figures).
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

import type { Picture } from '../../tracer/compare.ts';

/** Pixels to the left and right, and above and below, of the chosen one. */
const ACROSS = 17;
const DOWN = 4;

interface MagnifierModel {
  readonly pixel: readonly [number, number];
  readonly left: Picture | null;
  readonly right: Picture | null;
  readonly comparing: boolean;
}

interface PixelMagnifier {
  /** Null hides the magnifier. */
  render(model: MagnifierModel | null): void;
}

/** The chosen pixel among its neighbours, large, from each picture, with its colour in figures. */
export function createPixelMagnifier(host: HTMLElement): PixelMagnifier {
  const sides = [magnifiedSide(host), magnifiedSide(host)] as const;
  return {
    render(model) {
      host.hidden = model === null;
      if (!model) return;
      const [left, right] = sides;
      left.root.hidden = !model.comparing;
      show(left, model.left, model.pixel);
      show(right, model.right, model.pixel);
    },
  };
}

interface MagnifiedSide {
  readonly root: HTMLElement;
  readonly canvas: HTMLCanvasElement;
  readonly colour: HTMLElement;
}

function magnifiedSide(host: HTMLElement): MagnifiedSide {
  const root = document.createElement('figure');
  root.className = 'magnifier';
  const canvas = document.createElement('canvas');
  canvas.width = 2 * ACROSS + 1;
  canvas.height = 2 * DOWN + 1;
  canvas.setAttribute('aria-hidden', 'true');
  const frame = document.createElement('span');
  frame.className = 'magnifier-frame';
  const colour = document.createElement('figcaption');
  root.append(canvas, frame, colour);
  host.append(root);
  return { root, canvas, colour };
}

function show(
  { canvas, colour }: MagnifiedSide,
  picture: Picture | null,
  [x, y]: MagnifierModel['pixel'],
): void {
  const context = canvas.getContext('2d');
  if (!context) return;
  context.clearRect(0, 0, canvas.width, canvas.height);
  colour.textContent = '';
  if (!picture) return;
  const data = context.createImageData(canvas.width, canvas.height);
  for (let j = 0; j < data.height; j++) {
    for (let i = 0; i < data.width; i++) {
      const [px, py] = [x - ACROSS + i, y - DOWN + j];
      if (px < 0 || py < 0 || px >= picture.width || py >= picture.height) continue;
      const from = 4 * (py * picture.width + px);
      data.data.set(picture.rgba.subarray(from, from + 4), 4 * (j * data.width + i));
    }
  }
  context.putImageData(data, 0, 0);
  const at = 4 * (y * picture.width + x);
  const figures = [...picture.rgba.subarray(at, at + 3)];
  colour.textContent = `#${figures.map((n) => n.toString(16).padStart(2, '0')).join('')}`;
}

import type { Picture } from '../../tracer/compare.ts';
import { watchDrags } from '../../ui/drags.ts';
import { listenToCamera } from './camera-gestures.ts';

export interface CompareViewModel {
  readonly width: number;
  readonly height: number;
  /** The picture as far as it is traced; null keeps the one before on the screen. */
  readonly right: Picture | null;
  readonly left: Picture | null;
  readonly comparing: boolean;
  /** Percent of the width that the left picture takes. */
  readonly split: number;
  readonly pixel: readonly [number, number] | null;
  /** Changes when pixels of the same pictures have changed. */
  readonly version: string;
}

interface CompareViewActions {
  /** Moves the divider: `edit` maps its position in percent to the new one. */
  split(edit: (percent: number) => number): void;
  pixel(x: number, y: number): void;
  /** The pixel cursor was moved here; the pixel is not chosen yet. */
  cursor(x: number, y: number): void;
  /** The pointer or the cursor is at this pixel, or at none. */
  point(pixel: readonly [number, number] | null): void;
  /**
   * A press on the picture, in pixels and parts of them: true if something was taken hold of, which
   * `drag` then moves.
   */
  grab(x: number, y: number): boolean;
  drag(x: number, y: number): void;
  /** A cancelled drag, or one that Escape ends, moves nothing. */
  drop(isCancelled: boolean): void;
  /** A gesture moves the camera: see camera-gestures.ts. */
  readonly camera: Omit<Parameters<typeof listenToCamera>[1], 'free'>;
}

interface CompareView {
  /** The element for overlays, above the pictures. */
  readonly over: HTMLElement;
  render(model: CompareViewModel): void;
}

/** Percent that an arrow key moves the divider; with Shift a tenth of it. */
const STEP = 5;
const FAR_STEP = 10;

/**
 * One picture, or two under each other of which a divider shows one part each; a square marks a
 * pixel.
 */
export function createCompareView(host: HTMLElement, actions: CompareViewActions): CompareView {
  host.className = 'compare-view';
  const frame = element('div', 'picture-frame', host);
  frame.tabIndex = 0;
  frame.setAttribute('role', 'application');
  frame.setAttribute('aria-label', 'Picture');
  const right = canvas('traced', frame);
  const left = canvas('traced traced-left', frame);
  const mark = element('div', 'pixel-mark', frame);
  const over = element('div', 'compare-view-over', host);
  const divider = element('div', 'split', host);
  divider.tabIndex = 0;
  divider.setAttribute('role', 'slider');
  divider.setAttribute('aria-label', 'divider between left and right picture');
  divider.setAttribute('aria-valuemin', '0');
  divider.setAttribute('aria-valuemax', '100');
  // Until the first picture is asked for.
  divider.setAttribute('aria-valuenow', '50');
  element('span', 'split-grip', divider).setAttribute('aria-hidden', 'true');
  let model: CompareViewModel | null = null;
  let cursor: readonly [number, number] | null = null;

  const place = (): void => {
    if (!model) return;
    const at = cursor ?? model.pixel;
    mark.hidden = at === null;
    if (at) {
      mark.style.left = `${(100 * (at[0] + 0.5)) / model.width}%`;
      mark.style.top = `${(100 * (at[1] + 0.5)) / model.height}%`;
    }
  };

  const placeAt = ({
    clientX,
    clientY,
  }: Pick<MouseEvent, 'clientX' | 'clientY'>): readonly [number, number] => {
    const box = frame.getBoundingClientRect();
    const { width, height } = model ?? { width: 1, height: 1 };
    const x = ((clientX - box.left) / box.width) * width;
    return [x, ((clientY - box.top) / box.height) * height];
  };

  let holds = false;
  watchDrags(frame, {
    everyWay: true,
    takes(event) {
      holds = event.button === 0 && event.isPrimary && actions.grab(...placeAt(event));
      return holds;
    },
    move: ({ x, y }) => actions.drag(...placeAt({ clientX: x, clientY: y })),
    end: actions.drop,
  });
  const wasDragged = listenToCamera(frame, {
    ...actions.camera,
    free: () => !holds,
  });
  frame.addEventListener('pointermove', (event) => {
    const [x, y] = placeAt(event);
    if (model) actions.point(inside(Math.floor(x), Math.floor(y), model));
  });
  frame.addEventListener('pointerleave', () => actions.point(null));
  frame.addEventListener('click', (event) => {
    cursor = null;
    if (!model || holds || wasDragged()) return;
    const [x, y] = placeAt(event);
    actions.pixel(...inside(Math.floor(x), Math.floor(y), model));
  });
  frame.addEventListener('keydown', (event) => {
    if (!model || event.altKey || event.metaKey) return;
    if (event.key === 'Escape' && holds) {
      event.preventDefault();
      actions.drop(true);
      return;
    }
    const here = cursor ?? model.pixel ?? [model.width >> 1, model.height >> 1];
    if (event.key === 'Enter' || event.key === ' ') {
      event.preventDefault();
      cursor = null;
      actions.pixel(...here);
      return;
    }
    const move = MOVES[event.key];
    if (!move) return;
    event.preventDefault();
    const far = event.ctrlKey || event.key.startsWith('Page') ? FAR_STEP : 1;
    cursor = inside(here[0] + far * move[0], here[1] + far * move[1], model);
    place();
    actions.point(cursor);
    actions.cursor(...cursor);
  });
  frame.addEventListener('blur', () => {
    cursor = null;
    actions.point(null);
    place();
  });

  const toPercent = (clientX: number): number => {
    const box = frame.getBoundingClientRect();
    return between((100 * (clientX - box.left)) / box.width);
  };
  divider.addEventListener('pointerdown', (event) => {
    if (event.button !== 0) return;
    divider.setPointerCapture(event.pointerId);
    event.preventDefault();
    divider.focus({ preventScroll: true });
  });
  divider.addEventListener('pointermove', (event) => {
    if (divider.hasPointerCapture(event.pointerId)) actions.split(() => toPercent(event.clientX));
  });
  divider.addEventListener('keydown', (event) => {
    if (!model || event.ctrlKey || event.altKey || event.metaKey) return;
    const step = event.shiftKey ? STEP / 10 : STEP;
    const edits: Readonly<Record<string, (percent: number) => number>> = {
      ArrowLeft: (now) => now - step,
      ArrowDown: (now) => now - step,
      ArrowRight: (now) => now + step,
      ArrowUp: (now) => now + step,
      Home: () => 0,
      End: () => 100,
    };
    const edit = edits[event.key];
    if (!edit) return;
    event.preventDefault();
    actions.split((now) => between(edit(now)));
  });

  return {
    over,
    render(next) {
      const before = model;
      const same = before?.width === next.width && before.height === next.height;
      if (!same) cursor = null;
      model = next;
      const { width, height, comparing, split } = next;
      host.style.setProperty('--ratio', `${width} / ${height}`);
      host.style.setProperty('--split', `${split}%`);
      frame.setAttribute(
        'aria-label',
        `Picture, ${width} by ${height} pixels. Arrow keys move a pixel cursor, with Control by ` +
          `ten; Enter follows the rays of that pixel. With Shift they turn the camera, with ` +
          `Shift and Control they shift it; plus and minus come nearer and go back.`,
      );
      host.classList.toggle('coarse', frame.clientWidth > 1.6 * width);
      divider.hidden = !comparing;
      left.hidden = !comparing;
      divider.setAttribute('aria-valuenow', String(split));
      divider.setAttribute('aria-valuetext', `${split} % left picture`);
      const changed = next.version !== before?.version;
      if (changed || next.right !== before.right) paint(right, next.right);
      if (changed || next.left !== before.left) paint(left, next.left);
      place();
    },
  };
}

const MOVES: Readonly<Record<string, readonly [number, number]>> = {
  ArrowLeft: [-1, 0],
  ArrowRight: [1, 0],
  ArrowUp: [0, -1],
  ArrowDown: [0, 1],
  PageUp: [0, -1],
  PageDown: [0, 1],
};

function inside(
  x: number,
  y: number,
  { width, height }: CompareViewModel,
): readonly [number, number] {
  return [Math.min(Math.max(x, 0), width - 1), Math.min(Math.max(y, 0), height - 1)];
}

/** A tenth of a percent is less than a pixel, and short to read in a link. */
const between = (percent: number): number =>
  Math.round(Math.min(Math.max(percent, 0), 100) * 10) / 10;

function paint(target: HTMLCanvasElement, picture: Picture | null): void {
  if (!picture) return;
  const { width, height } = picture;
  put(target, new ImageData(new Uint8ClampedArray(picture.rgba), width, height));
}

function put(target: HTMLCanvasElement, data: ImageData): void {
  if (target.width !== data.width || target.height !== data.height) {
    target.width = data.width;
    target.height = data.height;
  }
  target.getContext('2d')?.putImageData(data, 0, 0);
}

function canvas(className: string, parent: Element): HTMLCanvasElement {
  const made = document.createElement('canvas');
  made.className = className;
  made.setAttribute('aria-hidden', 'true');
  parent.append(made);
  return made;
}

function element(tag: string, className: string, parent: Element): HTMLElement {
  const made = document.createElement(tag);
  made.className = className;
  parent.append(made);
  return made;
}

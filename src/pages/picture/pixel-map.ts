import { render } from 'lit';
import {
  type MapShow,
  type MapWords,
  mapHead,
  mapScale,
  NOT_TRACED,
} from '../../panels/picture-map.ts';
import { type Heat, heatOf } from '../../state/picture/heat.ts';
import type { Comparison } from '../../tracer/compare.ts';
import type { Frame } from '../../workers/trace-job.ts';
import { errorImage, heatImage, shaded } from './map-image.ts';
import { themeColours } from './theme-colours.ts';

interface PixelMapModel {
  /** The finished picture; null while it is traced, when the map before stays. */
  readonly frame: Frame | null;
  /** Width and height of the picture in pixels, by which the place of the first map is kept. */
  readonly size: readonly [number, number];
  readonly comparing: boolean;
  readonly comparison: Comparison | null;
  readonly show: MapShow;
  /** The pixel that is pointed at, else the chosen one. */
  readonly pixel: readonly [number, number] | null;
  /** Changes when the theme does. */
  readonly theme: string;
}

interface PixelMapActions {
  show(what: MapShow): void;
  /** The pointer is over this pixel, or over none. */
  point(pixel: readonly [number, number] | null): void;
  choose(x: number, y: number): void;
}

interface PixelMap {
  render(model: PixelMapModel): void;
  /** What is known of a pixel, in words. */
  words(x: number, y: number): string;
}

/** Beside the picture: what each pixel cost, or how two pictures differ, with its scale. */
export function createPixelMap(host: HTMLElement, actions: PixelMapActions): PixelMap {
  const part = (className: string, parent: Element = host): HTMLElement => {
    const made = document.createElement('div');
    made.className = className;
    parent.append(made);
    return made;
  };
  const head = part('map-head');
  const frame = part('map-frame');
  const canvas = document.createElement('canvas');
  canvas.className = 'map-image';
  canvas.setAttribute('role', 'img');
  canvas.setAttribute('aria-label', NOT_TRACED);
  frame.append(canvas);
  const mark = part('pixel-mark', frame);
  const foot = part('map-foot');
  let size: readonly [number, number] = [1, 1];
  let drawn = '';
  let shown: MapWords | null = null;
  const heats = new WeakMap<Uint32Array, Heat>();

  const pixelAt = ({ clientX, clientY }: MouseEvent): readonly [number, number] => {
    const box = frame.getBoundingClientRect();
    const at = (x: number, from: number, length: number, n: number): number =>
      Math.min(Math.max(Math.floor(((x - from) / length) * n), 0), n - 1);
    const [width, height] = size;
    return [at(clientX, box.left, box.width, width), at(clientY, box.top, box.height, height)];
  };
  frame.addEventListener('pointermove', (event) => actions.point(pixelAt(event)));
  frame.addEventListener('pointerleave', () => actions.point(null));
  frame.addEventListener('click', (event) => actions.choose(...pixelAt(event)));

  const heat = (values: Uint32Array): Heat => {
    const found = heats.get(values) ?? heatOf(values);
    heats.set(values, found);
    return found;
  };

  const wordsOf = ({ frame, comparison, show }: PixelMapModel): MapWords | null => {
    if (show === 'errors') return comparison && { show, comparison };
    return frame && { show, values: frame.work[show], heat: heat(frame.work[show]) };
  };

  return {
    render(model) {
      const { frame: traced, pixel, comparing, theme } = model;
      const show = model.show === 'errors' && !comparing ? 'questions' : model.show;
      if (!shown) size = model.size;
      const words = wordsOf({ ...model, show });
      if (traced && words) {
        size = [traced.width, traced.height];
        const key = [...size, show, theme].join();
        const source = words.show === 'errors' ? words.comparison : words.values;
        if (drawn !== key || sourceOf.get(canvas) !== source) {
          drawn = key;
          sourceOf.set(canvas, source);
          shown = words;
          const shade =
            words.show === 'errors'
              ? errorImage(words.comparison)
              : heatImage(words.heat, words.values);
          const image = shaded(...size, themeColours(host), shade);
          canvas.width = image.width;
          canvas.height = image.height;
          canvas.getContext('2d')?.putImageData(image, 0, 0);
        }
      }
      host.style.setProperty('--ratio', `${size[0]} / ${size[1]}`);
      frame.classList.toggle('coarse', frame.clientWidth > 1.6 * size[0]);
      const at = pixel && pixel[0] < size[0] && pixel[1] < size[1] ? pixel : null;
      mark.hidden = at === null;
      if (at) {
        mark.style.left = `${(100 * (at[0] + 0.5)) / size[0]}%`;
        mark.style.top = `${(100 * (at[1] + 0.5)) / size[1]}%`;
      }
      render(mapHead(show, comparing, actions.show), head);
      render(mapScale(shown?.show === show ? shown : null, at, size[0]), foot);
      canvas.setAttribute('aria-label', shown?.show === show ? foot.innerText : NOT_TRACED);
    },
    words(x, y) {
      const at = y * size[0] + x;
      if (!shown || shown.show === 'errors') return '';
      return `${shown.values[at] ?? 0} ${shown.show}`;
    },
  };
}

/** What a canvas was drawn from. */
const sourceOf = new WeakMap<HTMLCanvasElement, object>();

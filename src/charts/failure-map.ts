import { html, nothing, render, svg, type TemplateResult } from 'lit';
import type { Border } from '../lab/atlas/borders.ts';
import type { MapFrame } from '../lab/atlas/frame.ts';
import { SIDE } from '../lab/atlas/window.ts';
import type { Mounted } from '../ui/mounted.ts';
import { sizeOf, zoomOf } from '../ui/zoom.ts';
import { type Cell, type Corners, type Gestures, watchMap } from './map-gestures.ts';
import { paintMap, type Rgb } from './map-ink.ts';
import { px } from './plot.ts';
import './failure-map.css';

interface FailureMapModel {
  /** Whose map it is, and of what: the name of the element for screen readers. */
  readonly label: string;
  /** What is seen, in words. */
  readonly description: string;
  readonly frame: MapFrame | null;
  readonly borders: readonly Border[];
  /** The pixel that is pointed at. */
  readonly cursor: Cell | null;
  readonly picked: Cell | null;
  /** The pixel of the present ray; null outside of the window. */
  readonly here: Cell | null;
  readonly corners: Corners | null;
  readonly busy: boolean;
}

let maps = 0;

/** A map of marks on a canvas, with what is pointed at above it. */
export function mountFailureMap(host: HTMLElement, gestures: Gestures): Mounted<FailureMapModel> {
  const id = `map-${++maps}`;
  let model: FailureMapModel | null = null;
  let drawn = '';
  host.classList.add('failure-map');
  render(
    html`<div class="map-field" role="application" tabindex="0" aria-describedby=${id}>
        <canvas aria-hidden="true"></canvas>
        <svg class="map-over" viewBox=${`0 0 ${SIDE} ${SIDE}`} aria-hidden="true"></svg>
      </div>
      <p class="visually-hidden" id=${id}></p>`,
    host,
  );
  const field = host.querySelector('.map-field') as HTMLElement;
  const canvas = host.querySelector('canvas') as HTMLCanvasElement;
  const over = host.querySelector('svg') as SVGSVGElement;
  const words = host.querySelector('p') as HTMLElement;
  const unwatch = watchMap(field, gestures);
  const observer = new ResizeObserver(() => draw());
  observer.observe(field);
  const onPaper = (): void => draw({ paper: [255, 255, 255], ink: [0, 0, 0] });
  const onScreen = (): void => draw();
  window.addEventListener('beforeprint', onPaper);
  window.addEventListener('afterprint', onScreen);

  function draw(colours = coloursOf(host)): void {
    if (!model) return;
    const { width } = sizeOf(field);
    const density = (window.devicePixelRatio || 1) * zoomOf(field);
    const side = Math.round(width * density);
    if (side === 0) return;
    const { frame, borders } = model;
    const key = JSON.stringify([side, colours, frame?.done, borders.map((one) => one.title)]);
    if (key === drawn && lastFrame === frame) return;
    drawn = key;
    lastFrame = frame;
    if (canvas.width !== side) {
      canvas.width = side;
      canvas.height = side;
    }
    const context = canvas.getContext('2d');
    if (!context) return;
    if (!frame) context.clearRect(0, 0, side, side);
    else {
      const rgba = paintMap(frame, borders, side, { ...colours, density });
      context.putImageData(new ImageData(rgba, side, side), 0, 0);
    }
  }
  let lastFrame: MapFrame | null = null;

  return {
    render(next) {
      model = next;
      field.setAttribute('aria-label', next.label);
      field.ariaBusy = String(next.busy);
      if (words.textContent !== next.description) words.textContent = next.description;
      draw();
      render(overlay(next), over);
    },
    dispose() {
      unwatch();
      observer.disconnect();
      window.removeEventListener('beforeprint', onPaper);
      window.removeEventListener('afterprint', onScreen);
      host.classList.remove('failure-map');
      render(nothing, host);
    },
  };
}

/** The map as it is drawn, in the colours of paper, `side` pixels wide. */
export function mapPicture(frame: MapFrame, borders: readonly Border[], side: number): ImageData {
  const look = { paper: [255, 255, 255], ink: [0, 0, 0], density: side / 512 } as const;
  return new ImageData(paintMap(frame, borders, side, look), side, side);
}

function coloursOf(place: Element): { paper: Rgb; ink: Rgb } {
  const style = getComputedStyle(place);
  return { paper: hex(style.getPropertyValue('--bg')), ink: hex(style.getPropertyValue('--ink')) };
}

/** #1d1c1a, or #fff, as a minified style sheet has it. */
function hex(text: string): Rgb {
  const digits = text.trim().slice(1);
  const all = digits.length === 3 ? [...digits].map((one) => one + one).join('') : digits;
  const value = Number.parseInt(all, 16);
  return [(value >> 16) & 255, (value >> 8) & 255, value & 255];
}

/** In units of pixels of the map, y downwards. */
const middle = ([column, row]: Cell): readonly [number, number] => [column + 0.5, SIDE - row - 0.5];

function overlay({ cursor, picked, here, corners, borders }: FailureMapModel): TemplateResult {
  return svg`
    ${corners ? rectangle(corners) : nothing}
    ${here ? cross(middle(here)) : nothing}
    ${borders.map((border, i) => borderName(border, i))}
    ${picked ? ring(middle(picked), 'map-picked') : nothing}
    ${cursor ? ring(middle(cursor), 'map-cursor') : nothing}`;
}

const ring = ([x, y]: readonly [number, number], name: string): TemplateResult =>
  svg`<g class=${name}>
    <circle class="map-halo" cx=${x} cy=${y} r="4.5"></circle>
    <circle class="map-ring" cx=${x} cy=${y} r="4.5"></circle>
  </g>`;

function cross([x, y]: readonly [number, number]): TemplateResult {
  const across = `M${x - 6},${y}H${x - 1.5}M${x + 1.5},${y}H${x + 6}`;
  const path = `${across}M${x},${y - 6}V${y - 1.5}M${x},${y + 1.5}V${y + 6}`;
  return svg`<g class="map-here"><path class="map-halo" d=${path}></path>
    <path class="map-ring" d=${path}></path></g>`;
}

function rectangle([a, b]: Corners): TemplateResult {
  const [left, right] = [Math.min(a[0], b[0]), Math.max(a[0], b[0]) + 1];
  const [low, high] = [Math.min(a[1], b[1]), Math.max(a[1], b[1]) + 1];
  const place = { x: left, y: SIDE - high, width: right - left, height: high - low };
  const box = (name: string): TemplateResult =>
    svg`<rect class=${name} x=${place.x} y=${place.y} width=${place.width}
      height=${place.height}></rect>`;
  return svg`<g class="map-corners">${box('map-halo')}${box('map-ring')}</g>`;
}

/** At the border's right end, or its upper one, so that two names seldom meet. */
function borderName(border: Border, place: number): TemplateResult {
  const pixels = [...border.right, ...border.above];
  const at = (pixel: number): Cell => [pixel % SIDE, Math.floor(pixel / SIDE)];
  const far = ([column, row]: Cell): number => (place === 0 ? column : row);
  const end = pixels
    .map(at)
    .reduce((most, cell) => (far(cell) > far(most) ? cell : most), [0, 0] as Cell);
  const [x, y] = middle(end);
  const isRight = x > SIDE / 2;
  const left = isRight ? Math.min(x, SIDE - 2) - 2 : Math.max(x, 2) + 4;
  return svg`<text class="map-border" text-anchor=${isRight ? 'end' : 'start'} x=${px(left)}
    y=${px(Math.max(10, Math.min(SIDE - 4, y - 3)))}>${border.title}</text>`;
}

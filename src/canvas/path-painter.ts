import { Layer, text } from './layer.ts';
import type { Painter, Strokes } from './painter.ts';
import type { Projection } from './projection.ts';
import { at, type Pen, paint, type Run, type Stroke } from './stroke.ts';
import type { Theme } from './theme.ts';

/** Paints the scene's lines as SVG paths, without walls, if there is no WebGL context. */
export class PathPainter implements Painter, Pen {
  readonly #layer: Layer;
  #scale = 1;
  #count = 0;

  constructor(svg: Element) {
    this.#layer = new Layer(svg, 'scene-paths');
  }

  paint(strokes: Strokes, projection: Projection, theme: Pick<Theme, 'scale'>): void {
    this.#scale = theme.scale;
    this.#count = 0;
    this.#layer.begin();
    for (const list of [strokes.ground, strokes.shape, strokes.ray]) {
      for (const stroke of list) paint(stroke, projection, this);
    }
    this.#layer.end();
  }

  draw(run: Run, stroke: Stroke): void {
    const { data, count } = run;
    let path = '';
    let opacity = 0;
    for (let k = 0; k < count; k++) {
      path += `${k ? 'L' : 'M'}${text(at(data, 4 * k))} ${text(at(data, 4 * k + 1))}`;
      opacity += at(data, 4 * k + 3);
    }
    this.#layer.show(String(this.#count++), 'path', {
      d: run.closed ? `${path}Z` : path,
      class: `scene-ink-${stroke.ink}`,
      'stroke-width': stroke.width * this.#scale,
      // A path has one opacity: the mean of the fading one.
      'stroke-opacity': (stroke.alpha * opacity) / count,
      'stroke-dasharray': stroke.dash?.map((length) => length * this.#scale).join(' ') ?? 'none',
    });
  }

  dispose(): void {
    this.#layer.begin();
    this.#layer.end();
  }
}

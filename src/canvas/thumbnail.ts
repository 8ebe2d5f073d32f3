import type { SceneModel } from '../state/scene-model.ts';
import { poseOf } from './camera.ts';
import { figures } from './figures.ts';
import { Layer, text } from './layer.ts';
import { drawMarks, type MarkKind } from './marks.ts';
import { PathPainter } from './path-painter.ts';
import { Projection } from './projection.ts';
import { SceneLines } from './scene-lines.ts';
import { at } from './stroke.ts';
import type { Grid } from './tessellation.ts';

const SVG = 'http://www.w3.org/2000/svg';
const WIDTH = 200;
const HEIGHT = 116;
/** Factor on lines and marks. */
const SCALE = 0.55;
const SHOWN: readonly MarkKind[] = ['E', 'first', 'other', 'rejected', 'end'];
/** Of the samples around a patch each fourth is enough at this size. */
const COARSE = 4;

/**
 * A small still picture without words. Its colours are custom properties, so it follows the theme.
 */
export function drawThumbnail(host: HTMLElement, model: SceneModel): void {
  const svg = document.createElementNS(SVG, 'svg');
  svg.setAttribute('class', 'scene-thumbnail');
  svg.setAttribute('viewBox', `0 0 ${WIDTH} ${HEIGHT}`);
  svg.setAttribute('aria-hidden', 'true');
  const sceneLines = new SceneLines();
  const units = sceneLines.take(model);
  const projection = new Projection(poseOf(model.view, model.ray, units), WIDTH, HEIGHT);
  const walls = new Layer(svg, 'scene-walls');
  for (const [k, grid] of sceneLines.grids.entries()) {
    walls.show(String(k), 'path', { d: silhouettes(grid, projection) });
  }
  new PathPainter(svg).paint(sceneLines.strokes(model, projection, null), projection, {
    scale: SCALE,
  });
  const { marks } = figures(model, units, projection, SCALE);
  const shown = marks.filter(({ kind }) => SHOWN.includes(kind));
  drawMarks(
    new Layer(svg, 'scene-mark-layer'),
    // Other names: what looks for a mark of the scene shall not find this one.
    shown.map((mark) => ({ ...mark, key: `small ${mark.key}`, symbols: [] })),
    SCALE,
    null,
  );
  host.replaceChildren(svg);
}

/**
 * All cells of a patch as one path, each turned the same way round, so that together they fill what
 * the patch covers, once.
 */
function silhouettes({ columns, rows, points }: Grid, projection: Projection): string {
  const across = columns + 1;
  const spots = (k: number) =>
    projection.project([at(points, 3 * k), at(points, 3 * k + 1), at(points, 3 * k + 2)]);
  let path = '';
  for (let j = 0; j < rows; j++) {
    for (let i = 0; i < columns; i += COARSE) {
      const k = j * across + i;
      const cell = [k, k + COARSE, k + across + COARSE, k + across].map(spots);
      const [a, b, c, d] = cell;
      if (!a || !b || !c || !d) continue;
      const area = (c.x - a.x) * (d.y - b.y) - (d.x - b.x) * (c.y - a.y);
      const ring = area < 0 ? [d, c, b, a] : [a, b, c, d];
      path += `M${ring.map(({ x, y }) => `${text(x)} ${text(y)}`).join('L')}Z`;
    }
  }
  return path;
}

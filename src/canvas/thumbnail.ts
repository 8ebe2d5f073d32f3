import type { Vec3 } from '../math/index.ts';
import type { SceneModel } from '../state/scene-model.ts';
import { type Pose, poseOf } from './camera.ts';
import { figures } from './figures.ts';
import { framedPose } from './framing.ts';
import { Layer, text } from './layer.ts';
import { drawMarks, type MarkKind } from './marks.ts';
import { Overlay } from './overlay.ts';
import { PathPainter } from './path-painter.ts';
import { Projection } from './projection.ts';
import { SceneLines } from './scene-lines.ts';
import type { StageUnits } from './stage-units.ts';
import { at } from './stroke.ts';
import type { Grid } from './tessellation.ts';

const SVG = 'http://www.w3.org/2000/svg';
/** Size of a picture in the gallery. */
const SMALL: Size = { width: 200, height: 116, scale: 0.55 };
/** Part of the frame that is left free around what has to be seen from above. */
const MARGIN = 0.2;
const NEAREST = 6;
/** Factor on the distance of the view from above, so that vertical walls hardly lean. */
const FARTHER = 16;
const SHOWN: readonly MarkKind[] = ['E', 'first', 'other', 'rejected', 'end'];
/** Every fourth sample around a patch is drawn. */
const COARSE = 4;

interface Size {
  /** Size in CSS px. */
  readonly width: number;
  readonly height: number;
  /** Factor on lines and marks. */
  readonly scale: number;
}

/**
 * Draws a small picture without words. Its colours are custom properties, so it follows the theme.
 */
export function drawThumbnail(host: HTMLElement, model: SceneModel): void {
  draw(host, model, SMALL, (units) => framedPose(model, units, SMALL));
}

/** Draws a small picture from above, in which these points fill the frame. */
export function drawAbove(
  host: HTMLElement,
  model: SceneModel,
  { width, height, scale }: Size,
  points: readonly Vec3[],
): void {
  // The middle of a frame that is `FARTHER` times larger.
  const large = { width: FARTHER * width, height: FARTHER * height, scale };
  const { svg } = draw(host, { ...model, view: 'top' }, large, (units, project) => {
    const pose = { ...poseOf('top', model.ray, units), zoom: 1 / FARTHER };
    const seen = points.flatMap((point) => {
      const place = units.toStage(point);
      return place ? [place] : [];
    });
    if (seen.length === 0) return pose;
    const middle = (i: 0 | 1 | 2): number => {
      const all = seen.map((point) => point[i]);
      return (Math.min(...all) + Math.max(...all)) / 2;
    };
    const target: Vec3 = [middle(0), middle(1), middle(2)];
    const whole = project({ ...pose, target });
    const spots = seen.flatMap((point) => whole.project(point) ?? []);
    const fill = Math.max(
      ...spots.map(({ x }) => Math.abs(2 * x - large.width) / width),
      ...spots.map(({ y }) => Math.abs(2 * y - large.height) / height),
    );
    return { ...pose, target, zoom: Math.min((1 - MARGIN) / fill, NEAREST) / FARTHER };
  });
  const [left, top] = [(large.width - width) / 2, (large.height - height) / 2];
  svg.setAttribute('viewBox', `${left} ${top} ${width} ${height}`);
}

/**
 * The scene as a drawing of its own, for paper and for a file: every line, mark and word that the
 * page shows, walls in one flat tint. `label` is the size of its symbols, in the drawing's units;
 * the style sheet of where it stands has the same as --scene-label.
 */
export function drawStill(
  host: HTMLElement,
  model: SceneModel,
  size: Size & { readonly label: number },
): SVGSVGElement {
  const { svg, units, projection, rays } = draw(host, model, size, (units) =>
    framedPose(model, units, size),
  );
  svg.classList.add('scene-still');
  svg.querySelector('.scene-mark-layer')?.remove();
  new Overlay(svg).draw(model, rays, units, projection, size, null, [], []);
  return svg;
}

function draw(
  host: HTMLElement,
  model: SceneModel,
  { width, height, scale }: Size,
  poseIn: (units: StageUnits, project: (pose: Pose) => Projection) => Pose,
) {
  const svg = document.createElementNS(SVG, 'svg');
  svg.setAttribute('class', 'scene-thumbnail');
  svg.setAttribute('viewBox', `0 0 ${width} ${height}`);
  svg.setAttribute('aria-hidden', 'true');
  const sceneLines = new SceneLines();
  const units = sceneLines.take(model);
  const projected = (pose: Pose): Projection => new Projection(pose, width, height);
  const projection = projected(poseIn(units, projected));
  const walls = new Layer(svg, 'scene-walls');
  for (const [k, grid] of sceneLines.grids.entries()) {
    walls.show(String(k), 'path', { d: silhouettes(grid, projection) });
  }
  const strokes = sceneLines.strokes(model, projection, null);
  new PathPainter(svg).paint(strokes, projection, { scale });
  const { marks } = figures(model, units, projection, scale);
  const shown = marks.filter(({ kind }) => SHOWN.includes(kind));
  drawMarks(
    new Layer(svg, 'scene-mark-layer'),
    // Keys of their own and no symbols, so that they are not taken for marks of the scene.
    shown.map((mark) => ({ ...mark, key: `small ${mark.key}`, symbols: [] })),
    scale,
    null,
  );
  host.replaceChildren(svg);
  return { svg, units, projection, rays: strokes.ray };
}

/** All cells of a patch as one path with the same orientation, so that it fills the patch once. */
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

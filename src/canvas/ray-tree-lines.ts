import type { TreeLine } from '../state/picture/tree-scene.ts';
import type { RayKind } from '../tracer/types.ts';
import { Layer } from './layer.ts';
import type { Projection } from './projection.ts';
import type { StageUnits } from './stage-units.ts';
import { type Dash, type Stroke, straight } from './stroke.ts';
import type { Ink, Theme } from './theme.ts';

/** Line styles by kind of ray, as in the list's swatches. */
const STYLES: Readonly<Record<RayKind, { ink: Ink; width: number; dash: Dash | null }>> = {
  camera: { ink: 'd', width: 3, dash: null },
  shadow: { ink: 'd', width: 1.6, dash: [2, 5] },
  reflected: { ink: 'normal', width: 2.4, dash: [10, 5] },
  refracted: { ink: 'hit', width: 2.4, dash: [6, 3] },
};
const CHOSEN = 2;
/** Opacity of a ray of weight 0. */
const LEAST_ALPHA = 0.45;
/** Number of rays with the largest weights that have their weight written beside them. */
const MOST_LABELS = 6;
const ALONG = 0.62;
/** Least weight that is written beside a ray; the list has all. */
const LEAST_LABEL = 0.01;

export function lineStrokes(
  lines: readonly TreeLine[],
  chosen: ReadonlySet<string>,
  units: StageUnits,
): Stroke[] {
  return lines.flatMap(({ kind, from, to, path, weight }) => {
    const a = units.toStage(from);
    const b = units.toStage(to);
    if (!a || !b) return [];
    const { ink, width, dash } = STYLES[kind];
    const isChosen = chosen.has(path);
    const alpha = isChosen ? 1 : LEAST_ALPHA + (1 - LEAST_ALPHA) * Math.min(weight, 1);
    return [straight(a, b, { ink, dash, alpha, width: isChosen ? CHOSEN * width : width })];
  });
}

/** The marks at the ends of rays, the weights of rays, the names of lights. */
export class TreeMarks {
  readonly #layer: Layer;

  constructor(svg: Element) {
    this.#layer = new Layer(svg, 'tree-marks');
  }

  draw(
    lines: readonly TreeLine[],
    chosen: ReadonlySet<string>,
    units: StageUnits,
    projection: Projection,
    { scale }: Pick<Theme, 'scale'>,
  ): void {
    const layer = this.#layer;
    const named = new Set<string>();
    const written: { readonly x: number; readonly y: number }[] = [];
    const weights = lines.filter(carries).map(({ weight }) => weight);
    const least = Math.max(weights.sort((a, b) => b - a)[MOST_LABELS - 1] ?? 0, LEAST_LABEL);
    layer.begin();
    for (const line of lines) {
      const { path, kind, end, light, weight } = line;
      const spot = spotOf(line.to, units, projection);
      const start = spotOf(line.from, units, projection);
      if (!spot) continue;
      const r = (chosen.has(path) ? 6 : 4.2) * scale;
      if (end === 'hit') {
        layer.show(path, 'circle', { class: `tree-hit tree-${kind}`, cx: spot.x, cy: spot.y, r });
      }
      if (end === 'blocked') {
        const d = `M${spot.x - r} ${spot.y - r}l${2 * r} ${2 * r}m0 ${-2 * r}l${-2 * r} ${2 * r}`;
        layer.show(path, 'path', { class: 'tree-cross', d });
      }
      if (end === 'light' && light !== null && !named.has(light)) {
        named.add(light);
        this.#text(`${light} light`, light, spot.x + 6 * scale, spot.y - 6 * scale);
      }
      if (carries(line) && weight >= least && start) {
        // Nearer to the ray's end, since several rays may start at one point.
        const [x, y] = [start.x + ALONG * (spot.x - start.x), start.y + ALONG * (spot.y - start.y)];
        const isFree = written.every((p) => Math.abs(p.x - x) > 34 || Math.abs(p.y - y) > 13);
        if (!isFree) continue;
        written.push({ x, y });
        this.#text(`${path} weight`, `${Math.round(100 * weight)} %`, x + 5, y - 5);
      }
    }
    layer.end();
  }

  #text(key: string, words: string, x: number, y: number): void {
    const element = this.#layer.show(key, 'text', { class: 'tree-label', x, y });
    if (element.textContent !== words) element.textContent = words;
  }
}

const carries = ({ kind }: TreeLine): boolean => kind === 'reflected' || kind === 'refracted';

function spotOf(
  p: TreeLine['to'],
  units: StageUnits,
  projection: Projection,
): { x: number; y: number } | null {
  const place = units.toStage(p);
  return place && projection.project(place);
}

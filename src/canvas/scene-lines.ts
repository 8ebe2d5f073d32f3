import type { Drawing, Stage } from '../math/drawing.ts';
import type { SceneModel } from '../state/scene-model.ts';
import { ghostStrokes } from './ghost.ts';
import { ground } from './ground.ts';
import { outline } from './outline.ts';
import type { Strokes } from './painter.ts';
import type { Projection } from './projection.ts';
import { rayStrokes, shadowStrokes } from './ray.ts';
import { silhouette } from './silhouette.ts';
import { StageUnits } from './stage-units.ts';
import type { Dash, Stroke } from './stroke.ts';
import { type Grid, tessellate } from './tessellation.ts';

const SILHOUETTE = { ink: 'shape', width: 2, alpha: 0.95, dash: null } as const;
const FIGURE = { width: 2.6, alpha: 1, dash: null } as const;
const TRAIL = { width: 2.6, alpha: 0.8, dash: [2, 4] as Dash } as const;
const LIT_SHAPE = 1.5;
const LIT_RAY = 1.35;
/** Symbols with which the shape's lines are highlighted, besides those of its own marks. */
const SHAPE_SYMBOLS = new Set(['V', 'C', 'P', 'N', 'c', 'r', 'a', 'L', 'axis']);

/** The lines and walls of a model; cached while drawing and stage are the same objects. */
export class SceneLines {
  grids: readonly Grid[] = [];
  #drawing: Drawing | null = null;
  #stage: Stage | null = null;
  #units: StageUnits | null = null;
  #outline: readonly Stroke[] = [];
  #ground: readonly Stroke[] = [];

  /** Number of times the patches were sampled. */
  version = 0;

  take(model: SceneModel): StageUnits {
    const { drawing, stage } = model;
    const stageIsNew = stage !== this.#stage || this.#units === null;
    const units = stageIsNew ? new StageUnits(stage) : (this.#units as StageUnits);
    const isNew = stageIsNew || drawing !== this.#drawing;
    if (stageIsNew) this.#ground = ground(units);
    if (isNew) {
      this.version++;
      this.grids = drawing.patches.map((patch) => tessellate(patch, units));
      this.#outline = outline(drawing, units);
    }
    [this.#drawing, this.#stage, this.#units] = [drawing, stage, units];
    return units;
  }

  strokes(model: SceneModel, projection: Projection, lit: string | null): Strokes {
    const units = this.take(model);
    const shapeIsLit =
      lit !== null &&
      (SHAPE_SYMBOLS.has(lit) || model.drawing.marks.some((mark) => mark.symbol === lit));
    const edge = SILHOUETTE.width * (shapeIsLit ? LIT_SHAPE : 1);
    const outlines = shapeIsLit ? this.#outline.map(thicker) : this.#outline;
    const silhouettes = this.grids.flatMap((grid) =>
      silhouette(grid, projection, units).map((chain) => ({
        ...chain,
        ...SILHOUETTE,
        width: edge,
      })),
    );
    const rays = rayStrokes(model.ray, units, lit === 'E' || lit === 'd' ? LIT_RAY : 1);
    return {
      ground: [...this.#ground, ...shadowStrokes(model, units), ...ghostStrokes(model, units)],
      ray: rays,
      shape: [...outlines, ...silhouettes, ...figureStrokes(model, units)],
    };
  }
}

/** The lines of a step of the walk; those outside of the picture are left out. */
function figureStrokes({ figures = [] }: SceneModel, units: StageUnits): Stroke[] {
  return figures.flatMap(({ points, closed, ink }): Stroke[] => {
    const placed = points.map((point) => units.toStage(point));
    if (placed.includes(null)) return [];
    const flat = Float64Array.from(placed.flatMap((point) => point ?? []));
    const look = ink === 'hit' ? TRAIL : FIGURE;
    return [{ points: flat, fade: null, closed, ink, ...look }];
  });
}

/** A thicker stroke; rings stay thin. */
function thicker(stroke: Stroke): Stroke {
  return stroke.width > 1 ? { ...stroke, width: stroke.width * LIT_SHAPE } : stroke;
}

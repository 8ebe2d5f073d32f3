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
import type { Stroke } from './stroke.ts';
import { type Grid, tessellate } from './tessellation.ts';

const SILHOUETTE = { ink: 'shape', width: 2, alpha: 0.95, dash: null } as const;
const FIGURE = { width: 2.6, alpha: 1, dash: null } as const;
/** A trail of hits is dotted, a level surface has a thin rim. */
const LOOKS: Readonly<Record<string, Pick<Stroke, 'width' | 'alpha' | 'dash'>>> = {
  hit: { width: 2.6, alpha: 0.8, dash: [2, 4] },
  level: { width: 1, alpha: 0.8, dash: null },
  normal: { width: 1.4, alpha: 0.9, dash: null },
};
const LIT_SHAPE = 1.5;
const LIT_RAY = 1.35;
/** Symbols with which the shape's lines are highlighted, besides those of its own marks. */
const SHAPE_SYMBOLS = new Set(['V', 'C', 'P', 'N', 'c', 'r', 'a', 'L', 'axis']);

/** The lines and walls of a model; cached while drawing and stage are the same objects. */
export class SceneLines {
  #walls: readonly Grid[] = [];
  #near: readonly Grid[] = [];
  #levels: SceneModel['levels'];
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
      this.#walls = drawing.patches.map((patch) => tessellate(patch, units));
      this.#outline = outline(drawing, units);
    }
    if (stageIsNew || model.levels !== this.#levels) {
      this.version++;
      this.#near = (model.levels ?? []).map((patch) => tessellate(patch, units));
      this.#levels = model.levels;
    }
    [this.#drawing, this.#stage, this.#units] = [drawing, stage, units];
    return units;
  }

  /** The walls of the shape, and level surfaces. */
  get grids(): readonly Grid[] {
    return [...this.#walls, ...this.#near];
  }

  strokes(model: SceneModel, projection: Projection, lit: string | null): Strokes {
    const units = this.take(model);
    const shapeIsLit =
      lit !== null &&
      (SHAPE_SYMBOLS.has(lit) || model.drawing.marks.some((mark) => mark.symbol === lit));
    const edge = SILHOUETTE.width * (shapeIsLit ? LIT_SHAPE : 1);
    const outlines = shapeIsLit ? this.#outline.map(thicker) : this.#outline;
    const silhouettes = this.#walls.flatMap((grid) =>
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
    const look = LOOKS[ink] ?? FIGURE;
    return [{ points: flat, fade: null, closed, ink: ink === 'level' ? 'shape' : ink, ...look }];
  });
}

/** A thicker stroke; rings stay thin. */
function thicker(stroke: Stroke): Stroke {
  return stroke.width > 1 ? { ...stroke, width: stroke.width * LIT_SHAPE } : stroke;
}

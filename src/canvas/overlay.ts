import type { SceneModel } from '../state/scene-model.ts';
import { drawAxes } from './axes.ts';
import { captionBoxes, drawCaptions, drawPointers, pointerBoxes } from './captions.ts';
import { type Caption, figures } from './figures.ts';
import { NARROW } from './framing.ts';
import { ghostFigures } from './ghost.ts';
import type { Box, Segment } from './labels.ts';
import { Layer } from './layer.ts';
import { markFigures } from './mark-on-ray.ts';
import { CLEAR, drawArrows, drawMarks } from './marks.ts';
import type { Projection } from './projection.ts';
import type { StageUnits } from './stage-units.ts';
import { at, type Pen, paint, type Stroke } from './stroke.ts';
import type { Theme } from './theme.ts';
import { drawTicks, ticksOn } from './ticks.ts';

/** Everything of fixed size above the picture, from bottom to top: marks, normals, ticks, … */
export class Overlay {
  readonly #axes: Layer;
  readonly #ticks: Layer;
  readonly #arrows: Layer;
  readonly #ghost: Layer;
  readonly #gap: Layer;
  readonly #marks: Layer;
  readonly #captions: Layer;
  /** The last place of each label, so that it stays there. */
  readonly #places = new Map<string, string>();

  constructor(svg: Element) {
    this.#axes = new Layer(svg, 'scene-axes');
    this.#ticks = new Layer(svg, 'scene-tick-layer');
    this.#arrows = new Layer(svg, 'scene-arrow-layer');
    this.#ghost = new Layer(svg, 'scene-ghost-layer');
    this.#gap = new Layer(svg, 'scene-gap-layer');
    this.#marks = new Layer(svg, 'scene-mark-layer');
    this.#captions = new Layer(svg, 'scene-caption-layer');
  }

  forget(): void {
    this.#places.clear();
  }

  /** @param words beside the handle in use. @param axisArrows arrows of that handle. */
  draw(
    model: SceneModel,
    rays: readonly Stroke[],
    units: StageUnits,
    projection: Projection,
    theme: Pick<Theme, 'scale' | 'label'>,
    lit: string | null,
    words: readonly Caption[],
    axisArrows: readonly Segment[],
  ): void {
    const { scale, label } = theme;
    const laid = layOut(
      model,
      rays,
      units,
      projection,
      { scale, label, words, axisArrows },
      this.#places,
    );
    drawAxes(this.#axes, projection, scale, label * 0.8);
    drawArrows(this.#arrows, laid.arrows, scale, lit);
    drawMarks(this.#ghost, laid.ghostMarks, scale, lit);
    this.#gap.begin();
    if (laid.gap) this.#gap.show('gap', 'path', { class: 'scene-bracket', d: laid.gap });
    this.#gap.end();
    drawMarks(this.#marks, laid.marks, scale, lit);
    this.#captions.begin();
    drawPointers(this.#captions, laid.pointers, laid.pointerBoxes, theme, lit);
    drawCaptions(this.#captions, laid.captions, laid.captionBoxes, theme, lit);
    this.#captions.end();
    drawTicks(this.#ticks, laid.ticks, scale);
  }
}

interface Sizes {
  /** Factor on marks, and the size of a label in CSS pixels. */
  readonly scale: number;
  readonly label: number;
  readonly words: readonly Caption[];
  readonly axisArrows: readonly Segment[];
}

/** Places of everything in the overlay. `places`: the last place of each label; is updated. */
export function layOut(
  model: SceneModel,
  rays: readonly Stroke[],
  units: StageUnits,
  projection: Projection,
  { scale, label, words, axisArrows }: Sizes,
  places: Map<string, string>,
) {
  const { arrows, pointers, marks, ...now } = figures(model, units, projection, scale);
  const ghost = ghostFigures(model, units, projection, scale);
  const mark = markFigures(model, units, projection, scale);
  const captions = [...now.captions, ...mark.captions, ...ghost.captions, ...words];
  const boxes: Box[] = [...ghost.marks, ...marks].map(({ spot, kind }) => {
    const size = 2 * CLEAR[kind] * scale;
    return { x: spot.x, y: spot.y, w: size, h: size };
  });
  boxes.push(...furniture(projection, scale));
  const segments = [
    ...onScreen(rays, projection),
    ...axisArrows,
    ...arrows.map(({ from, to }): Segment => [from.x, from.y, to.x, to.y]),
  ];
  const pointed = pointerBoxes(pointers, label);
  const { width, height } = projection;
  const obstacles = { boxes, labels: pointed, segments, width, height };
  const captioned = captionBoxes(captions, obstacles, places, label);
  const taken = [...boxes, ...pointed, ...captioned];
  return {
    ...{ arrows, pointers, captions, marks, ghostMarks: ghost.marks, gap: mark.path },
    pointerBoxes: pointed,
    captionBoxes: captioned,
    ticks: ticksOn(model, units, projection, scale, taken),
  };
}

/** Boxes of the view buttons and the small axes, which labels must not cover. */
function furniture({ width, height }: Projection, scale: number): Box[] {
  const views =
    width < NARROW
      ? { x: width - 36, y: 64, w: 72, h: 128 }
      : { x: width - 132, y: 24, w: 264, h: 44 };
  return [views, { x: 56 * scale, y: height - 48 * scale, w: 112 * scale, h: 96 * scale }];
}

/** The visible pieces of the ray, which labels must not cover. */
function onScreen(strokes: readonly Stroke[], projection: Projection): Segment[] {
  const segments: Segment[] = [];
  const pen: Pen = {
    draw({ data, count }) {
      for (let k = 0; k + 1 < count; k++) {
        const [a, b] = [4 * k, 4 * k + 4];
        segments.push([at(data, a), at(data, a + 1), at(data, b), at(data, b + 1)]);
      }
    },
  };
  for (const stroke of strokes) paint(stroke, projection, pen);
  return segments;
}

import { describe, expect, test } from 'vitest';
import { BUTTONS, framedPose, NARROW } from '../../../src/canvas/framing.ts';
import { overlap } from '../../../src/canvas/labels.ts';
import { layOut } from '../../../src/canvas/overlay.ts';
import { Projection } from '../../../src/canvas/projection.ts';
import { SceneLines } from '../../../src/canvas/scene-lines.ts';
import { walkOf } from '../../../src/math/formula.ts';
import { SHAPES } from '../../../src/math/index.ts';
import { createDerive } from '../../../src/state/derive.ts';
import { exploreDetails } from '../../../src/state/explore-details.ts';
import { GALLERY } from '../../../src/state/gallery/index.ts';
import type { SceneModel } from '../../../src/state/scene-model.ts';
import { decode } from '../../../src/state/url.ts';
import { sceneAt } from '../../../src/state/walk-figures.ts';

/**
 * The scene's frame in windows of 1280 × 720, 1024 × 768 and 390 × 844 beside an example's
 * question, with the theme's size of marks and labels there. Light and dark have the same ones.
 */
const FRAMES = [
  { window: '1280 × 720', width: 728, height: 386, scale: 1, label: 23 },
  { window: '1024 × 768', width: 570, height: 420, scale: 1, label: 23 },
  { window: '390 × 844', width: 390, height: 242, scale: 0.84, label: 19 },
  { window: '1280 × 720, projector', width: 700, height: 378, scale: 1.34, label: 31 },
  { window: '1024 × 768, projector', width: 555, height: 412, scale: 1.34, label: 31 },
  { window: '390 × 844, projector', width: 390, height: 242, scale: 1.34, label: 31 },
];

function laidOut(model: SceneModel, { width, height, scale, label }: (typeof FRAMES)[number]) {
  const lines = new SceneLines();
  const units = lines.take(model);
  const pose = framedPose(model, units, { width, height, scale });
  const projection = new Projection(pose, width, height);
  const { ray } = lines.strokes(model, projection, null);
  const sizes = { scale, label, words: [], axisArrows: [] };
  const laid = layOut(model, ray, units, projection, sizes, new Map());
  return { ...laid, units, projection };
}

/** Beside the derivation the scene is narrower. */
const WALK_FRAMES = [
  { window: '1280 × 720', width: 404, height: 314, scale: 1, label: 23 },
  { window: '390 × 844', width: 390, height: 242, scale: 0.84, label: 19 },
  { window: '1280 × 720, projector', width: 404, height: 308, scale: 1.34, label: 31 },
];

const labelsOf = (one: ReturnType<typeof laidOut>) =>
  [
    ...one.captions.map(({ key }, i) => ({ key, box: one.captionBoxes[i] })),
    ...one.pointers.map(({ key }, i) => ({ key: `${key} →`, box: one.pointerBoxes[i] })),
    ...one.ticks.numbers.map(({ label, box }) => ({ key: label, box })),
  ].flatMap(({ key, box }) => (box ? [{ key, box }] : []));

/** Names of labels that lie on each other. */
const metIn = (labels: ReturnType<typeof labelsOf>): string[] =>
  labels.flatMap((a, i) =>
    labels
      .slice(i + 1)
      .filter((b) => overlap(a.box, b.box) > 0)
      .map((b) => `${a.key} on ${b.key}`),
  );

describe.each(WALK_FRAMES)('the derivation, $window', (frame) => {
  const derive = createDerive(() => exploreDetails);
  const links = SHAPES.flatMap(({ kind }) =>
    ['', '&hide=1'].map((more) => `#/explore?shape=${kind}${more}`),
  );

  test.each(links)('%s: no label lies on another at any step', (link) => {
    const model = derive(decode(link));
    const beside = [false, true].map((on) => ({ unit: on, facing: on }));
    const met = walkOf(model.shape, false).flatMap(({ id }) =>
      beside.flatMap((choice) =>
        metIn(labelsOf(laidOut(sceneAt(model, id, choice), frame))).map(
          (words) => `${id}: ${words}`,
        ),
      ),
    );
    expect(met).toEqual([]);
  });
});

describe.each(FRAMES)('$window', (frame) => {
  const derive = createDerive(() => exploreDetails);

  const first = SHAPES.map(({ kind }) => `#/explore?shape=${kind}`);
  test.each([
    '',
    ...first,
    // Its lower circle is wider than the stage.
    '#/explore?shape=cone&c=1',
  ])('"%s": the whole shape is in the frame, as far as it is drawn', (link) => {
    const { scene } = derive(decode(link));
    const { units, projection } = laidOut(scene, frame);
    const steps = Array.from({ length: 31 }, (_, i) => i / 30);
    const out = scene.drawing.patches
      .filter(({ closed, sides }) => closed || sides === 'edge')
      .flatMap((patch) => steps.flatMap((u) => steps.map((v) => units.toStage(patch.at(u, v)))))
      .map((place) => place && projection.project(place))
      .filter(
        (spot) =>
          !spot || spot.x < 0 || spot.y < 0 || spot.x > frame.width || spot.y > frame.height,
      );
    expect(out).toEqual([]);
  });

  const all = GALLERY.map((entry) => {
    const { scene } = derive(decode(entry.link));
    return { entry, scene, ...laidOut(scene, frame) };
  });

  test.each(all.map((one) => [one.entry.id, one] as const))(
    '%s: no label lies on another',
    (_, one) => {
      const labels = labelsOf(one);
      expect(metIn(labels)).toEqual([]);
      const out = labels.filter(
        ({ box: { x, y, w, h } }) =>
          x < w / 2 || y < h / 2 || x > frame.width - w / 2 || y > frame.height - h / 2,
      );
      expect(out.map(({ key }) => key)).toEqual([]);
      const column = frame.width - (frame.width < NARROW ? BUTTONS.column : 0);
      const under = one.pointerBoxes.filter(({ x, w }) => x + w / 2 > column);
      expect(under, 'pointers under the views').toEqual([]);
    },
  );

  test.each(all.map((one) => [one.entry.id, one] as const))(
    '%s: its points are in the frame, clear of the buttons',
    (_, one) => {
      const { scene, entry, units, projection } = one;
      const disc = 8 * frame.scale;
      const clear = ({ x, y }: { x: number; y: number }) =>
        x >= disc && x <= frame.width - disc && y >= 36 + disc && y <= frame.height - 34 - disc;
      const spots = [
        ['E', scene.ray.originDrawn ? scene.ray.origin : null] as const,
        ...scene.hits.map(
          ({ index, drawn, point }) => [`P${index}`, drawn ? point : null] as const,
        ),
        ...scene.drawing.marks.map(({ symbol, at }) => [symbol, at] as const),
      ];
      const outside = spots.filter(([, point]) => {
        const place = point && units.toStage(point);
        const spot = place && projection.project(place);
        return !spot || !clear(spot);
      });
      expect(outside.map(([name]) => name)).toEqual(entry.outside);
    },
  );
});

import { expect, test } from 'vitest';
import { between } from '../../../src/pages/transition.ts';
import { createDerive } from '../../../src/state/derive.ts';
import { exploreDetails } from '../../../src/state/explore-details.ts';
import { GALLERY } from '../../../src/state/gallery/index.ts';
import { rayOf, shapeOf } from '../../../src/state/state.ts';
import { decode } from '../../../src/state/url.ts';

const PAIRS = GALLERY.slice(1).flatMap((entry, i) => {
  const [from, to] = [decode(GALLERY[i]?.link ?? ''), decode(entry.link)];
  return from.kind === to.kind ? [[entry.id, from, to] as const] : [];
});

test.each(PAIRS)(
  'to %s: begins and ends exactly there, with an answer all the way',
  (_, from, to) => {
    const derive = createDerive(() => exploreDetails);
    const at = (share: number) => between(from, to, share);
    expect([rayOf(at(0)).origin, shapeOf(at(0))]).toEqual([
      from.E,
      { ...shapeOf(from), ...axis(to) },
    ]);
    for (let share = 0; share < 1; share += 1 / 16) {
      const { found, scene } = derive(at(share));
      expect(found.class).toBeDefined();
      expect(scene.stage.radius).toBeGreaterThan(0);
    }
    expect([rayOf(at(1)), shapeOf(at(1))]).toEqual([rayOf(to), shapeOf(to)]);
  },
);

/** An axis has no way from one to the other: it is the second one at once. */
function axis(to: ReturnType<typeof decode>) {
  const shape = shapeOf(to);
  return 'axis' in shape ? { axis: shape.axis } : {};
}

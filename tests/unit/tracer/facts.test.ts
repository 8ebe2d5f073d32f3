import { describe, expect, test } from 'vitest';
import { far } from '../../../src/scene/presets/far.ts';
import { grazing } from '../../../src/scene/presets/grazing.ts';
import { grazing2 } from '../../../src/scene/presets/grazing-2.ts';
import { selfIntersection } from '../../../src/scene/presets/self-intersection.ts';
import { twoScales } from '../../../src/scene/presets/two-scales.ts';
import type { Scene } from '../../../src/scene/types.ts';
import { type Comparison, comparePictures } from '../../../src/tracer/compare.ts';
import type { StartRule } from '../../../src/tracer/types.ts';
import { samePicture } from './tracing.ts';

/* The two lessons of the page, as numbers, on small pictures. */

const SIZE = { width: 72, height: 40 };

const trace = (scene: Scene, method: string, start: StartRule = { rule: 'from' }) =>
  samePicture(scene, { ...SIZE, method, start });
const share = ({ differing, pixels }: Comparison): number => differing / pixels;

describe.each([far, grazing, grazing2])(
  'holes and wrong silhouettes come from the method: $id',
  ({ scene }) => {
    test('float32 and the textbook judge many pixels wrongly, certified none', async () => {
      const right = await trace(scene, 'exact');
      const against = async (method: string): Promise<Comparison> =>
        comparePictures(await trace(scene, method), right);
      const certified = await against('certified');
      expect(certified).toMatchObject({ differing: 0, verdicts: 0 });
      expect(certified.mostDigits).toBeLessThan(1);
      expect((await against('textbook32')).verdicts).toBeGreaterThan(right.surface.length / 4);
      // Its better roots do not help the stable method: it judges by the textbook's D.
      for (const method of ['textbook', 'stable']) {
        const { verdicts, holes, ghosts } = await against(method);
        expect(verdicts).toBeGreaterThan(right.surface.length / 20);
        expect(holes + ghosts).toBeLessThanOrEqual(verdicts);
        expect(holes + ghosts).toBeGreaterThan(0);
      }
      expect((await against('moment')).verdicts).toBe(0);
    });
  },
);

describe('shadow acne comes from the stored hit point', () => {
  const { scene } = selfIntersection;

  test('no method cures it, not even exact; the start rule does for every one', async () => {
    const right = await trace(scene, 'exact');
    for (const method of ['textbook32', 'textbook', 'moment', 'certified', 'exact']) {
      const without = comparePictures(await trace(scene, method, { rule: 'none' }), right);
      expect(share(without)).toBeGreaterThan(0.1);
      expect(without.holes + without.ghosts).toBe(0);
      const withRule = comparePictures(await trace(scene, method), right);
      expect(share(withRule)).toBeLessThan(0.002);
    }
  });

  test('with the rule certified and exact give the same bytes', async () => {
    const [a, b] = await Promise.all([trace(scene, 'certified'), trace(scene, 'exact')]);
    expect([...a.rgba]).toEqual([...b.rgba]);
  });

  test('an epsilon works for one scale only', async () => {
    const right = await trace(twoScales.scene, 'certified');
    const wrong = async (epsilon: number): Promise<number> => {
      const found = await trace(twoScales.scene, 'certified', { rule: 'epsilon', epsilon });
      return comparePictures(found, right).differing;
    };
    // Too small for the hills, where the stored point is off by more.
    for (const epsilon of [1e-12, 1e-8, 1e-7]) expect(await wrong(epsilon)).toBeGreaterThan(100);
    // Too large for the little things, which are hardly larger themselves.
    for (const epsilon of [1e-5, 1e-3]) expect(await wrong(epsilon)).toBeGreaterThan(3);
    const none = comparePictures(
      await trace(twoScales.scene, 'certified', { rule: 'none' }),
      right,
    );
    expect(share(none)).toBeGreaterThan(0.1);
  });
});

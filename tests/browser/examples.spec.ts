import type { Page } from '@playwright/test';
import { type Frame, framedPose } from '../../src/canvas/framing.ts';
import { Projection } from '../../src/canvas/projection.ts';
import { SceneLines } from '../../src/canvas/scene-lines.ts';
import { createDerive } from '../../src/state/derive.ts';
import { exploreDetails } from '../../src/state/explore-details.ts';
import { GALLERY } from '../../src/state/gallery/index.ts';
import { decode } from '../../src/state/url.ts';
import { byTurns } from '../unit/many.ts';
import { open } from './support/page.ts';
import { framesDone } from './support/pending.ts';
import { expect, test } from './support/test.ts';

const SIZES = [
  { width: 1280, height: 720 },
  { width: 1024, height: 768 },
  { width: 390, height: 844 },
];

/** Texts of the scene and of the graph that lie on another one, as they are drawn. */
async function met(page: Page): Promise<string[]> {
  return page.evaluate(() => {
    const GROUPS = [
      '.scene-overlay text',
      '.scene-views button, .example-name, .scene-bar .ray-tool',
      '.graph text',
    ];
    return GROUPS.flatMap((selector) => {
      const all = [...document.querySelectorAll(selector)].map((element) => ({
        name: element.textContent?.replace(/\s+/g, ' ').trim() ?? '',
        box: element.getBoundingClientRect(),
        math: element.classList.contains('scene-label'),
      }));
      // A line of type is higher than its letters.
      const high = (one: (typeof all)[number]) => (one.math ? 0.26 : 0.12) * one.box.height;
      return all.flatMap((a, i) =>
        all.slice(i + 1).flatMap((b) => {
          const x = Math.min(a.box.right, b.box.right) - Math.max(a.box.left, b.box.left);
          const y =
            Math.min(a.box.bottom - high(a), b.box.bottom - high(b)) -
            Math.max(a.box.top + high(a), b.box.top + high(b));
          return x > 1 && y > 1 ? [`${a.name} on ${b.name}: ${x.toFixed()} × ${y.toFixed()}`] : [];
        }),
      );
    });
  });
}

interface Placed {
  readonly name: string;
  readonly left: number;
  readonly right: number;
  readonly top: number;
  readonly bottom: number;
}

/**
 * The scene's frame, and the words over its upper edge, from its upper left corner. Others have a
 * ground, at which lines end.
 */
const framed = (page: Page): Promise<{ frame: Frame; words: Placed[] }> =>
  page.evaluate(() => {
    const host = document.querySelector('.scene-host') as HTMLElement;
    const from = host.getBoundingClientRect();
    const scale = Number(getComputedStyle(host).getPropertyValue('--mark-scale')) || 1;
    const isNarrow = host.clientWidth < 480;
    const views = isNarrow ? '' : ', .scene-views button';
    const buttons = `.example-name, .step-through${views}`;
    const words = [...document.querySelectorAll(buttons)]
      .filter((button) => button.checkVisibility())
      .map((button) => {
        const range = document.createRange();
        range.selectNodeContents(button.querySelector('strong, path') ?? button);
        const box = (button.querySelector('path') ?? range).getBoundingClientRect();
        return {
          name: button.textContent?.trim() || (button.getAttribute('aria-label') ?? ''),
          left: box.left - from.left,
          right: box.right - from.left,
          top: box.top - from.top,
          bottom: box.bottom - from.top,
        };
      });
    return { frame: { width: host.clientWidth, height: host.clientHeight, scale }, words };
  });

const derive = createDerive(() => exploreDetails);

/** The words that the ray is drawn behind, from E on; the line behind E is faint. */
function behindOf(link: string, frame: Frame, words: readonly Placed[]): string[] {
  const { scene: whole } = derive(decode(link));
  const ahead = whole.ray.segments.filter(({ stretch }) => stretch !== 'behind');
  const scene = { ...whole, ray: { ...whole.ray, segments: ahead } };
  const lines = new SceneLines();
  const units = lines.take(scene);
  const { width, height } = frame;
  const projection = new Projection(framedPose(scene, units, frame), width, height);
  const strokes = lines.strokes(scene, projection, null).ray;
  const spots = strokes.flatMap(({ points }) => {
    const end = (i: number) =>
      [points[i], points[i + 1], points[i + 2]] as [number, number, number];
    const [a, b] = [end(0), end(3)];
    return Array.from({ length: 401 }, (_, i) => {
      const at = (k: 0 | 1 | 2): number => a[k] + (i / 400) * (b[k] - a[k]);
      return projection.project([at(0), at(1), at(2)]);
    });
  });
  const isIn = ({ left, right, top, bottom }: Placed): boolean =>
    spots.some((s) => s && s.x > left && s.x < right && s.y > top && s.y < bottom);
  return words.filter(isIn).map(({ name }) => name);
}

// Dark is light in other colours: tests/unit/ui/themes.test.ts.
for (const [turn, theme] of ['light', 'projector'].entries()) {
  test(`${theme}: no text of an example's pictures lies on another one`, async ({ page }) => {
    await page.addInitScript((name) => localStorage.setItem('graze.theme', name), theme);
    await page.emulateMedia({ reducedMotion: 'reduce' });
    for (const [n, size] of SIZES.entries()) {
      await page.setViewportSize(size);
      // Windows and sizes of type by turns; what lies in the scene is looked at in all of them by
      // tests/unit/canvas/examples.test.ts.
      const turns = 2 * SIZES.length;
      for (const { id, link } of byTurns(GALLERY, n + turn * SIZES.length, turns)) {
        await open(page, link);
        await page.locator('.scene-overlay .scene-mark').first().waitFor();
        await framesDone(page);
        const at = `${id} at ${size.width} × ${size.height}`;
        expect.soft(await met(page), at).toEqual([]);
        const { frame, words } = await framed(page);
        expect.soft(behindOf(link, frame, words), `the ray behind words, ${at}`).toEqual([]);
      }
    }
  });
}

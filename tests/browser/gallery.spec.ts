import { intersect, METHODS } from '../../src/math/index.ts';
import { GALLERY } from '../../src/state/gallery/index.ts';
import { INITIAL, rayOf, shapeOf } from '../../src/state/state.ts';
import { decode } from '../../src/state/url.ts';
import { expectInLink, typeInto } from './support/controls.ts';
import {
  hashOf,
  linkWritten,
  NO_SCENE,
  open,
  quantities,
  settle,
  withoutScene,
} from './support/page.ts';
import { frames, framesDone } from './support/pending.ts';
import { test as alone, expect, visit as test } from './support/test.ts';

test.describe.configure({ mode: 'default' });
test.use({ viewport: { width: 900, height: 660 } });

const subjectAt = (at: number) => {
  const state = decode(GALLERY[at]?.link ?? '');
  return { shape: shapeOf(state), ray: rayOf(state) };
};

alone('every example is in the gallery with its question and a small picture', async ({ page }) => {
  // At once: the small pictures do not wait for the scene.
  await open(page, '#/explore');
  await page.getByRole('button', { name: /^example:/ }).click();
  const dialog = page.getByRole('dialog', { name: 'Examples' });
  for (const { id, title, asks } of GALLERY) {
    const card = dialog.locator(`[data-example="${id}"]`);
    await expect(card).toContainText(title);
    await expect(card).toContainText(asks);
    await expect(card.locator('svg path').nth(2), id).toBeAttached();
  }
  await dialog.locator('[data-example="cone-vertex"]').click();
  await expect(dialog).toBeHidden();
  await settle(page);
  await expect(page.locator('.example-name')).toContainText('through the vertex');
  expect((await quantities(page)).class).toBe('tangent');
});

alone(
  'who has done nothing yet is told what to do; then there is something to try',
  async ({ page }) => {
    const challenge = page.locator('.challenge');
    const invitation = page.locator('.invitation');
    await open(page, '');
    await expect(invitation).toHaveText(/Drag E\. Watch D change its sign\./);
    await typeInto(page, 'E.x', '2');
    await expect(invitation).toHaveCount(0);
    await expect(challenge).toContainText('Try: make it tangent.');
    await page.locator('.example-name').focus();
    await page.keyboard.press('Control+z');
    await settle(page);
    await expect(invitation).toHaveCount(0);
    await open(page, '#/explore?shape=cone&V=0,0,0&c=1&E=0,1,0&d=-1,0,0');
    await expect(challenge).toContainText(
      'Done: make t₁ negative (t₁ = −1). Try: make it tangent.',
    );
    await page.getByRole('button', { name: 'No more challenges' }).click();
    await expect(challenge).toHaveCount(0);
    await open(page, '#/explore?shape=sphere&C=0,0,0&r=1&E=3,1,0&d=-1,0,0');
    await expect(page.locator('.verdict')).toContainText('touches');
    await expect(challenge).toHaveCount(0);
    const { title, idea } = METHODS.find(({ id }) => id === INITIAL.method) ?? METHODS[0];
    const words = page.locator('.method-words');
    await words.getByLabel(`What ${title} means`).click();
    await expect(words).toContainText(idea);
    await page.keyboard.press('Escape');
    await expect(words.locator('p')).toBeHidden();
  },
);

test.describe('without the picture', () => {
  test.use({ provoked: NO_SCENE });
  test.beforeEach(({ page }) => withoutScene(page));

  test('a clicker asks, tells and goes on, and round again', async ({ page }) => {
    await page.emulateMedia({ reducedMotion: 'reduce' });
    await open(page, '#/explore');
    // What all of them say and show is held by unit tests: tests/unit/state/gallery.test.ts.
    for (const example of GALLERY.slice(0, 6)) {
      await page.keyboard.press('PageDown');
      await settle(page);
      const state = decode(example.link);
      const found = intersect(shapeOf(state), rayOf(state), state.method);
      await expect(page.locator('.example-name strong')).toHaveText(example.title);
      await expect(page.locator('.asks')).toHaveText(example.asks);
      await expect(page.locator('#example-answer')).toBeEmpty();
      await page.keyboard.press('PageDown');
      await expect(page.locator('#example-answer')).toHaveText(example.answer);
      expect((await quantities(page)).class, example.id).toBe(found.class);
    }
    await open(page, GALLERY.at(-1)?.link ?? '');
    await page.keyboard.press('PageDown');
    await page.keyboard.press('PageDown');
    await expect(page.locator('.example-name strong')).toHaveText(GALLERY[0]?.title ?? '');
    await page.keyboard.press('PageDown');
    // One key too many is taken back before the example is.
    await page.keyboard.press('PageUp');
    await expect(page.locator('#example-answer')).toBeEmpty();
    await page.keyboard.press('PageUp');
    await expect(page.locator('.example-name strong')).toHaveText(GALLERY.at(-1)?.title ?? '');
  });

  test('the numbers travel to the next example, and arrive exactly', async ({ page }) => {
    const at = GALLERY.findIndex(({ id }) => id === 'cylinder-miss');
    await open(page, GALLERY[at - 1]?.link ?? '');
    // The examples come after the first frame.
    await expect(page.locator('.asks')).toHaveText(GALLERY[at - 1]?.asks ?? '');
    const seen = await page.evaluate(async () => {
      const texts = new Set<string>();
      const main = document.querySelector('main') as HTMLElement;
      document.body.dispatchEvent(
        new KeyboardEvent('keydown', { key: 'PageDown', bubbles: true, cancelable: true }),
      );
      document.body.dispatchEvent(
        new KeyboardEvent('keydown', { key: 'PageDown', bubbles: true, cancelable: true }),
      );
      for (let moved = false; ; ) {
        await new Promise((done) => requestAnimationFrame(done));
        const moves = main.hasAttribute('data-moving');
        if (moved && !moves) return [...texts];
        moved ||= moves;
        if (moves)
          texts.add(
            document.querySelector('[data-quantity="D"]')?.getAttribute('data-value') ?? '',
          );
      }
    });
    const values = seen.map(Number);
    // In and out, touching, past it: D goes down all the way.
    expect(values.length).toBeGreaterThan(2);
    expect(values).toEqual([...values].sort((a, b) => b - a));
    await framesDone(page);
    const { shape, ray } = subjectAt(at);
    const found = intersect(shape, ray);
    expect((await quantities(page)).class).toBe(found.class);
    await expect(page.locator('.asks')).toHaveText(GALLERY[at]?.asks ?? '');
  });

  test('any key ends the way; with less motion there is none', async ({ page }) => {
    const at = GALLERY.findIndex(({ id }) => id === 'cylinder-tangent');
    await open(page, GALLERY[at - 1]?.link ?? '');
    // The examples come after the first frame.
    await expect(page.locator('.asks')).toHaveText(GALLERY[at - 1]?.asks ?? '');
    const main = page.locator('main[data-moving]');
    await page.keyboard.press('PageDown');
    await page.keyboard.press('PageDown');
    await main.waitFor({ state: 'attached' });
    await page.keyboard.press('Shift');
    await frames(page, 2);
    await expect(main).toHaveCount(0);
    expect((await quantities(page)).class).toBe('tangent');
    await page.emulateMedia({ reducedMotion: 'reduce' });
    await page.keyboard.press('PageUp');
    await frames(page, 2);
    expect((await quantities(page)).class).toBe('none');
  });

  alone(
    'a slider plays; what stops it keeps what is seen; with less motion its trail',
    async ({ page }) => {
      await open(page, '#/explore?shape=cylinder&C=0,1,0&r=1.5&E=4,1,1&d=-1,0,0');
      const play = page.getByRole('button', { name: 'Play r', exact: true });
      const playing = page.locator('main[data-playing]');
      const trail = page.locator('.graph-trail');
      const r = async (): Promise<number> => Number((await quantities(page)).r);
      await linkWritten(page);
      const link = await hashOf(page);
      await play.click();
      await playing.waitFor({ state: 'attached' });
      await expect(play).toHaveAttribute('aria-pressed', 'true');
      await expect.poll(r).toBeLessThan(1.45);
      expect(await hashOf(page)).toBe(link);
      await page.keyboard.press('Shift');
      await expect(playing).toHaveCount(0);
      await framesDone(page);
      const stopped = await r();
      expect(stopped).toBeLessThan(1.45);
      await expectInLink(page, { r: String(stopped) });
      await expect(trail).toHaveAttribute('d', /^M/);
      await page.keyboard.press('Control+z');
      await framesDone(page);
      expect(await r()).toBe(1.5);
      await expect(page.getByRole('button', { name: 'Undo' })).toHaveAttribute(
        'aria-disabled',
        'true',
      );
      await expect(trail).toHaveCount(0);
      await page.emulateMedia({ reducedMotion: 'reduce' });
      await play.press('Enter');
      await framesDone(page);
      expect(await r()).toBe(1.5);
      await expect(trail).toHaveAttribute('d', /^M/);
      await play.press('Enter');
      await expect(trail).toHaveCount(0);
      await linkWritten(page);
      expect(await hashOf(page)).toBe(link);
    },
  );

  test('the answer comes by its key and by its button, and goes again', async ({ page }) => {
    await open(page, GALLERY[0]?.link ?? '');
    const answer = page.locator('#example-answer');
    const button = page.getByRole('button', { name: 'answer', exact: true });
    await page.keyboard.press('a');
    await expect(answer).toHaveText(GALLERY[0]?.answer ?? '');
    await expect(button).toHaveAttribute('aria-expanded', 'true');
    await button.click();
    await expect(answer).toBeEmpty();
    const scene = await page.locator('.scene-area').boundingBox();
    await page.keyboard.press('a');
    await expect(answer).not.toBeEmpty();
    expect(await page.locator('.scene-area').boundingBox()).toEqual(scene);
  });

  test('the far one says that the textbook formula is contradicted', async ({ page }) => {
    await open(page, GALLERY.find(({ id }) => id === 'cylinder-far')?.link ?? '');
    await expect(page.locator('.verdict')).toContainText('the ray misses');
    await expect(page.locator('.contradicted')).toContainText('exact arithmetic says: two');
  });

  test('an example that was changed says so, asks no more, and comes back', async ({ page }) => {
    const rim = GALLERY.find(({ id }) => id === 'circle-rim');
    await open(page, rim?.link ?? '');
    const name = page.locator('.example-name strong');
    await expect(name).toHaveText('on the rim');
    const asks = page.locator('.asks');
    await expect(asks).toHaveText(rim?.asks ?? '');
    await typeInto(page, 'r', '1.5');
    await expect(name).toHaveText('on the rim, changed');
    await expect(asks).toHaveText('Changed: the question was about another ray.');
    await page.locator('.example-name').focus();
    await page.keyboard.press('Control+z');
    await expect(name).toHaveText('on the rim');
    await expect(asks).toHaveText(rim?.asks ?? '');
    await typeInto(page, 'r', '1.5');
    await page.getByRole('button', { name: 'bring the example back' }).click();
    await expect(asks).toHaveText(rim?.asks ?? '');
  });
});

import { commandsOf } from '../../src/pages/commands.ts';
import { box, expectInLink, typeInto } from './support/controls.ts';
import { NO_SCENE, open, withoutScene } from './support/page.ts';
import { expect, test } from './support/test.ts';

test.use({ provoked: NO_SCENE });

test('one voice: the value first, the consequence second, after a pause', async ({ page }) => {
  await withoutScene(page);
  await open(page, '#/explore?shape=cylinder&C=0,0,0&r=1.4&E=4,1,1.5&d=-1,0,0&method=exact');
  const voice = page.locator('.announcer');
  await expect(voice).toHaveCount(1);
  await typeInto(page, 'r', '1.45');
  await typeInto(page, 'r', '1.5');
  await expect(voice).toHaveText('r 1.5. Now tangent: one double root, the ray touches, t₁ 4.');
  await box(page, 'r').press('ArrowUp');
  await expect(voice).toContainText('r 1.55. Now two points');
});

test('the scene is described in words that are true', async ({ page }) => {
  await open(page, '#/explore?shape=cylinder&C=0,0,0&r=2.5&E=4,1,1.5&d=-1,0,0&method=exact');
  await page.locator('canvas').waitFor();
  const words = page.locator('.scene-description').first();
  await expect(words).toContainText('two points: the ray enters, then leaves');
  await expect(words).toContainText('t₁ = 2, first hit, enters, at (2, 1, 1.5)');
});

test('every command says what it did, or moves the focus', async ({ page }) => {
  await withoutScene(page);
  // The pause before the voice is no part of this.
  await page.addInitScript(() => {
    const { setTimeout } = window;
    const soon = (run: TimerHandler, ms?: number, ...given: unknown[]) =>
      setTimeout(run, ms === 500 ? 0 : ms, ...given);
    // Sound is rendered into a buffer, all at once.
    class Silent extends OfflineAudioContext {
      constructor() {
        super(1, 8 * 16_000, 16_000);
        Object.assign(window, { sound: this });
      }
      close = () => Promise.resolve();
    }
    Object.assign(window, { setTimeout: soon, AudioContext: Silent });
  });
  await open(page, '#/explore?shape=cone&E=4,1,0.5&d=-1,0,0');
  const heard = new Map<string, string>();
  const commands = commandsOf({ dispatch() {}, get() {} } as never, {} as never);
  for (const { id, keys, pages } of commands) {
    if (pages && !pages.includes('explore')) continue;
    const key = (keys[0] ?? '').replace('Ctrl', 'Control').replace(/^\?$/, 'Shift+?');
    await page.evaluate(() => {
      (document.activeElement as HTMLElement | null)?.blur();
      // Its code comes late: until then nothing was said.
      document.querySelector('.announcer')?.replaceChildren();
    });
    const chooser = id === 'open' ? page.waitForEvent('filechooser') : null;
    const popup = id === 'present-explore' ? page.waitForEvent('popup') : null;
    await page.keyboard.press(key);
    await (await popup)?.close();
    if (chooser) await chooser;
    else {
      const words = await page.waitForFunction(() => {
        const said = document.querySelector('.announcer')?.textContent;
        const at = document.activeElement;
        return said || (at && at !== document.body ? `focus: ${at.tagName}` : '');
      });
      heard.set(id, await words.jsonValue());
    }
    // A dialog, the black screen, the derivation: what has the focus now is left again.
    await page.keyboard.press('Escape');
    await expect(page.locator('dialog[open]')).toHaveCount(0);
  }
  expect(heard.get('link')).toMatch(/link/);
  expect(heard.get('theme')).toBe('theme: light.');
  expect(heard.get('ghost')).toContain('kept as a ghost');
  expect(heard.get('play')).toContain('not while results are hidden');
  expect(heard.get('present-explore')).toBe('The presenter’s window is open.');
  expect(heard.get('next')).toMatch(/^Example \d+ of \d+: /);

  // A full screen withdraws the controls.
  await page.evaluate(() => document.exitFullscreen().catch(() => {}));
  // Heard: t from 0 to the end in six seconds; the roots are 2 and 6, inside between them.
  await open(page, '#/explore?shape=cylinder&C=0,0,0&r=2.5&E=4,1,1.5&d=-1,0,0');
  if (await page.getByRole('button', { name: 'show results' }).isVisible()) {
    await page.keyboard.press('h');
  }
  await page.keyboard.press('m');
  const button = page.getByRole('button', { name: 'hear' });
  await expect(button).toHaveAttribute('aria-pressed', 'true');
  await expect(page.locator('.announcer')).toHaveText(/^The ray sounds from t 0 to \d/);
  // The key that stops it does nothing else.
  await page.keyboard.press('3');
  await expect(button).toHaveAttribute('aria-pressed', 'false');
  await expectInLink(page, { shape: 'cylinder' });
  const to = Number(await page.locator('[data-quantity="bead.t"]').getAttribute('data-value'));
  expect(to).toBeGreaterThanOrEqual(0);
  const heardAt = await page.evaluate(async () => {
    const { sound } = window as unknown as { sound: OfflineAudioContext };
    const samples = (await sound.startRendering()).getChannelData(0);
    const rate = sound.sampleRate;
    /** Loudness and pitch, by crossings of zero, in twentieths of a second. */
    return Array.from({ length: 6 * 20 }, (_, i) => {
      const part = samples.slice(((0.15 + i / 20) * rate) | 0, ((0.15 + (i + 1) / 20) * rate) | 0);
      const loud = Math.hypot(...part) / Math.sqrt(part.length);
      const crossings = part.filter((x, k) => x > 0 && (part[k - 1] ?? 0) <= 0).length;
      return { loud, hertz: crossings * 20 };
    });
  });
  const isLoud = heardAt.map(({ loud }) => loud > 0.01);
  const first = isLoud.indexOf(false);
  const last = isLoud.lastIndexOf(false, 110);
  expect(first).toBeGreaterThan(5);
  expect(isLoud.slice(first, last).filter(Boolean).length, 'silence inside').toBeLessThan(3);
  expect(last - first).toBeGreaterThan(20);
  // It comes down to the steady tone, and goes up from it again.
  const mean = (from: number, to: number): number =>
    heardAt.slice(from, to).reduce((sum, { hertz }) => sum + hertz, 0) / (to - from);
  expect(mean(0, 4)).toBeGreaterThan(1.2 * mean(first - 5, first - 1));
  expect(heardAt.length).toBe(120);
});

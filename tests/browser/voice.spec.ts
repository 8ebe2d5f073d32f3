import { commandsOf } from '../../src/pages/commands.ts';
import { box, typeInto } from './support/controls.ts';
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
    Object.assign(window, { setTimeout: soon });
  });
  await open(page, '#/explore?shape=cone&E=4,1,0.5&d=-1,0,0');
  const heard = new Map<string, string>();
  const commands = commandsOf({ dispatch() {}, get() {} } as never, {} as never);
  for (const { id, keys, pages } of commands) {
    if (pages && !pages.includes('explore')) continue;
    const key = (keys[0] ?? '').replace('Ctrl', 'Control').replace(/^\?$/, 'Shift+?');
    await page.evaluate(() => {
      (document.activeElement as HTMLElement | null)?.blur();
      (document.querySelector('.announcer') as HTMLElement).textContent = '';
    });
    const chooser = id === 'open' ? page.waitForEvent('filechooser') : null;
    await page.keyboard.press(key);
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
  expect(heard.get('next')).toMatch(/^Example \d+ of \d+: /);
});

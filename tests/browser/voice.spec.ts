import type { Page } from '@playwright/test';
import { commandsOf } from '../../src/pages/commands.ts';
import { closerLook } from '../../src/state/closer-look.ts';
import { createDerive } from '../../src/state/derive.ts';
import { REFERENCE_HZ, type Score, scoreOf } from '../../src/state/hearing.ts';
import { INITIAL, PAGES } from '../../src/state/state.ts';
import { decode } from '../../src/state/url.ts';
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

/** The pause before the voice speaks is no part of a test. */
function withoutPause(): void {
  const { setTimeout } = window;
  const soon = (run: TimerHandler, ms?: number, ...given: unknown[]) =>
    setTimeout(run, ms === 500 ? 0 : ms, ...given);
  Object.assign(window, { setTimeout: soon });
}

test('every command says what it did, or moves the focus', async ({ page }) => {
  await withoutScene(page);
  await page.addInitScript(withoutPause);
  await page.addInitScript(() => {
    // Sound is rendered into a buffer, all at once.
    class Silent extends OfflineAudioContext {
      constructor() {
        super(1, 8 * 16_000, 16_000);
        Object.assign(window, { sound: this });
      }
      close = () => Promise.resolve();
    }
    Object.assign(window, { AudioContext: Silent });
  });
  await open(page, '#/explore?shape=cone&E=4,1,0.5&d=-1,0,0');
  const heard = new Map<string, string>();
  const commands = commandsOf({ dispatch() {}, get() {} } as never, {} as never);
  for (const { id, keys, pages } of commands) {
    if (pages && !pages.includes('explore')) continue;
    heard.set(id, await heardOf(page, id, keys));
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
  await open(page, HEARD);
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
  const samples = await page.evaluate(async () => {
    const { sound } = window as unknown as { sound: OfflineAudioContext };
    return [...(await sound.startRendering()).getChannelData(0)];
  });
  heardAsWritten(samples, scoreOf(createDerive(() => closerLook)(decode(HEARD, INITIAL)).graph));
});

/** What a command says, or what has got the focus. */
async function heardOf(page: Page, id: string, keys: readonly string[]): Promise<string> {
  const key = (keys[0] ?? '').replace('Ctrl', 'Control').replace(/^\?$/, 'Shift+?');
  await page.evaluate(() => {
    (document.activeElement as HTMLElement | null)?.blur();
    // Its code comes late: until then nothing was said.
    document.querySelector('.announcer')?.replaceChildren();
  });
  const chooser = id === 'open' ? page.waitForEvent('filechooser') : null;
  const popup = /^present/.test(id) ? page.waitForEvent('popup') : null;
  await page.keyboard.press(key);
  await (await popup)?.close();
  if (chooser) {
    await chooser;
    return 'a file is asked for';
  }
  const words = await page.waitForFunction(() => {
    const said = document.querySelector('.announcer')?.textContent;
    const at = document.activeElement;
    return said || (at && at !== document.body ? `focus: ${at.tagName}` : '');
  });
  const heard = await words.jsonValue();
  // A dialog, the black screen, the derivation: what has the focus now is left again.
  await page.keyboard.press('Escape');
  await expect(page.locator('dialog[open]')).toHaveCount(0);
  return heard;
}

test('so it does on every other page', async ({ page }) => {
  await page.addInitScript(withoutPause);
  await open(page, '#/explore');
  const commands = commandsOf({ dispatch() {}, get() {} } as never, {} as never);
  const show = (title: string): Promise<void> =>
    page.locator('.header').getByRole('link', { name: title, exact: true }).click();
  for (const { id, title } of PAGES) {
    if (id === 'explore') continue;
    await show(title);
    await page.locator('main h2').filter({ visible: true }).first().waitFor();
    const own = commands.filter(({ pages }) => pages?.includes(id));
    if (id === 'lesson') {
      // On the list there is nothing to go to.
      for (const { id: command, keys } of own) {
        const said = await heardOf(page, command, keys);
        if (command !== 'present') expect(said).toBe('No lesson is open: choose one.');
      }
      await page.locator('.lesson-list a[href^="#/lesson/"]').first().click();
      await page.locator('[data-lesson-step]').waitFor();
    }
    for (const { id: command, keys, pages } of commands) {
      if (pages && !pages.includes(id)) continue;
      const said = await heardOf(page, command, keys);
      if (command === 'collect') expect(said).toMatch(/added as step \d+ of your lesson/);
      if (command === 'lesson-next') expect(said).toMatch(/step 2 of \d+: /);
      // Undo may have left the page, and a full screen withdraws the controls.
      await page.evaluate(() => document.exitFullscreen().catch(() => {}));
      await show(title);
    }
  }
});

test('one voice on Check too: a verdict is said once, again where it is asked for again', async ({
  page,
}) => {
  await page.addInitScript(withoutPause);
  await withoutScene(page);
  await page.goto('./#/check?seed=41');
  const voice = page.locator('.announcer');
  const box = page.locator('.answers :is(input, select)').first();
  await box.waitFor();
  // All that is said, one after another.
  await page.evaluate(() => {
    const all: string[] = [];
    Object.assign(window, { all });
    const region = document.querySelector('.announcer') as Element;
    new MutationObserver(() => all.push(region.textContent ?? '')).observe(region, {
      childList: true,
    });
  });
  const check = page.getByRole('button', { name: 'Check', exact: true });
  await check.click();
  const unread = 'Not all of it could be read; this was no try.';
  await expect(voice).toHaveText(unread);
  await check.click();
  const said = () =>
    page.evaluate(
      (unread) =>
        (window as unknown as { all: string[] }).all.filter((one) => one.trim() === unread).length,
      unread,
    );
  await expect.poll(said).toBe(2);
  // Behind a dialog nothing is heard: the voice is in it, and comes back.
  await page.keyboard.press('Tab');
  await page.evaluate(() => (document.activeElement as HTMLElement | null)?.blur());
  await page.keyboard.press('e');
  await page.getByRole('dialog').getByRole('button', { name: 'Embed' }).click();
  const dialog = page.getByRole('dialog', { name: 'Embed' });
  for (const part of await dialog.getByRole('checkbox').all()) await part.uncheck();
  await expect(dialog.locator('.announcer')).toHaveText(/Nothing is shown: choose a part\./);
  await page.keyboard.press('Escape');
  await page.keyboard.press('l');
  await expect(page.locator('body > .announcer')).toHaveText(/link/);
  await expect(voice).toHaveCount(1);
});

const HEARD = '#/explore?shape=cylinder&C=0,0,0&r=2.5&E=4,1,1.5&d=-1,0,0';
const RATE = 16_000;
/** Seconds before it begins, and of a part that is listened to. */
const LEAD = 0.15;
const PART = 0.05;

/** How much of a tone is in these samples, as an amplitude (Goertzel). */
function amplitude(samples: readonly number[], hertz: number): number {
  const turn = (2 * Math.PI * hertz) / RATE;
  const [x, y] = [Math.cos, Math.sin].map((wave) =>
    samples.reduce((sum, sample, i) => sum + sample * wave(turn * i), 0),
  );
  return (2 * Math.hypot(x ?? 0, y ?? 0)) / samples.length;
}

/** Every twentieth of a second sounds as the score has it: pitch, steady tone, click, silence. */
function heardAsWritten(samples: readonly number[], { seconds, tones, clicks }: Score): void {
  expect(clicks).toHaveLength(2);
  let [told, silent] = [0, 0];
  for (let at = 0; at + PART <= seconds; at += PART) {
    const from = Math.round((LEAD + at) * RATE);
    const part = samples.slice(from, from + PART * RATE);
    const clicked = clicks.some((click) => click > at - PART && click < at + PART);
    // A click dies away within one part.
    if (!clicked) expect(amplitude(part, 1800), `no click at ${at}`).toBeLessThan(0.02);
    else if (clicks.some((click) => click >= at && click < at + PART / 2)) {
      expect(amplitude(part, 1800), `a click at ${at}`).toBeGreaterThan(0.02);
    }
    const tone = tones.find(({ begin, end }) => begin + PART <= at && end - PART >= at + PART);
    if (tone) {
      expect(amplitude(part, REFERENCE_HZ), `the steady tone at ${at}`).toBeGreaterThan(0.05);
      const middle = at + PART / 2;
      const pitch = tone.pitch.find((one) => one.at >= middle)?.hertz ?? 0;
      // Two tones that are closer than a part tells apart beat with each other.
      if (Math.abs(pitch - REFERENCE_HZ) < 2 / PART) continue;
      told += 1;
      // The pitch glides: its middle is the shorter, the better it is one tone.
      const middling = part.slice(part.length / 4, (3 * part.length) / 4);
      const loud = amplitude(middling, pitch);
      expect(loud, `${pitch} Hz at ${at}`).toBeGreaterThan(0.05);
      expect(amplitude(middling, 1.5 * pitch), `nothing above, at ${at}`).toBeLessThan(loud / 2);
    } else if (!clicked && tones.every(({ begin, end }) => end < at || begin > at + PART)) {
      silent += 1;
      expect(Math.max(...part.map(Math.abs)), `silence at ${at}`).toBeLessThan(1e-3);
    }
  }
  expect(told).toBeGreaterThan(20);
  expect(silent).toBeGreaterThan(20);
}

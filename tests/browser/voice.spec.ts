import type { Page } from '@playwright/test';
import { commandsOf } from '../../src/pages/commands.ts';
import { createDerive } from '../../src/state/derive.ts';
import { exploreDetails } from '../../src/state/explore-details.ts';
import type { GraphModel } from '../../src/state/graph-model.ts';
import { REFERENCE_HZ, type Score, scoreOf } from '../../src/state/sonification.ts';
import { INITIAL, PAGES } from '../../src/state/state.ts';
import { decode } from '../../src/state/url.ts';
import { byTurns } from '../unit/many.ts';
import { box, expectInLink, typeInto } from './support/controls.ts';
import { NO_SCENE, open, withoutScene } from './support/page.ts';
import { withoutPause } from './support/pending.ts';
import { expect, test } from './support/test.ts';

test.use({ provoked: NO_SCENE });

test('one voice: the value first, the consequence second, after a pause', async ({ page }) => {
  await withoutScene(page);
  await open(page, '#/explore?shape=cylinder&C=0,0,0&r=1.4&E=4,1,1.5&d=-1,0,0&method=exact');
  const voice = page.locator('.announcer');
  await expect(voice).toHaveCount(1);
  await expect(voice).toContainText('The picture could not be loaded.');
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
  heardAsWritten(samples, createDerive(() => exploreDetails)(decode(HEARD, INITIAL)).graph);
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

/** Keeps all that the voice says: without a pause one news may follow another at once. */
function keepSpoken(): void {
  const spoken: string[] = [];
  Object.assign(window, { spoken });
  new MutationObserver((records) => {
    for (const { target } of records) {
      const at = target instanceof Element ? target : target.parentElement;
      const words = at?.closest('.announcer')?.textContent;
      if (words) spoken.push(words);
    }
  }).observe(document, { subtree: true, childList: true, characterData: true });
}

const spokenOn = (page: Page): Promise<string> =>
  page.evaluate(() => (window as unknown as { spoken: string[] }).spoken.splice(0).join('\n'));

test('so it does on every other page', async ({ page }) => {
  await page.addInitScript(withoutPause);
  await page.addInitScript(keepSpoken);
  await open(page, '#/explore');
  const commands = commandsOf({ dispatch() {}, get() {} } as never, {} as never);
  const show = (title: string): Promise<void> =>
    page.locator('.header').getByRole('link', { name: title, exact: true }).click();
  let turn = 0;
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
    // Those of several pages by turns.
    const shared = commands.filter(
      ({ pages }) => !pages || (pages.length > 1 && pages.includes(id)),
    );
    turn += 1;
    for (const { id: command, keys } of [
      ...own.filter((one) => !shared.includes(one)),
      ...byTurns(shared, turn, 3),
    ]) {
      await spokenOn(page);
      await heardOf(page, command, keys);
      const says = { collect: /added as step \d+ of your/, 'lesson-next': /step 2 of \d+: / };
      const wanted = Object.hasOwn(says, command) ? says[command as keyof typeof says] : null;
      let spoken = '';
      if (wanted) {
        await expect.poll(async () => (spoken += `${await spokenOn(page)}\n`)).toMatch(wanted);
      }
      // Undo may have left the page, and a full screen withdraws the controls.
      await page.evaluate(() => document.exitFullscreen().catch(() => {}));
      await show(title);
    }
  }
});

test.describe('on Accuracy', () => {
  test.use({ idle: true });
  test('the answer is said, and not the question in its place before', async ({ page }) => {
    await page.addInitScript(withoutPause);
    await page.addInitScript(keepSpoken);
    await page.goto('./#/accuracy');
    let spoken = '';
    const answer = 'the textbook formula';
    await expect.poll(async () => (spoken += await spokenOn(page))).toContain(answer);
    expect(spoken).not.toContain('What does a right answer cost?');
  });
});

test('one voice on Check too: a verdict is said once, again where it is asked for again', async ({
  page,
}) => {
  await page.addInitScript(withoutPause);
  await page.addInitScript(keepSpoken);
  await withoutScene(page);
  await page.goto('./#/check?seed=41');
  const voice = page.locator('.announcer');
  const box = page.locator('.answers :is(input, select)').first();
  await box.waitFor();
  const check = page.getByRole('button', { name: 'Check', exact: true });
  await check.click();
  const unread = 'Not all of it could be read; this was no try.';
  await expect(voice).toHaveText(unread);
  const said: string[] = [];
  const times = async (): Promise<number> => {
    said.push(...(await spokenOn(page)).split('\n'));
    return said.filter((one) => one.trim() === unread).length;
  };
  expect(await times()).toBe(1);
  await check.click();
  await expect.poll(times).toBe(2);
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
  expect(await times()).toBe(2);
});

const HEARD = '#/explore?shape=cylinder&C=0,0,0&r=2.5&E=4,1,1.5&d=-1,0,0';
const RATE = 16_000;
/** Seconds before it begins. */
const LEAD = 0.15;
/** A click's tone in Hz, its length in s, and its mean loudness against the pitch's. */
const CLICK = { hertz: 1800, seconds: 0.03, loud: 0.45 / 0.4 };
/** A wrong pitch that is to be noticed at least. */
const OFF = 0.015;

type Wave = (i: number) => number;

/** Both waves of a tone, which make it in any phase. */
const wavesOf = (hertz: number): Wave[] =>
  [Math.cos, Math.sin].map((wave) => (i) => wave((2 * Math.PI * hertz * i) / RATE));

interface Fit {
  /** Amplitude of each tone. */
  readonly amplitudes: readonly number[];
  /** The part of the energy that the tones leave. */
  readonly left: number;
}

/** The tones of these frequencies that come nearest to the samples (least squares). */
function tonesIn(samples: readonly number[], hertz: readonly number[]): Fit {
  let rest = [...samples];
  const waves = hertz.flatMap(wavesOf).map((wave) => samples.map((_, i) => wave(i)));
  const dot = (a: readonly number[], b: readonly number[]): number =>
    a.reduce((sum, x, i) => sum + x * (b[i] ?? 0), 0);
  // Gram and Schmidt, then the amplitudes from the last wave to the first.
  const basis: { wave: number[]; parts: number[] }[] = [];
  for (const wave of waves) {
    const parts = basis.map((one) => dot(wave, one.wave));
    const own = wave.map((x, i) => x - parts.reduce((sum, c, j) => sum + c * at(j, i), 0));
    const length = Math.sqrt(dot(own, own)) || 1;
    basis.push({ wave: own.map((x) => x / length), parts: [...parts, length] });
  }
  function at(j: number, i: number): number {
    return basis[j]?.wave[i] ?? 0;
  }
  const along = basis.map(({ wave }) => {
    const part = dot(rest, wave);
    rest = rest.map((x, i) => x - part * (wave[i] ?? 0));
    return part;
  });
  const weights: number[] = [];
  for (let j = basis.length - 1; j >= 0; j--) {
    const later = weights.reduce((sum, w, k) => sum + w * (basis[k]?.parts[j] ?? 0), 0);
    weights[j] = ((along[j] ?? 0) - later) / (basis[j]?.parts[j] ?? 1);
  }
  const amplitudes = hertz.map((_, k) => Math.hypot(weights[2 * k] ?? 0, weights[2 * k + 1] ?? 0));
  return { amplitudes, left: dot(rest, rest) / (dot(samples, samples) || 1) };
}

/**
 * What is not as the score has it: in each of its steps the pitch of f beside the steady tone, at
 * each hit a click and nowhere else, and silence between the tones. How far a pitch may be off
 * follows from the step: what a tone that is off by OFF would leave in it.
 */
function faultsOf(
  samples: readonly number[],
  { seconds, tones, clicks }: Score,
  hertzAt: (at: number) => number,
): string[] {
  const faults: string[] = [];
  const part = (from: number, to: number): number[] =>
    samples.slice(Math.ceil((LEAD + from) * RATE), Math.floor((LEAD + to) * RATE));
  const steady: number[] = [];
  let loudest = 0;
  for (const { pitch } of tones) {
    // It comes and goes within the first step and the last.
    for (let i = 1; i + 2 < pitch.length; i++) {
      const [from, to] = [pitch[i]?.at ?? 0, pitch[i + 1]?.at ?? 0];
      if (clicks.some((click) => click < to && click + CLICK.seconds > from)) continue;
      const heard = part(from, to);
      const hertz = hertzAt(from);
      const { amplitudes, left } = tonesIn(heard, [REFERENCE_HZ, hertz]);
      const lefts = [1 - OFF, 1 + OFF].map((by) => {
        const [wave] = wavesOf(hertz * by);
        const [low] = wavesOf(REFERENCE_HZ);
        const wrong = heard.map((_, j) => 0.4 * (wave?.(j) ?? 0) + 0.3 * (low?.(j) ?? 0));
        return tonesIn(wrong, [REFERENCE_HZ, hertz]).left;
      });
      if (heard.every((x) => x === 0)) faults.push(`no tone at ${from}`);
      else if (left > Math.min(...lefts)) faults.push(`no ${hertz} Hz at ${from}`);
      // Two tones that are closer than a step tells apart beat with each other.
      if (Math.abs(hertz - REFERENCE_HZ) < 1 / (to - from)) continue;
      steady.push(amplitudes[0] ?? 0);
      loudest = Math.max(loudest, amplitudes[1] ?? 0);
    }
  }
  const [least, most] = [Math.min(...steady), Math.max(...steady)];
  if (!(least > loudest / 2 && most - least < OFF * most)) faults.push('no steady tone');
  for (let from = 0; from + CLICK.seconds <= seconds; from += CLICK.seconds / 3) {
    const to = from + CLICK.seconds;
    const heard = part(from, to);
    const [amplitude = 0] = tonesIn(heard, [CLICK.hertz]).amplitudes;
    const isClicked = clicks.some((click) => click < to && click + CLICK.seconds > from);
    const isWhole = clicks.some((click) => Math.abs(click - from) <= CLICK.seconds / 6);
    if (isWhole && amplitude < (CLICK.loud * loudest) / 2) faults.push(`no click at ${from}`);
    if (!isClicked && amplitude > loudest / 10) faults.push(`a click at ${from}`);
    const isSilent = tones.every(({ begin, end }) => end <= from || begin >= to);
    if (isSilent && !isClicked && heard.some((x) => Math.abs(x) > 1e-6)) {
      faults.push(`no silence at ${from}`);
    }
  }
  return faults;
}

/** The sound is the score, and another score would be noticed. */
function heardAsWritten(samples: readonly number[], graph: GraphModel): void {
  const score = scoreOf(graph);
  const { A, B, C, low, high } = graph;
  const { seconds, from, to, tones, clicks } = score;
  // f at t, as the page says it: an octave is 0.15 of the largest |f| in the graph.
  const half = 0.15 * Math.max(Math.abs(low), Math.abs(high));
  const hertzAt = (at: number): number => {
    const t = from + ((to - from) * at) / seconds;
    const f = (A * t + B) * t + C;
    return REFERENCE_HZ * 2 ** ((2 * f) / (Math.abs(f) + half));
  };
  expect(clicks).toHaveLength(2);
  expect(tones).toHaveLength(2);
  expect(faultsOf(samples, score, hertzAt)).toEqual([]);
  const others: readonly [fault: RegExp, other: Score, by: number][] = [
    [/^no \d.* Hz/, score, 1.03],
    [/^no \d.* Hz/, score, 1 / 1.03],
    [/^no click/, { ...score, clicks: [...clicks, seconds / 2] }, 1],
    [/^a click/, { ...score, clicks: clicks.slice(1) }, 1],
    [/^no silence/, { ...score, tones: tones.slice(1) }, 1],
    [/^no tone/, { ...score, tones: [...tones, spread(score, tones[0])] }, 1],
  ];
  for (const [fault, other, by] of others) {
    const faults = faultsOf(samples, other, (at) => by * hertzAt(at));
    expect(
      faults.filter((one) => fault.test(one)),
      `${fault}`,
    ).not.toEqual([]);
  }
}

/** A tone where the score has its silence, with the steps of another. */
function spread({ clicks }: Score, tone: Score['tones'][number] | undefined) {
  const [begin = 0, end = 0] = clicks;
  const pitch = tone?.pitch ?? [];
  const last = pitch.at(-1)?.at ?? 1;
  const moved = pitch.map(({ at, hertz }) => ({ at: begin + ((end - begin) * at) / last, hertz }));
  return { begin, end, pitch: moved };
}

import type { Page } from '@playwright/test';
import { integer, pick, type Random, seeded, uniform } from '../../src/math/rng.ts';
import { GALLERY } from '../../src/state/gallery/index.ts';

/** What a person, a cat or a broken program types into a box. */
const TYPED = [
  '1/3',
  'sqrt(2)',
  '-2^-40',
  '1e7',
  '1e308',
  '5e-324',
  '0',
  '-0',
  '0,5',
  '−3',
  '1, 2, 3',
  '(0; 0; 0)',
  '1e999',
  'abc',
  '',
  ' ',
  '1/0',
  '0/0',
  '__proto__',
  '<img src=x onerror=alert(1)>',
  '((((((((',
  '9'.repeat(300),
] as const;

const KEYS: readonly [string, ...string[]] = [
  '1',
  ...'23456hngbx?letsR',
  'PageDown',
  'PageUp',
  'ArrowLeft',
  'ArrowRight',
  'ArrowUp',
  'ArrowDown',
  'Shift+ArrowUp',
  'Tab',
  'Shift+Tab',
  'Enter',
  'Escape',
  'Home',
  'End',
  'Control+z',
  'Control+z',
  'Control+Shift+z',
  '+',
  '-',
];

const LINKS = [
  '#/explore',
  '#',
  '#/nowhere',
  '#/explore?shape=torus&E=1,2',
  '#/explore?shape=cone&V=abc&c=1e400',
  '#/explore?shape=cylinder&r=-1&d=0,0,0',
  '#/explore?shape=hyperboloid&a=-1e300&r=1e-300&E=1e300,-1e300,5e-324',
  '#/explore?shape=circle&N=0,0,0&r=1e999',
  '#/explore?%E0%A4%A&=&&&shape',
  '#/explore?shape=plane&N=1e-320,0,0&E=1e308,1e308,-1e308&d=1e308,1e308,1e308',
  '#/explore?shape=square&axis=w&L=0&t=Infinity&view=1,2',
] as const;

type Deed = (page: Page, random: Random) => Promise<string>;

/** A control that is covered is missed; how long a click waits for it, in ms. */
const PATIENCE = { timeout: 500, noWaitAfter: true } as const;

/** Each deed says what it did, so that a failure can be read. */
const DEEDS: readonly [Deed, ...Deed[]] = [
  async (page, random) => {
    const key = pick(random, KEYS);
    await page.keyboard.press(key);
    return `key ${key}`;
  },
  async (page, random) => {
    const buttons = page.locator('button:visible');
    const n = await buttons.count();
    const button = buttons.nth(integer(random, 0, Math.max(n - 1, 0)));
    // A button that went meanwhile is missed: without a limit this would wait for it for ever.
    const name = await button.evaluate(
      (b) => b.getAttribute('aria-label') ?? b.textContent,
      undefined,
      PATIENCE,
    );
    await button.click(PATIENCE);
    return `button ${name?.trim().slice(0, 40)}`;
  },
  async (page, random) => {
    const boxes = page.locator('graze-number input:visible');
    const box = boxes.nth(integer(random, 0, Math.max((await boxes.count()) - 1, 0)));
    const text = pick(random, TYPED);
    await box.fill(text, PATIENCE);
    await box.press(pick(random, ['Enter', 'Tab', 'Escape', 'ArrowUp'] as const), PATIENCE);
    return `typed ${text.slice(0, 30)}`;
  },
  async (page, random) => {
    const { x, y, w, h } = await sceneBox(page);
    const from = [x + uniform(random, 0.05, 0.95) * w, y + uniform(random, 0.1, 0.95) * h] as const;
    await page.mouse.move(...from);
    await page.mouse.down();
    for (let i = 0; i < 4; i++) {
      await page.mouse.move(
        from[0] + uniform(random, -200, 200),
        from[1] + uniform(random, -150, 150),
      );
    }
    await page.mouse.up();
    return `drag in the scene from ${from.map(Math.round)}`;
  },
  async (page, random) => {
    const sliders = page.locator('input[type=range]:visible');
    const slider = sliders.nth(integer(random, 0, Math.max((await sliders.count()) - 1, 0)));
    const box = await slider.boundingBox(PATIENCE);
    if (!box) return 'no slider';
    await page.mouse.move(box.x + uniform(random, 0, 1) * box.width, box.y + box.height / 2);
    await page.mouse.down();
    await page.mouse.move(box.x + uniform(random, -0.3, 1.3) * box.width, box.y + box.height / 2);
    await page.mouse.up();
    return 'drag a slider';
  },
  async (page, random) => {
    const { x, y, w, h } = await sceneBox(page);
    await page.mouse.move(x + w * random(), y + h * random());
    await page.mouse.wheel(0, uniform(random, -600, 600));
    return 'wheel';
  },
  async (page, random) => {
    const link =
      random() < 0.5
        ? pick(random, LINKS)
        : (GALLERY[integer(random, 0, GALLERY.length - 1)]?.link ?? '#');
    await page.evaluate((hash) => {
      location.hash = hash;
    }, link);
    return `link ${link}`;
  },
  async (page, random) => {
    const handles = page.locator('[data-handle]:visible');
    const n = await handles.count();
    if (n === 0) return 'no handle';
    const box = await handles.nth(integer(random, 0, n - 1)).boundingBox(PATIENCE);
    if (!box) return 'no handle';
    await page.mouse.move(box.x + box.width / 2, box.y + box.height / 2);
    await page.mouse.down();
    await page.mouse.move(box.x + uniform(random, -300, 300), box.y + uniform(random, -300, 300), {
      steps: 3,
    });
    if (random() < 0.3) await page.keyboard.press('Escape');
    await page.mouse.up();
    return 'drag a handle';
  },
  async (page, random) => {
    const { x, y, w, h } = await sceneBox(page);
    await page.touchscreen.tap(x + w * random(), y + h * random());
    return 'tap';
  },
];

async function sceneBox(page: Page): Promise<{ x: number; y: number; w: number; h: number }> {
  const box = await page.locator('.scene-area').boundingBox(PATIENCE);
  return { x: box?.x ?? 0, y: box?.y ?? 0, w: box?.width ?? 100, h: box?.height ?? 100 };
}

interface Fuzzed {
  readonly done: number;
  /** What was wrong, with the deeds that led there; null if nothing was. */
  readonly failure: string | null;
}

/** Things that a page must not do on its own while a program is at it. */
export async function prepare(page: Page): Promise<void> {
  await page.addInitScript(() => {
    window.print = () => undefined;
    Element.prototype.requestFullscreen = () => Promise.reject(new Error('not here'));
  });
}

/**
 * Does `actions` random things with this seed and asks `check` every so often. A deed that finds
 * its control gone or covered is no fault: people miss, too.
 */
export async function randomUser(
  page: Page,
  { seed, actions, every }: { seed: number; actions: number; every: number },
  check: () => Promise<string | null>,
  progress: (done: number) => void = () => undefined,
): Promise<Fuzzed> {
  const random = seeded(seed);
  const log: string[] = [];
  for (let done = 1; done <= actions; done++) {
    const deed = pick(random, DEEDS);
    log.push(
      await deed(page, random).catch((error: Error) => `missed: ${error.message.split('\n')[0]}`),
    );
    if (done % every !== 0) continue;
    const wrong = await check();
    if (wrong)
      return {
        done,
        failure: `${wrong}\nafter (seed ${seed}):\n  ${log.slice(-2 * every).join('\n  ')}`,
      };
    progress(done);
  }
  return { done: actions, failure: null };
}

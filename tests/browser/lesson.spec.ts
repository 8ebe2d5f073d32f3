import type { Page } from '@playwright/test';
import { question } from '../../src/check/session.ts';
import type { Step } from '../../src/lesson/lesson.ts';
import { type Prose, quantitiesIn } from '../../src/lesson/prose.ts';
import { GALLERY } from '../../src/state/gallery/index.ts';
import { rayOf, shapeOf } from '../../src/state/state.ts';
import { decode } from '../../src/state/url.ts';
import { shortest } from '../../src/text/format.ts';
import { byTurns } from '../unit/many.ts';
import { BUT_CONTRAST, violations, violationsInThemes } from './support/axe.ts';
import { expected } from './support/expected.ts';
import { extent } from './support/layout.ts';
import { computed, LESSONS, lessonOf, liveNumbers, openStep, stepShown } from './support/lesson.ts';
import { problems, settle } from './support/page.ts';
import { framesDone } from './support/pending.ts';
import { expect, test as fresh, visit as test } from './support/test.ts';
import { showTheme } from './support/theme.ts';

test.describe.configure({ mode: 'default' });

const asked = (page: Page) => page.getByRole('form', { name: 'Question' });
const column = (page: Page) => page.locator('.lesson-column');

/** A number that the page beside has for an effect, as a text may write it. */
async function writtenOf(page: Page, effect: string, quantity: string): Promise<RegExp> {
  const cell = page.locator(
    `.lesson-other [data-effect="${effect}"] [data-quantity="${quantity}"]`,
  );
  const value = (await cell.getAttribute('data-value')) ?? '';
  expect(value).toMatch(/^\d{4,}$/);
  return new RegExp(value.replace(/\B(?=(\d{3})+$)/g, '\\s'));
}

/** Each live number of this prose is there, with the value that is computed or shown beside it. */
async function numbersAreRight(page: Page, step: Step, prose: Prose): Promise<void> {
  await framesDone(page);
  const names = quantitiesIn(prose.filter(({ when }) => when.length === 0));
  for (const name of names.filter((one) => one !== 'slider')) {
    // What another page traces or measures comes when it is there.
    await expect(column(page).locator(`[data-quantity="${name}"]`).first()).toBeVisible();
  }
  const { text, beside } = await liveNumbers(page);
  const isExplore = decode(step.link).page === 'explore';
  // A question about what is free leads to the value that it asks for.
  if (isExplore && step.guess?.type === 'free') return;
  expect(text).toEqual(isExplore ? computed(step, Object.keys(text)) : beside);
}

/** Graze's front page, where a lesson is looked for. */
async function frontPage(page: Page): Promise<void> {
  await page.goto('./');
  await page.locator('[data-quantity="class"]').waitFor();
}

/** A question of Check that a step ends with, and what answers it. */
function posedBy({ link }: Step): { id: string; kind: string; text: string }[] {
  const { seed, question: number, set } = decode(link).settings.check;
  const settings = new URLSearchParams(link.split('?')[1]);
  const posed = question(
    Number(seed ?? settings.get('seed')),
    Number(number ?? settings.get('question')) - 1,
    set ?? undefined,
  );
  return posed.fields.map(({ id, kind }) => {
    const truth = posed.truth[id];
    return { id, kind, text: typeof truth === 'number' ? shortest(truth) : String(truth) };
  });
}

const BY_KEYS = 'ray';
const BY_TOUCH = 'discriminant';

test.describe('by a clicker', () => {
  // A lesson speaks of what is measured.
  test.use({ idle: true });
  for (const { id, title, steps } of LESSONS) {
    if (id === BY_KEYS || id === BY_TOUCH) continue;
    test(`${title}: its numbers are those of the math module`, async ({ page }) => {
      await page.goto(`./#/lesson/${id}`);
      for (const [i, step] of steps.entries()) {
        await stepShown(page, i + 1);
        const head = { level: 2, name: step.title, exact: true };
        await expect(page.getByRole('heading', head)).toBeVisible();
        if (step.guess !== null) {
          await expect(asked(page)).toBeVisible();
          await numbersAreRight(page, step, step.question);
          expect(Object.keys((await liveNumbers(page)).text)).not.toContain('t1');
          await page.keyboard.press('PageDown');
          await expect(page.getByRole('region', { name: 'Answer' })).toBeVisible();
        }
        await numbersAreRight(page, step, [...step.text, ...step.answer]);
        await page.keyboard.press('PageDown');
      }
      await stepShown(page, steps.length);
    });
  }
});

test('a whole lesson by keyboard alone', async ({ page }) => {
  const { title, steps } = lessonOf(BY_KEYS);
  await frontPage(page);
  const tabTo = async (selector: string): Promise<void> => {
    for (let i = 0; i < 60; i += 1) {
      if (await page.evaluate((css) => document.activeElement?.matches(css), selector)) return;
      await page.keyboard.press('Tab');
    }
    throw new Error(`no Tab leads to ${selector}`);
  };
  await tabTo('.tab[href^="#/lesson"]');
  await page.keyboard.press('Enter');
  await expect(page.getByRole('link', { name: title })).toBeVisible();
  await tabTo(`a[href="#/lesson/${BY_KEYS}"]`);
  await page.keyboard.press('Enter');
  await stepShown(page, 1);
  await expect(page.locator('.announcer')).toContainText(`step 1 of ${steps.length}: `);
  for (const [i, step] of steps.entries()) {
    await stepShown(page, i + 1);
    await expect(page.getByRole('heading', { level: 2, name: step.title })).toBeVisible();
    if (step.guess) {
      await numbersAreRight(page, step, step.question);
      await tabTo('.guess-box');
      await page.keyboard.type('3.6');
      await page.keyboard.press('Enter');
      await expect(
        page.getByRole('heading', { name: 'Your guess 3.6: too large by 1.8' }),
      ).toBeVisible();
      await expect(column(page)).toContainText('(−B ± √D)/A in place of (−B ± √D)/2A');
      // Back takes the answer away again, forward shows it.
      const t1 = page.locator('.lesson-answer [data-quantity="t1"]');
      await page.keyboard.press('PageUp');
      await expect(asked(page)).toBeVisible();
      await expect(t1).toHaveCount(0);
      await page.keyboard.press('PageDown');
      await expect(t1).toHaveAttribute('data-value', '1.8');
    }
    await numbersAreRight(page, step, [...step.text, ...step.answer]);
    if (step.free) {
      await tabTo('.lesson-slider input');
      for (let j = 0; j < 3; j += 1) await page.keyboard.press('ArrowLeft');
      await expect(page).toHaveURL(/step=5&r=/);
    }
    // Also on the slider a clicker's key turns.
    if (i + 1 < steps.length) await page.keyboard.press('PageDown');
  }
  // The last step asks for the whole derivation.
  const state = decode(steps.at(-1)?.link ?? '');
  const own = expected(shapeOf(state), rayOf(state), 'exact');
  await expect(page.getByRole('heading', { name: 'Own numbers', exact: true })).toBeVisible();
  for (const name of ['A', 'B', 'C', 'D', 't1', 't2']) {
    await tabTo(`.own [data-field="${name}"] input`);
    await page.keyboard.type(own[name] ?? '');
  }
  await page.keyboard.press('Enter');
  const verdict = page.locator('.own .feedback');
  await expect(verdict).toHaveAttribute('data-verdict', 'correct');
  await expect(page.locator('.announcer')).toContainText('right');
});

test.describe('by touch alone', () => {
  test.use({ viewport: { width: 390, height: 844 }, hasTouch: true });
  test('a whole lesson on a phone', async ({ page }) => {
    const { title, steps } = lessonOf(BY_TOUCH);
    const top = (selector: string): Promise<number> =>
      page.locator(selector).evaluate((element) => element.getBoundingClientRect().top);
    const swipeUp = async (): Promise<void> => {
      const client = await page.context().newCDPSession(page);
      const touch = (type: 'touchStart' | 'touchMove' | 'touchEnd', at: readonly number[]) =>
        client.send('Input.dispatchTouchEvent', {
          type,
          touchPoints: at.map((y) => ({ x: 200, y })),
        });
      await touch('touchStart', [700]);
      for (let y = 690; y >= 500; y -= 10) await touch('touchMove', [y]);
      await touch('touchEnd', []);
      await settle(page);
    };
    const hand = page.getByRole('button', { name: 'That is my guess' });
    await frontPage(page);
    await page.locator('.header').getByRole('link', { name: 'Lessons' }).tap();
    await page.getByRole('link', { name: title }).tap();
    for (const [i, step] of steps.entries()) {
      await stepShown(page, i + 1);
      if (step.guess) await numbersAreRight(page, step, step.question);
      if (step.guess?.type === 'class') {
        await page.getByRole('radio', { name: 'one double root' }).tap();
        await hand.tap();
        await expect(
          page.locator('main').getByText('Your guess, one double root: it is no point'),
        ).toBeVisible();
      }
      if (step.guess?.type === 'free') {
        // The mark is put on the slider; the scene stays on top while the text is moved.
        const before = await top('.lesson-text');
        await swipeUp();
        expect(await top('.lesson-text')).toBeLessThan(before);
        expect(await top('.lesson-scene')).toBe(0);
        const track = await page.locator('.lesson-slider input').boundingBox();
        if (!track) throw new Error('no slider');
        const { x, y, width, height } = track;
        await page.touchscreen.tap(x + width / 2, y + height / 2);
        await expect(page.locator('.guess-box')).not.toHaveValue('');
        await hand.tap();
        await expect(page.locator('main').getByText(/^Your guess \S+: too large by/)).toBeVisible();
      } else await numbersAreRight(page, step, [...step.text, ...step.answer]);
      if (i + 1 < steps.length) await page.getByRole('button', { name: 'Next' }).tap();
    }
    const last = steps.at(-1);
    for (const { id, kind, text } of last ? posedBy(last) : []) {
      const field = page.locator(`.answers [data-field="${id}"] :is(input, select)`);
      await field.tap();
      // The phone's own list, and its own keys.
      if (kind === 'choice') await field.selectOption(text);
      else await page.keyboard.insertText(text);
    }
    await page.getByRole('button', { name: 'Check', exact: true }).tap();
    await expect(page.locator('.feedback').first()).toHaveAttribute('data-verdict', 'correct');
    await page.getByRole('link', { name: 'All lessons' }).tap();
    await expect(page.getByRole('heading', { name: 'Lessons', exact: true })).toBeVisible();
  });
});

test('the first visit and the gallery lead to the first lesson', async ({ page }) => {
  await page.goto('./');
  await page.getByRole('link', { name: 'First lesson' }).click();
  await stepShown(page, 1);
  await page.goto('./#/explore');
  await page.locator('.example-name').click();
  await page.getByRole('link', { name: 'Begin with the first lesson' }).click();
  await stepShown(page, 1);
  await expect(page.getByRole('dialog')).toHaveCount(0);
});

test('what is moved, asked and answered is in the link, and comes back by it', async ({ page }) => {
  await page.goto('./#/lesson/ray?step=5&r=0.5');
  await expect(page.locator('main').getByText('there is no root')).toBeVisible();
  await openStep(page, '#/lesson/ray?step=4&guess=1.8', 4);
  await expect(page.locator('main').getByText('Your guess 1.8: right')).toBeVisible();
  // A page beside an open question is out of sight, and comes with the answer.
  await openStep(page, '#/lesson/effects?step=2', 2);
  await expect(page.locator('.picture')).toHaveAttribute('data-trace', 'finished');
  await expect(page.locator('.picture canvas').first()).toBeHidden();
  await expect(column(page)).not.toContainText(await writtenOf(page, 'shadow', 'rays'));
  await openStep(page, '#/lesson/effects?step=2&guess=1000', 2);
  await expect(page.locator('main').getByText(/^Your guess 1000: too small by/)).toBeVisible();
  await expect(page.locator('.picture canvas').first()).toBeVisible();
  // A step of Accuracy shows what it speaks of, and nothing else of that page.
  await openStep(page, '#/lesson/digits?step=3', 3);
  await expect(page.getByRole('heading', { name: 'This ray' })).toBeVisible();
  await expect(page.getByRole('heading', { name: 'How hard can it get' })).toBeHidden();
  await openStep(page, '#/lesson/digits?step=5', 5);
  await expect(page.getByRole('heading', { name: 'How hard can it get' })).toBeVisible();
  await expect(page.getByRole('heading', { name: 'This ray' })).toBeHidden();
  await page.goto('./#/lesson/nothing');
  await expect(problems(page)).toContainText("there is no lesson 'nothing'");
});

test('a symbol in the text has its colour, and lights up with the scene', async ({ page }) => {
  await page.goto('./#/lesson/ray?step=5');
  const inText = page.locator('.lesson-text math [data-symbol="t1"]').first();
  const live = page.locator('.lesson-text [data-quantity="t1"]');
  const mark = page.locator('.lesson-scene [data-symbol~="t1"]').first();
  await expect(mark).toBeAttached();
  const colours = await Promise.all(
    [inText, live].map((one) => one.evaluate((element) => getComputedStyle(element).color)),
  );
  const root = page.locator('html');
  const hit = await root.evaluate((html) => {
    const probe = document.createElement('p');
    probe.style.color = getComputedStyle(html).getPropertyValue('--hit');
    return html.appendChild(probe) && getComputedStyle(probe).color;
  });
  expect(colours).toEqual([hit, hit]);
  await live.hover();
  await expect(inText).toHaveClass(/\blit\b/);
  await expect(mark).toHaveClass(/\blit\b/);
  // Of all that can be taken in a scene only what is free is there, and no box for any number.
  const taken = page.locator('.lesson-scene [data-handle]');
  await expect(taken).toHaveCount(1);
  await expect(taken).toHaveAttribute('data-handle', 'r');
  await expect(page.locator('.lesson input')).toHaveCount(1);
});

test('numbers travel from step to step, and are there at once for who wants less motion', async ({
  page,
}) => {
  await page.goto('./#/lesson/discriminant');
  await stepShown(page, 1);
  await framesDone(page);
  const seen = (): Promise<string[]> =>
    page.evaluate(async () => {
      const all = new Set<string>();
      const note = (): void => {
        const t1 = document.querySelector('.lesson-text [data-quantity="t1"]');
        if (t1) all.add(t1.getAttribute('data-value') ?? '');
      };
      new MutationObserver(note).observe(document.body, { subtree: true, attributes: true });
      document.body.dispatchEvent(new KeyboardEvent('keydown', { key: 'PageDown', bubbles: true }));
      for (let still = 0, before = -1; still < 30; still = before === all.size ? still + 1 : 0) {
        before = all.size;
        await new Promise(requestAnimationFrame);
      }
      return [...all];
    });
  const travelled = await seen();
  expect(travelled.length).toBeGreaterThan(2);
  expect(travelled.at(-1)).toBe('2.4');
  await page.emulateMedia({ reducedMotion: 'reduce' });
  await openStep(page, '#/lesson/discriminant', 1);
  expect(await seen()).toEqual(['2.4']);
});

const OWN = `---
title: Mine
---

## a state

link: #/explore?shape=sphere&C=0,1,0&r=1&E=3,1,0&d=-1,0,0&hide=1

It is hit at {t1}.

### Notes

Only for me.

## and another

link: #/picture?scene=plain&size=64x36

It takes {total.rays} rays.
`;

const ASKING = `---
title: Asking
---

## an example

example: cone-tangent

## a prediction

example: cone-tangent
guess: sign
`;

/** Lets a file fall onto the page. */
async function drop(page: Page, name: string, text: string): Promise<void> {
  await page.evaluate(
    ({ name, text }) => {
      const dataTransfer = new DataTransfer();
      dataTransfer.items.add(new File([text], name));
      document.body.dispatchEvent(new DragEvent('drop', { dataTransfer, bubbles: true }));
    },
    { name, text },
  );
}

test('an own lesson by file, drop and link: order, hidden results, notes', async ({ page }) => {
  await page.goto('./#/lesson');
  const chooser = page.waitForEvent('filechooser');
  await page.getByRole('button', { name: 'Open a file' }).click();
  await (await chooser).setFiles({
    name: 'mine.txt',
    mimeType: 'text/markdown',
    buffer: Buffer.from(OWN),
  });
  await stepShown(page, 1);
  // The results that the step's link hides are shown when they are asked for.
  await expect(column(page)).toContainText('It is hit at ?.');
  await page.getByRole('button', { name: 'Show the results' }).click();
  await expect(column(page)).toContainText('It is hit at 2.');
  await expect(column(page)).not.toContainText('Only for me');
  const download = page.waitForEvent('download');
  await page.getByRole('button', { name: 'Save the lesson' }).click();
  const saved = await (await (await download).createReadStream()).toArray();
  expect(Buffer.concat(saved).toString()).toBe(OWN);
  // Into another order, then by the link to somebody who has never had the file.
  await page.getByRole('button', { name: 'Edit' }).click();
  await page.getByRole('button', { name: 'Later' }).click();
  await stepShown(page, 2);
  await expect(page).toHaveURL(/#\/lesson\/own\?.*file=.*step=2|step=2.*file=/);
  const link = page.url().replace(/&step=2|step=2&/, '');
  await page.evaluate(() => localStorage.clear());
  await page.goto('about:blank');
  await page.goto(link);
  await expect(page.getByRole('heading', { level: 2, name: 'and another' })).toBeVisible();
  await expect(column(page)).toContainText('It takes 2 304 rays.');
  // A drop works on any page.
  await page.goto('./#/explore');
  await page.locator('[data-quantity="class"]').waitFor();
  await drop(page, 'mine.txt', OWN);
  await stepShown(page, 1);
  await expect(page.getByRole('heading', { level: 2, name: 'a state' })).toBeVisible();
  // An example asks and answers; what Explore asks is answered by a choice.
  const [one] = GALLERY.filter(({ id }) => id === 'cone-tangent');
  await drop(page, 'other.txt', ASKING);
  await expect(column(page)).toContainText(one?.asks ?? '-');
  await expect(column(page)).not.toContainText(one?.answer ?? '-');
  await page.getByRole('button', { name: 'show the answer' }).click();
  await expect(column(page)).toContainText(one?.answer ?? '-');
  await page.keyboard.press('PageDown');
  await stepShown(page, 2);
  await asked(page).getByLabel('D < 0').check();
  await page.getByRole('button', { name: 'That is my guess' }).click();
  await expect(column(page)).toContainText('Your guess, D < 0: not so. D = 0.');
});

test('a step is changed where it stands, and the present state becomes the next one', async ({
  page,
}) => {
  await page.goto('./#/lesson/ray');
  await page.getByRole('button', { name: 'Edit' }).click();
  const box = page.getByRole('textbox', { name: 'This step' });
  await box.fill(`${await box.inputValue()}\n\nMine: <b>E.x</b> is {E.x}.`);
  await page.getByRole('button', { name: 'Done' }).click();
  await expect(page.locator('main').getByText('Mine: <b>E.x</b> is 3.')).toBeVisible();
  await expect(problems(page)).toHaveCount(0);
  await page.getByRole('button', { name: 'Edit' }).click();
  await box.fill(`${await box.inputValue()}\n\n{Q} is nothing.`);
  await page.getByRole('button', { name: 'Done' }).click();
  await expect(problems(page)).toContainText("step 1: '{Q}' is no number that it shows");
  await page.goto('./#/check?seed=4&question=2');
  await page.locator('.check-stage').first().waitFor();
  await page.keyboard.press('c');
  await page.getByRole('link', { name: 'Lessons' }).click();
  const { steps } = lessonOf('ray');
  await stepShown(page, steps.length + 1);
  await expect(page.locator('.lesson-other .check')).toBeVisible();
});

const step = (words: string): string => `---\ntitle: x\n---\n\n## a\n\nlink: #/explore\n\n${words}`;
const HOSTILE: readonly (readonly [text: string, said: RegExp])[] = [
  ['---\nno title here\n---\n', /the lesson has no title/],
  ['---\ntitle: x\ncolour: red\n---\n## a\n\nlink: #/explore\n\nx', /'colour' means nothing/],
  ['---\ntitle: x', /a file that begins with '---' is no lesson/],
  ['---\ntitle: x\n---\n\njust text', /the lesson has no step/],
  ['---\ntitle: x\n---\n\n## a\n\nlink: javascript:globalThis.broken=1\n\nx', /'javascript:glob/],
  [step('{nothing} is shown'), /'{nothing}' is no number/],
  [step('{when D is small} x'), /'D is small' is no condition/],
  [step('{q} '.repeat(50)), /and 38 more/],
  [step('long '.repeat(30_000)), /only the first 100000 characters of the lesson are read/],
  [
    `---\ntitle: ${'t'.repeat(50_000)}\n---\n\n${'## s\n\nx\n\n'.repeat(300)}`,
    /the first 200 steps/,
  ],
  ['x'.repeat(2_100_000), /'f\.txt' was not opened: it is larger than 2 MB/],
];

test('a hostile file is text, and what is wrong with it is quoted', async ({ page }) => {
  await page.goto('./#/lesson');
  await page.getByRole('heading', { name: 'Lessons', exact: true }).waitFor();
  for (const [text, said] of HOSTILE) {
    await drop(page, 'f.txt', text);
    await expect(problems(page), text.slice(0, 60)).toContainText(said);
    expect((await extent(page)).width).toBeLessThanOrEqual(1000);
    await page.getByRole('button', { name: /dismiss/i }).click();
  }
  const markup = '<img src=x onerror="globalThis.broken=1"><script>globalThis.broken=2</script>';
  await drop(page, 'f.txt', step(`${markup} [go](javascript:globalThis.broken=3) ![p](x.png)`));
  await expect(column(page)).toContainText(markup);
  const found = await page.evaluate(() => ({
    made: document.querySelectorAll('.lesson :is(img, iframe, script, a[href^="java"])').length,
    ran: 'broken' in globalThis,
  }));
  expect(found).toEqual({ made: 0, ran: false });
});

/** One state of each look: the list, a slider, a question, an answer, each other page, an edit. */
const LOOKS: readonly (readonly [link: string, step: number])[] = [
  ['#/lesson/ray?step=5', 5],
  ['#/lesson/discriminant?step=4', 4],
  ['#/lesson/discriminant?step=4&guess=0.8', 4],
  ['#/lesson/digits?step=3', 3],
  ['#/lesson/effects?step=3', 3],
  ['#/lesson/ray?step=6', 6],
];

for (const [n, viewport] of [
  { width: 1280, height: 720 },
  { width: 1024, height: 768 },
  { width: 390, height: 844 },
  { width: 844, height: 390 },
].entries()) {
  test.describe(`${viewport.width} px`, () => {
    test.use({ viewport });
    test('axe finds nothing in any look and theme, and nothing sticks out', async ({ page }) => {
      // A size brings no colour but for the projector's, whose types are of other sizes there.
      const seen = async (): Promise<string[]> => {
        if (viewport.width === 1280) return violationsInThemes(page);
        if (viewport.width === 1024) await showTheme(page, 'projector');
        return violations(page, 'html', viewport.width === 1024 ? {} : BUT_CONTRAST);
      };
      await page.goto('./#/lesson');
      await expect(page.getByRole('link', { name: lessonOf('ray').title })).toBeVisible();
      expect.soft(await seen(), 'the list').toEqual([]);
      for (const [link, number] of byTurns(LOOKS, n)) {
        await openStep(page, link, number);
        await framesDone(page);
        await settle(page);
        expect.soft(await seen(), link).toEqual([]);
        expect.soft((await extent(page)).width, link).toBeLessThanOrEqual(viewport.width);
      }
      await openStep(page, '#/lesson/ray', 1);
      await page.getByRole('button', { name: 'Edit' }).click();
      expect.soft(await violations(page), 'an edit').toEqual([]);
      await page.getByRole('button', { name: 'Done' }).click();
    });
  });
}

/** On a wall, in a window, on a phone that lies on its side, and at 200 %. */
const BESIDE = [
  { width: 1024, height: 768, theme: 'projector' },
  { width: 1280, height: 720, theme: 'projector' },
  { width: 1280, height: 720, theme: 'light' },
  { width: 844, height: 390, theme: 'light' },
  { width: 640, height: 360, theme: 'light' },
] as const;

fresh(
  'each step that shows another page has it beside its text, whole and in view',
  async ({ page }) => {
    test.slow();
    // What is measured and traced may come later; its place is there.
    await page.addInitScript(() => {
      Worker.prototype.postMessage = () => {};
    });
    await page.goto('./#/lesson');
    await page.getByRole('heading', { name: 'Lessons', exact: true }).waitFor();
    let turn = 0;
    for (const { id, steps } of LESSONS) {
      for (const [i, { link, guess, text, answer }] of steps.entries()) {
        const shown = decode(link).page;
        if (shown === 'explore') continue;
        turn += 1;
        await page.setViewportSize({ width: 1280, height: 720 });
        await openStep(page, `#/lesson/${id}?step=${i + 1}${guess ? '&shown=1' : ''}`, i + 1);
        await page.locator('.lesson-other :is(.picture, .check, .accuracy)').waitFor();
        const spoken = quantitiesIn([...text, ...answer]).filter((name) => name.includes('.'));
        // A size of the projector, where lessons are given, and one of the other windows, by turns.
        const windows = [
          ...byTurns(BESIDE.slice(0, 2), turn),
          ...byTurns(BESIDE.slice(2), turn, 3),
        ];
        for (const { theme, ...size } of windows) {
          await page.setViewportSize(size);
          await showTheme(page, theme);
          await settle(page);
          const found = await page.evaluate((spoken) => {
            const other = document.querySelector('.lesson-other') as HTMLElement;
            const main = '.compare-view, .check-stage, .ladder, .acc-plot-body, .plot';
            // On a low window the question comes first, and the scene after it.
            const isLow = innerHeight < 500;
            const all = isLow ? '.compare-view' : main;
            const view = [...other.querySelectorAll(all)].find((one) => one.checkVisibility());
            const text = document.querySelector('.lesson-column') as HTMLElement;
            const [beside, column] = [view ?? other, text].map((one) =>
              one.getBoundingClientRect(),
            );
            const faults: string[] = [];
            if (!beside || !column) return ['nothing is there'];
            if (beside.right > column.left + 1) faults.push('not beside');
            if (beside.top < -1 || beside.top > innerHeight - 60) faults.push('out of view');
            if (document.documentElement.scrollWidth > innerWidth) faults.push('a wide page');
            if (other.clientWidth > 0 && other.scrollWidth > other.clientWidth + 1) {
              faults.push(`a row is cut: ${other.scrollWidth} of ${other.clientWidth}`);
            }
            if (isLow) return faults;
            if (document.documentElement.scrollHeight > innerHeight)
              faults.push('the page scrolls');
            const body = document.querySelector('.lesson-body') as HTMLElement;
            if (body.scrollHeight > body.clientHeight + 1) faults.push('the text scrolls');
            for (const name of spoken) {
              const [row = '', cell = ''] = name.split('.');
              const place = other.querySelector(
                `:is([data-method="${row}"], [data-effect="${row}"]) [data-quantity="${cell}"]`,
              );
              const { bottom = 0 } = place?.getBoundingClientRect() ?? {};
              if (bottom > innerHeight) faults.push(`${name} is below`);
            }
            return faults;
          }, spoken);
          const at = `${id} ${i + 1}, ${theme} ${size.width} × ${size.height}`;
          expect.soft(found, at).toEqual([]);
        }
        await showTheme(page, 'light');
      }
    }
  },
);

test('a presenter’s window follows the lesson, and a clicker works in either', async ({ page }) => {
  const { steps } = lessonOf('ray');
  await page.goto('./#/lesson/ray?step=3');
  await stepShown(page, 3);
  const [presenter] = await Promise.all([
    page.context().waitForEvent('page'),
    page.keyboard.press('p'),
  ]);
  const head = presenter.getByRole('heading', { level: 2 });
  await expect(head).toHaveText(`3 of ${steps.length}: ${steps[2]?.title}`);
  await presenter.keyboard.press('PageDown');
  await stepShown(page, 4);
  await expect(head).toHaveText(`4 of ${steps.length}: ${steps[3]?.title}`);
  await expect(presenter.getByRole('region', { name: 'Notes' })).toContainText('Let the audience');
  const next = presenter.getByRole('region', { name: 'Next' });
  await expect(next).toContainText(`the answer, then ${steps[4]?.title}`);
  await expect(next.locator('svg')).toBeVisible();
  await expect(page.getByRole('form', { name: 'Question' })).toBeVisible();
  await page.keyboard.press('PageDown');
  await expect(next).not.toContainText('the answer');
  // The projected window becomes black, and what ends that does nothing else.
  const black = page.getByRole('dialog', { name: 'Black screen' });
  await presenter.keyboard.press('.');
  await expect(black).toBeVisible();
  await expect(presenter.getByRole('dialog')).toHaveCount(0);
  await presenter.getByRole('button', { name: 'Next' }).click();
  await expect(black).toHaveCount(0);
  await stepShown(page, 4);
  expect(await violationsInThemes(presenter)).toEqual([]);
  // A reloaded window is found again; one that leaves the lesson says so.
  await page.reload();
  await stepShown(page, 4);
  await presenter.keyboard.press('PageDown');
  await expect(head).toHaveText(`5 of ${steps.length}: ${steps[4]?.title}`);
  // Of another page it has the numbers that stand there, also while they are asked for.
  await openStep(page, '#/lesson/effects?step=2', 2);
  await expect(page.locator('.picture')).toHaveAttribute('data-trace', 'finished');
  const rays = await writtenOf(page, 'shadow', 'rays');
  await expect(column(page)).not.toContainText(rays);
  await expect(presenter.locator('.presenter-text')).toContainText(rays);
  await page.keyboard.press('PageDown');
  const shown = column(page).locator('.lesson-answer [data-quantity]').first();
  const value = await shown.getAttribute('data-value');
  const name = await shown.getAttribute('data-quantity');
  await expect(presenter.locator(`[data-quantity="${name}"]`)).toHaveAttribute(
    'data-value',
    `${value}`,
  );
  await openStep(page, '#/lesson/digits?step=3', 3);
  await expect(presenter.locator('.presenter-text')).toContainText('3.75003');
  await page.goto('./#/check');
  await expect(presenter.locator('.presenter-notice')).toContainText(
    'neither a lesson nor Explore',
  );
  await presenter.close();
});

test('a presenter’s window follows Explore: what is not shown yet, and what comes next', async ({
  page,
}) => {
  await page.goto('./#/explore?hide=1');
  const [one, two] = GALLERY;
  await page.locator('.example-name').click();
  const [presenter] = await Promise.all([
    page.context().waitForEvent('page'),
    page.getByRole('button', { name: 'presenter’s window' }).click(),
  ]);
  const head = presenter.getByRole('heading', { level: 2 });
  const next = presenter.getByRole('region', { name: 'Next' }).getByRole('heading');
  const values = presenter.getByRole('region', { name: 'Values' }).getByRole('listitem');
  await expect(head).toHaveText(/^A ray and a shape of your own/);
  await page.keyboard.press('h');
  await presenter.keyboard.press('PageDown');
  await expect(head).toHaveText(`Example 1 of ${GALLERY.length}: ${one?.title}`);
  await expect(presenter.locator('.presenter-text')).toContainText(one?.answer ?? '-');
  await expect(next).toHaveText('Next: the answer');
  await presenter.keyboard.press('PageDown');
  await expect(page.locator('#example-answer')).toHaveText(one?.answer ?? '-');
  await expect(next).toHaveText(`Next: example 2 of ${GALLERY.length}: ${two?.title}`);
  await expect(presenter.locator('.presenter-drawing svg')).toBeVisible();
  // What a press shows is what was said to come, line by line; until then it is marked.
  await page.keyboard.press('h');
  await expect(values.filter({ hasNotText: 'not shown yet' })).toHaveCount(0);
  const all = await values.count();
  for (let hidden = all; hidden > 0; ) {
    const words = await next.innerText();
    await presenter.keyboard.press('PageDown');
    await expect(values.filter({ hasText: 'not shown yet' })).not.toHaveCount(hidden);
    hidden = await values.filter({ hasText: 'not shown yet' }).count();
    await expect(page.locator('.announcer')).toContainText(words.replace('Next: ', ''));
  }
  await expect(page.locator('[data-quantity="t1"]').first()).toBeVisible();
  await page.keyboard.press('h');
  await page.keyboard.press('h');
  await page.keyboard.press('d');
  await expect(next).toHaveText('Next: step 2 of the derivation');
  expect(await violationsInThemes(presenter)).toEqual([]);
  await presenter.setViewportSize({ width: 390, height: 844 });
  expect(await violationsInThemes(presenter)).toEqual([]);
  await presenter.close();
});

fresh('a presenter’s window that is kept from opening is a link', async ({ page }) => {
  await page.addInitScript(() => {
    window.open = () => null;
  });
  await page.goto('./#/lesson/ray?step=3');
  await stepShown(page, 3);
  await page.getByRole('button', { name: 'Presenter’s window' }).click();
  await expect(page.locator('.present-problem')).toContainText('kept the presenter’s window');
  const link = page.getByRole('link', { name: 'open it here' });
  expect(await link.getAttribute('href')).toMatch(/\?presenter=[a-z\d]+#\/lesson\/ray\?step=3$/);
});

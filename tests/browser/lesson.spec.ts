import { violationsInThemes } from './support/axe.ts';
import { settle } from './support/page.ts';
import { framesDone } from './support/pending.ts';
import { expect, test } from './support/test.ts';

const STEPS = 5;

test('a whole lesson by keyboard alone', async ({ page }) => {
  await page.goto('./#/lesson/ray');
  const step = page.locator('[data-lesson-step]');
  await expect(step).toHaveAttribute('data-lesson-step', '1');
  await expect(page.locator('.announcer')).toContainText(`step 1 of ${STEPS}: a place on the ray`);
  for (const number of ['2', '3', '4']) {
    await page.keyboard.press('PageDown');
    await expect(step).toHaveAttribute('data-lesson-step', number);
  }
  const first = page.locator('.lesson-answer [data-quantity="t1"]');
  await expect(page.getByRole('form', { name: 'Question' })).toBeVisible();
  await expect(first).toHaveCount(0);
  // First what is asked is shown, then the next step comes.
  await page.keyboard.press('PageDown');
  await expect(first).toHaveAttribute('data-value', '1.8');
  await page.keyboard.press('PageUp');
  await expect(first).toHaveCount(0);
  await page.keyboard.press('PageDown');
  await page.keyboard.press('PageDown');
  await expect(step).toHaveAttribute('data-lesson-step', String(STEPS));
  const slider = page.locator('.lesson-slider input');
  await slider.focus();
  for (let i = 0; i < 3; i += 1) await page.keyboard.press('ArrowLeft');
  await expect(page).toHaveURL(/step=5&r=/);
  // Also on the slider a clicker's key turns.
  await page.keyboard.press('PageUp');
  await expect(step).toHaveAttribute('data-lesson-step', '4');
});

test.describe('by touch alone', () => {
  test.use({ viewport: { width: 390, height: 844 }, hasTouch: true });
  test('a whole lesson on a phone', async ({ page }) => {
    await page.goto('./#/lesson');
    await page.getByRole('link', { name: 'From the ray to the quadratic' }).tap();
    const step = page.locator('[data-lesson-step]');
    for (let number = 1; number < STEPS; number += 1) {
      await expect(step).toHaveAttribute('data-lesson-step', String(number));
      if (number === 4) {
        await page.getByLabel('t₁ =').fill('2');
        await page.getByRole('button', { name: 'That is my guess' }).tap();
        await expect(page.getByText('Your guess 2: too large by 0.2')).toBeVisible();
      }
      await page.getByRole('button', { name: 'Next' }).tap();
    }
    await expect(step).toHaveAttribute('data-lesson-step', String(STEPS));
    await page.getByRole('link', { name: 'All lessons' }).tap();
    await expect(page.getByRole('heading', { name: 'Lessons', exact: true })).toBeVisible();
  });
});

test('the gallery leads to the first lesson, and each other one opens', async ({ page }) => {
  await page.goto('./#/explore');
  await page.locator('.example-name').click();
  await page.getByRole('link', { name: 'Begin with the first lesson' }).click();
  await expect(page.locator('[data-lesson-step]')).toHaveAttribute('data-lesson-step', '1');
  await expect(page.getByRole('dialog')).toHaveCount(0);
  for (const [id, step, words] of [
    ['discriminant', 4, 'At which r does the ray just touch?'],
    ['normal', 5, 'the normal is the zero vector'],
    ['no-square', 2, 'A is 0: no root.'],
  ] as const) {
    await page.goto(`./#/lesson/${id}?step=${step}`);
    await expect(page.locator('.lesson-body')).toContainText(words);
  }
});

test('a step shows Accuracy beside its text', async ({ page }) => {
  await page.goto('./#/lesson/digits?step=2');
  await expect(page.locator('.lesson-body')).toContainText('of the same ray that it misses');
  await expect(page.getByRole('heading', { name: 'This ray' })).toBeVisible();
});

test('what is moved and answered is in the link, and comes back by it', async ({ page }) => {
  await page.goto('./#/lesson/ray?step=5&r=0.5');
  await expect(page.getByText('there is no root')).toBeVisible();
  await page.goto('./#/lesson/ray?step=4&guess=1.8');
  await expect(page.getByText('Your guess 1.8: right')).toBeVisible();
  await page.goto('./#/lesson/nothing');
  await expect(page.getByRole('alert')).toContainText("there is no lesson 'nothing'");
});

test('a step is changed where it stands, and the link carries the lesson', async ({ page }) => {
  await page.goto('./#/lesson/ray');
  await page.getByRole('button', { name: 'Edit' }).click();
  const box = page.getByRole('textbox', { name: 'This step' });
  await box.fill(`${await box.inputValue()}\n\nMine: <b>E.x</b> is {E.x}.`);
  await page.getByRole('button', { name: 'Done' }).click();
  await expect(page.getByText('Mine: <b>E.x</b> is 3.')).toBeVisible();
  await expect(page).toHaveURL(/#\/lesson\/own\?.*file=/);
  const link = page.url();
  await page.goto('about:blank');
  await page.goto(link);
  await expect(page.getByText('Mine: <b>E.x</b> is 3.')).toBeVisible();
});

for (const viewport of [
  { width: 1280, height: 720 },
  { width: 1024, height: 768 },
  { width: 390, height: 844 },
]) {
  test.describe(`${viewport.width} px`, () => {
    test.use({ viewport });
    test('axe finds nothing in the list and in any step', async ({ page }) => {
      await page.goto('./#/lesson');
      await expect(page.getByRole('link', { name: 'From the ray to the quadratic' })).toBeVisible();
      expect.soft(await violationsInThemes(page), 'the list').toEqual([]);
      for (let number = 1; number <= STEPS; number += 1) {
        await page.goto(`./#/lesson/ray?step=${number}`);
        await page.locator(`[data-lesson-step="${number}"]`).waitFor();
        await framesDone(page);
        await settle(page);
        expect.soft(await violationsInThemes(page), `step ${number}`).toEqual([]);
      }
    });
  });
}

import type { Locator, Page } from '@playwright/test';
import { casesFor, GROUPS } from '../../src/check/program/cases.ts';
import { plan, question } from '../../src/check/session.ts';
import { LATEST_SET } from '../../src/check/sets.ts';
import type { Answer } from '../../src/check/types.ts';
import { intersect } from '../../src/math/index.ts';
import { shortest } from '../../src/text/format.ts';
import { violations, violationsInThemes } from './support/axe.ts';
import { extent } from './support/layout.ts';
import { hashOf, NO_SCENE, settle, withoutScene } from './support/page.ts';
import { openCheck, report, runProgram } from './support/program.ts';
import { expect, test as fresh, visit as test } from './support/test.ts';

test.describe.configure({ mode: 'default' });

const SEED = 41;
const COUNT = plan(SEED).length;
const indexOf = (exercise: string): number =>
  plan(SEED).findIndex((slot) => slot.exercise === exercise);
const link = (exercise: string): string => `seed=${SEED}&question=${indexOf(exercise) + 1}`;

const asText = (answer: Answer | undefined): string => {
  if (typeof answer === 'number') return shortest(answer);
  return typeof answer === 'object' ? answer.map(shortest).join(', ') : (answer ?? '');
};

/** Answers the open question. */
async function answer(
  page: Page,
  exercise: string,
  answers: Readonly<Record<string, Answer>>,
): Promise<void> {
  for (const { id, kind } of question(SEED, indexOf(exercise)).fields) {
    const row = page.locator(`.answer[data-field="${id}"]`);
    if (kind === 'choice') await row.locator('select').selectOption(asText(answers[id]));
    else await row.locator('input').fill(asText(answers[id]));
  }
  await page.locator('.answers').getByRole('button', { name: 'Check', exact: true }).click();
}

const feedback = (page: Page) => page.locator('.feedback').first();

test.describe('questions', () => {
  test.use({ provoked: NO_SCENE });
  test.beforeEach(async ({ page }) => {
    await withoutScene(page);
  });

  fresh(
    'a wrong answer is named, hints come after a try, the right one is kept',
    async ({ page }) => {
      const posed = question(SEED, indexOf('roots'));
      await openCheck(page, link('roots'));
      await expect(page.getByRole('button', { name: /^Hint/ })).toHaveCount(0);
      const [suspect] = posed.suspects;
      await answer(page, 'roots', suspect?.answers ?? {});
      await expect(feedback(page)).toHaveAttribute('data-cause', suspect?.misconception.id ?? '');
      await expect(feedback(page)).toContainText(
        `This is what comes out with ${suspect?.misconception.says}`,
      );
      await expect(feedback(page)).toContainText('It happens on');
      for (const i of [1, 2, 3]) await page.getByRole('button', { name: `Hint ${i} of 3` }).click();
      await expect(page.locator('.helps')).toContainText(posed.exercise.clue);
      await answer(page, 'roots', posed.truth);
      await expect(feedback(page)).toHaveAttribute('data-verdict', 'correct');
      await page.reload();
      await expect(feedback(page)).toHaveAttribute('data-verdict', 'correct');
      await page.locator('.summary summary').click();
      await expect(page.locator('.summary')).toContainText('right at try 2');
      await expect(page.locator('.summary')).toContainText(`1 of ${COUNT} right`);
      await page.getByRole('button', { name: 'Next question' }).click();
      await expect(
        page.getByRole('heading', { name: `Question ${indexOf('roots') + 2} of ${COUNT}` }),
      ).toBeVisible();
      await expect.poll(() => hashOf(page)).toContain(`question=${indexOf('roots') + 2}`);
    },
  );

  test('what cannot be read is no try', async ({ page }) => {
    await openCheck(page, link('coefficients'));
    await page.locator('.answer input').first().fill('abc');
    await page.keyboard.press('Enter');
    await expect(feedback(page)).toHaveAttribute('data-verdict', 'invalid');
    await expect(page.locator('.answer .mark').first()).toContainText("'abc' is not a number");
    await expect(page.locator('.answer .mark').nth(1)).toContainText('not answered');
    await page.locator('.summary summary').click();
    await expect(page.locator('.summary tbody tr').nth(indexOf('coefficients'))).toContainText(
      'not tried',
    );
  });

  fresh(
    'every question can be answered, and the solution ends with what was asked',
    async ({ page }) => {
      await openCheck(page, `seed=${SEED}`);
      for (let i = 0; i < COUNT; i++) {
        await page.locator('.dash').nth(i).click();
        await expect(
          page.getByRole('heading', { name: `Question ${i + 1} of ${COUNT}` }),
        ).toBeVisible();
        // It has the focus from the first frame: later it would take it from who types elsewhere.
        const [first] = await page
          .locator('.answers :is(input, select)')
          .evaluateAll((all) => all.map((one) => one === document.activeElement));
        expect(first, `the first box of question ${i + 1} has the focus`).toBe(true);
        const posed = question(SEED, i);
        for (const { id, kind } of posed.fields) {
          const row = page.locator(`.answer[data-field="${id}"]`);
          if (kind === 'choice') await row.locator('select').selectOption(asText(posed.truth[id]));
          else await row.locator('input').fill(asText(posed.truth[id]));
        }
        await page.locator('.answers').getByRole('button', { name: 'Check', exact: true }).click();
        await expect(feedback(page), posed.exercise.id).toHaveAttribute('data-verdict', 'correct');
        await page.getByRole('button', { name: 'Show the solution' }).click();
        await expect(page.locator('.solution .so'), posed.exercise.id).toBeVisible();
      }
      await page.locator('.summary summary').click();
      await expect(page.locator('.summary')).toContainText(`${COUNT} of ${COUNT} right`);
      const [file] = await Promise.all([
        page.waitForEvent('download'),
        page.locator('.summary').getByRole('button', { name: 'Save as JSON' }).click(),
      ]);
      expect(file.suggestedFilename()).toBe(`graze-check-${SEED}.json`);
    },
  );

  const NEWEST = ['pixel', 'graph', 'cut', 'order', 'effect', 'method'] as const;
  const BY_KEYS = `first,${NEWEST.join(',')};shapes=cone,cylinder`;

  test('with the keyboard alone, from the start to the last verdict', async ({ page }) => {
    const slots = plan(SEED, BY_KEYS);
    expect(slots.map(({ exercise }) => exercise).sort()).toEqual(['first', ...NEWEST].sort());
    const focused = (target: Locator) => () =>
      target.evaluate((element) => element === document.activeElement);
    const press = async (key: string, until: () => Promise<boolean>): Promise<void> => {
      for (let i = 0; i < 80 && !(await until()); i++) await page.keyboard.press(key);
      expect(await until()).toBe(true);
    };
    await openCheck(page, `set=${BY_KEYS.replace(';', '&')}&seed=${SEED}`);
    for (const [index, { exercise }] of slots.entries()) {
      const heading = page.getByRole('heading', { name: `Question ${index + 1} of` });
      await expect(heading, exercise).toBeVisible();
      const { fields, truth } = question(SEED, index, BY_KEYS);
      for (const { id, kind, options } of fields) {
        const control = page.locator(`.answer[data-field="${id}"] :is(input, select)`);
        await press('Tab', focused(control));
        const wanted = asText(truth[id]);
        if (kind === 'choice') {
          const at = options.findIndex((option) => option.id === truth[id]);
          for (let i = 0; i <= at; i++) await page.keyboard.press('ArrowDown');
        } else await page.keyboard.type(wanted);
        await expect(control, `${exercise}, ${id}`).toHaveValue(wanted);
      }
      await press('Tab', focused(page.getByRole('button', { name: 'Check', exact: true })));
      await page.keyboard.press('Enter');
      await expect(feedback(page), exercise).toHaveAttribute('data-verdict', 'correct');
      if (index === slots.length - 1) break;
      await press('Tab', focused(page.getByRole('button', { name: 'Next question' })));
      await page.keyboard.press('Enter');
    }
    await expect(page.locator('.summary summary')).toContainText(
      `${slots.length} of ${slots.length} right`,
    );
  });

  test('a broken link says what was wrong and opens the nearest', async ({ page }) => {
    await openCheck(page, 'seed=abc&question=99&part=nowhere&colour=red');
    const words = await page.locator('.problems').innerText();
    for (const part of ["seed: 'abc'", "question: '99'", "part: 'nowhere'", 'colour']) {
      expect(words).toContain(part);
    }
    await expect(page.getByRole('heading', { name: /^Question 1 of/ })).toBeVisible();
  });

  test('another seed, other numbers; the seed is in the link', async ({ page }) => {
    await openCheck(page, `seed=${SEED}`);
    const before = await page.locator('.given').first().innerText();
    await page.locator('input[name="seed"]').fill('42');
    await page.keyboard.press('Enter');
    await expect(page.locator('.given').first()).not.toHaveText(before);
    await expect.poll(() => hashOf(page)).toContain(`seed=42&set=${LATEST_SET}`);
  });
});

fresh(
  'hits stay hidden until a question is solved or given up; own points are drawn',
  async ({ page }) => {
    await openCheck(page, link('roots'));
    const stage = page.locator('.check-left .check-stage');
    await stage.locator('canvas').waitFor();
    await settle(page);
    const marks = stage.locator('[data-symbol^="t1"], [data-symbol^="t2"]');
    await expect(marks).toHaveCount(0);
    await answer(page, 'roots', { t1: 1, t2: 2 });
    await expect(stage).toContainText('yours');
    await settle(page);
    await expect(marks).toHaveCount(0);
    const words = stage.locator('.scene-description').first();
    await expect(words).toContainText('Yours:');
    await expect(words).not.toContainText(/t₁|t₂|first hit|outside|inside/);
    await expect(page.locator('.check-left a[href*="#/explore"]')).toHaveCount(0);
    await page.getByRole('button', { name: 'Show the solution' }).click();
    await expect(marks).not.toHaveCount(0);
    await expect(page.locator('.solution .so')).toContainText('So t₁ =');
  },
);

test.describe('own numbers', () => {
  test.use({ provoked: NO_SCENE });
  const LINK = 'shape=cylinder&C=1,0,-1&r=2&E=6,1,2&d=-1,0.5,-0.5&part=own';

  test('take shape and ray from the link, and find the first wrong step', async ({ page }) => {
    await withoutScene(page);
    await openCheck(page, LINK);
    await expect(page.locator('.own .given')).toContainText('(6, 1, 2)');
    const type = (id: string, text: string) =>
      page.locator(`.own .answer[data-field="${id}"] input`).fill(text);
    await type('A', '5/4');
    await type('B', '-14');
    await type('C', '30');
    await type('t1', '(14-sqrt(46))/2.5');
    await page.getByRole('button', { name: 'Check my numbers' }).click();
    const mark = (id: string) => page.locator(`.own .answer[data-field="${id}"] .mark`);
    await expect(mark('A')).toContainText('right');
    await expect(mark('B')).toContainText('not right');
    await expect(mark('t1')).toContainText('right for your earlier values');
    await expect(feedback(page)).toContainText(
      'B is wrong; the first wrong step is B. Your t₁ is right for your B.',
    );
    await page.reload();
    await expect(page.locator('.own .answer[data-field="B"] input')).toHaveValue('-14');
  });
});

test.describe('programs of other languages', () => {
  test.use({ provoked: NO_SCENE });

  test('cases go out, results come back and are graded', async ({ page }) => {
    await withoutScene(page);
    await openCheck(page, 'part=program&cases=plane');
    await page.locator('.exchange summary').click();
    const [file] = await Promise.all([
      page.waitForEvent('download'),
      page.getByRole('button', { name: 'Cases as JSON' }).click(),
    ]);
    expect(file.suggestedFilename()).toBe('graze-cases.json');
    const cases = casesFor(['plane'], 41);
    const lines = cases.map(({ id, shape, ray }) => {
      try {
        return [id, ...intersect(shape, ray, 'exact').hits.map(({ t }) => t)].join(',');
      } catch {
        return `${id},error,refused`;
      }
    });
    const allRight = async (): Promise<void> => {
      for (const { id } of GROUPS) {
        const total = cases.filter(({ group }) => group === id).length;
        const score = page.locator(`[data-quantity="passed.${id}"]`);
        await expect(score).toHaveText(`${total} of ${total}`);
      }
    };
    const [chooser] = await Promise.all([
      page.waitForEvent('filechooser'),
      page.getByRole('button', { name: 'Open results' }).click(),
    ]);
    await chooser.setFiles({
      name: 'results.csv',
      mimeType: 'text/csv',
      buffer: Buffer.from(lines.join('\n')),
    });
    await allRight();
    const [again] = await Promise.all([
      page.waitForEvent('filechooser'),
      page.getByRole('button', { name: 'Open results' }).click(),
    ]);
    await again.setFiles({
      name: 'results.csv',
      mimeType: 'text/csv',
      buffer: Buffer.from('nonsense'),
    });
    await expect(report(page)).toContainText('could not be read');
    // The same file, dropped on the page.
    await page.evaluate((text) => {
      const data = new DataTransfer();
      data.items.add(new File([text], 'results.csv', { type: 'text/csv' }));
      document.body.dispatchEvent(new DragEvent('drop', { dataTransfer: data, bubbles: true }));
    }, lines.join('\n'));
    await allRight();
  });

  test('a failing case opens in Explore', async ({ page }) => {
    await withoutScene(page);
    await openCheck(page, 'part=program&cases=cylinder');
    await runProgram(page, 'const intersect = () => ({ t: [] });');
    await expect(page.locator('.failure')).toContainText('misses the hit');
    await page.getByRole('link', { name: 'See it in Explore' }).click();
    await expect(page.locator('[data-quantity="class"]')).toBeVisible();
    expect(await hashOf(page)).toMatch(/^#\/explore\?shape=cylinder&E=/);
  });
});

const STATES = ['seed=41&question=1', 'part=own', 'part=program&cases=cylinder'];
for (const viewport of [
  { width: 1280, height: 800 },
  { width: 390, height: 844 },
]) {
  test.describe(`${viewport.width} px`, () => {
    test.use({ viewport, provoked: NO_SCENE });
    fresh('axe finds nothing, and nothing is wider than the screen', async ({ page }) => {
      await withoutScene(page);
      for (const state of STATES) {
        await openCheck(page, state);
        await page.reload();
        await page.locator('.check h2').filter({ visible: true }).first().waitFor();
        if (state.includes('question')) {
          await page.locator('.answers input').first().fill('1');
          await page.keyboard.press('Enter');
          await page.getByRole('button', { name: 'Show the solution' }).click();
          await page.locator('.summary summary').click();
        }
        if (state.includes('own')) {
          await page.locator('.own input').first().fill('7');
          await page.keyboard.press('Enter');
        }
        if (state.includes('program')) {
          await runProgram(page, 'const intersect = () => ({ t: [1, NaN] });');
          await page.locator('.exchange summary').click();
        }
        await settle(page);
        // A narrow screen has no colours of its own.
        const found = await (viewport.width > 390 ? violationsInThemes(page) : violations(page));
        expect.soft(found, state).toEqual([]);
        expect.soft((await extent(page)).width, state).toBe(viewport.width);
      }
    });
  });
}

import { readFileSync } from 'node:fs';
import type { Page } from '@playwright/test';
import type { HandIn } from '../../src/check/class.ts';
import { gradedCases } from '../../src/check/program/cases.ts';
import { programOf } from '../../src/check/program/source.ts';
import { plan, question, studentSeed } from '../../src/check/session.ts';
import type { Answer } from '../../src/check/types.ts';
import { handInCode } from '../../src/state/hand-in.ts';
import { shortest } from '../../src/text/format.ts';
import { violationsInThemes } from './support/axe.ts';
import { extent } from './support/layout.ts';
import { hashOf, NO_SCENE, problems, withoutScene } from './support/page.ts';
import { openCheck } from './support/program.ts';
import { expect, test as fresh, visit as test } from './support/test.ts';

test.describe.configure({ mode: 'default' });

const SET = 'coefficients,roots;shapes=cylinder;level=1';
const LINK = 'set=coefficients,roots&shapes=cylinder&level=1&seed=41';

const asText = (answer: Answer | undefined): string => {
  if (typeof answer === 'number') return shortest(answer);
  return typeof answer === 'object' ? answer.map(shortest).join(', ') : (answer ?? '');
};

const rightTexts = (seed: number, index: number): Record<string, string> => {
  const { fields, truth } = question(seed, index, SET);
  return Object.fromEntries(fields.map(({ id }) => [id, asText(truth[id])]));
};

/** A hand-in with the first `right` questions answered. */
function handIn(who: string, right: number): HandIn {
  const seed = studentSeed(41, who);
  const asked = plan(seed, SET).map((_, i) => ({
    texts: i < right ? rightTexts(seed, i) : {},
    ...{ tries: i < right ? 1 : 0, solvedAt: i < right ? 1 : null },
    ...{ hints: 0, solutionShown: false, causes: [] },
  }));
  return { set: SET, seed: 41, who, asked };
}

test.use({ provoked: NO_SCENE });
test.beforeEach(async ({ page }) => {
  await withoutScene(page);
});

const answerAll = async (page: Page, texts: Record<string, string>): Promise<void> => {
  for (const [id, text] of Object.entries(texts)) {
    await page.locator(`.answer[data-field="${id}"] input`).fill(text);
  }
};

test('a set is made in the form, answered under a name, handed in and marked', async ({ page }) => {
  // What the form says of sets is not true of the first ones.
  const form = page.locator('.set-form');
  await openCheck(page, 'part=set&set=1');
  await expect(form).toContainText('this is set 1 as it always was');
  await expect(form).not.toContainText('students give a name or number');
  await openCheck(page, 'part=set&set=flat');
  await expect(form).toContainText('students give a name or number');
  await expect(form).not.toContainText('as it always was');
  // Each box with what it refuses and why, and a value that it takes.
  const whole = 'is not a whole number of up to nine digits.';
  const often = 'does not say how often: a whole number from 0 on does.';
  for (const [name, texts, right] of [
    ['seed', { one: whole, '1e400': whole, '': whole }, '1'],
    ['seeds from', { '1e3': whole, '': whole, '0x1': whole }, '1'],
    ['to', { 'two pages': whole, '400': 'makes 400 sheets: up to 200 at a time.' }, '1'],
    ['both roots', { '-1': often, '': often, '2.5': often }, '0'],
    [
      'SCORM and xAPI: passed from',
      { many: 'is not a number', '101': 'is not from 0 to 100' },
      '50',
    ],
  ] as const) {
    const box = form.getByLabel(name, { exact: name === 'seed' || name === 'to' });
    const refused = form.locator('.refusal:not(:empty)');
    for (const [text, why] of Object.entries(texts)) {
      await box.fill(text);
      await box.press('Enter');
      await expect(refused).toHaveCount(1);
      await expect(refused).toContainText(`'${text}' ${why}`);
      await expect(box).toHaveValue(text);
    }
    await box.fill(right);
    await box.press('Enter');
    await expect(refused).toHaveCount(0);
  }
  const row = (id: string) => page.locator(`[data-exercise="${id}"] input`);
  for (const id of ['coefficients', 'roots']) {
    await row(id).fill('1');
    await row(id).press('Tab');
  }
  await row('flat').fill('0');
  await row('flat').press('Tab');
  const shapes = page.getByRole('group', { name: 'Shapes' });
  for (const label of await shapes.locator('label').all()) {
    const box = label.getByRole('checkbox');
    if ((await label.innerText()).trim() !== 'cylinder') await box.press('Space');
  }
  await page.getByRole('combobox', { name: 'numbers' }).selectOption('1');
  await page.getByRole('checkbox', { name: 'hints and solutions' }).press('Space');
  await page.getByLabel('seed', { exact: true }).fill('41');
  await page.getByLabel('seed', { exact: true }).press('Enter');
  const link = page.getByRole('textbox', { name: 'Link' });
  await expect(link).toHaveValue(
    /#\/check\?set=coefficients,roots&shapes=cylinder&level=1&hints=off&seed=41$/,
  );
  expect(await violationsInThemes(page, '.check')).toEqual([]);
  await page.getByRole('button', { name: 'Open its questions' }).click();
  await page.getByLabel('name or number').fill('Ada');
  await page.getByLabel('name or number').press('Enter');
  await expect.poll(() => hashOf(page)).toContain('who=Ada');
  await answerAll(page, rightTexts(studentSeed(41, 'Ada'), 0));
  await page.locator('.answers').getByRole('button', { name: 'Check', exact: true }).click();
  await expect(page.locator('.feedback').first()).toHaveAttribute('data-verdict', 'correct');
  await expect(page.getByRole('button', { name: /solution|Hint/ })).toHaveCount(0);
  await page.locator('main').getByText('Hand in', { exact: true }).click();
  await expect(page.locator('.hand-in .link-code')).toBeVisible();
  expect(await violationsInThemes(page, '.hand-in')).toEqual([]);
  const code = await page.getByLabel('Code', { exact: true }).inputValue();
  expect(code).toMatch(/^graze1\./);
  const [file] = await Promise.all([
    page.waitForEvent('download'),
    page.getByRole('button', { name: 'Save as xAPI statements' }).click(),
  ]);
  const [statement, ...others] = JSON.parse(readFileSync(await file.path(), 'utf8'));
  expect(others).toEqual([]);
  expect(statement.actor.account.name).toBe('Ada');
  expect(statement.result.success).toBe(true);
  expect(statement.object.id).toMatch(/^http.*#\/check\?set=.*&seed=41&question=1$/);
  await page.getByRole('button', { name: 'Mark a class' }).click();
  await page.getByLabel('Hand-in codes').fill(`From: Ada\n\n${code}\n`);
  await page.getByRole('button', { name: 'Mark these codes' }).click();
  const students = page.getByRole('region', { name: 'Results by student' });
  await expect(students.getByRole('row', { name: /^Ada/ })).toContainText('1 of 2');
});

fresh('two hundred codes are marked while the page answers', async ({ page }) => {
  const codes = Array.from({ length: 200 }, (_, i) => handInCode(handIn(`s${i + 1}`, i % 3)));
  await openCheck(page, `part=class&${LINK}`);
  await page.getByLabel('Hand-in codes').fill(codes.join('\n'));
  await page.evaluate(() => {
    Object.assign(window, { beats: 0 });
    const beat = (): void => {
      if (document.querySelector('.class-part .progress')) {
        (window as unknown as { beats: number }).beats += 1;
      }
      setTimeout(beat, 0);
    };
    beat();
  });
  await page.getByRole('button', { name: 'Mark these codes' }).click();
  const count = page.locator('[data-quantity="students"]');
  await expect(count).toHaveAttribute('data-value', '200', { timeout: 60_000 });
  const students = page.getByRole('region', { name: 'Results by student' });
  await expect(students.locator('tbody tr')).toHaveCount(200);
  await expect(students.getByRole('row', { name: /^s3 / })).toContainText('2 of 2');
  // Marked in many tasks, and not in one: between them the page drew how far it was, and answered.
  const beats = await page.evaluate(() => (window as unknown as { beats: number }).beats);
  expect(beats).toBeGreaterThan(2);
  await expect(page.getByRole('region', { name: 'Results by topic' })).toContainText(' of 200');
  const [file] = await Promise.all([
    page.waitForEvent('download'),
    page.getByRole('button', { name: 'Save as CSV' }).click(),
  ]);
  const lines = readFileSync(await file.path(), 'utf8')
    .trim()
    .split('\n');
  expect(lines).toHaveLength(201);
  expect(lines[1]).toMatch(/^s1,/);
  expect(await violationsInThemes(page, '.check')).toEqual([]);
  await page.setViewportSize({ width: 375, height: 800 });
  expect((await extent(page)).width).toBeLessThanOrEqual(375);
  await page.getByLabel('Hand-in codes').fill('hello graze1.abc.abcdefg');
  await page.getByRole('button', { name: 'Mark these codes' }).click();
  await expect(problems(page)).toContainText('the check value does not fit');
});

fresh(
  'dropped files and folders are marked and graded, and saved as four kinds of files',
  async ({ page }) => {
    await openCheck(page, `part=class&${LINK}&cases=sphere&cases-seed=2718`);
    const program = programOf('sphere') ?? '';
    const cases = gradedCases(['sphere'], 2718);
    const results = cases.map(({ id, expected }) =>
      expected ? { id, t: expected.t } : { id, error: 'no' },
    );
    const files = {
      'class/Ada.txt': `Dear all,\n> ${handInCode(handIn('Ada', 2))}`,
      'class/more/deep/Bo.eml': handInCode(handIn('Bo', 1)),
      'class/Cem.js': program,
      'class/Dee/intersect.ts': program.replace('(shape, ray)', '(shape: any, ray: any)'),
      'class/Dee/notes.rst': '# notes',
      'class/Eve.json': JSON.stringify(results),
      'class/Fay.js': 'function intersect( {',
      'class/.DS_Store': '',
    };
    // A folder as browsers drop it: entries that are read a few at a time.
    await page.evaluate((given) => {
      interface Entry {
        readonly isFile: boolean;
        readonly fullPath: string;
      }
      const entryOf = (path: string): Entry => {
        const own = given as Readonly<Record<string, string>>;
        const text = own[path];
        if (text !== undefined) {
          const file = new File([text], path.split('/').at(-1) ?? '');
          return {
            ...{ isFile: true, fullPath: `/${path}` },
            ...{ file: (done: (file: File) => void) => done(file) },
          };
        }
        const below = Object.keys(own).filter((name) => name.startsWith(`${path}/`));
        const names = below.map((name) => name.slice(path.length + 1).split('/')[0] ?? '');
        let left = [...new Set(names)].map((name) => entryOf(`${path}/${name}`));
        const readEntries = (done: (some: Entry[]) => void): void => {
          done(left.slice(0, 2));
          left = left.slice(2);
        };
        return {
          ...{ isFile: false, fullPath: `/${path}` },
          ...{ createReader: () => ({ readEntries }) },
        };
      };
      const event = new DragEvent('drop', { bubbles: true, cancelable: true });
      const items = [{ webkitGetAsEntry: () => entryOf('class') }];
      Object.defineProperty(event, 'dataTransfer', {
        value: { types: ['Files'], items, files: [] },
      });
      document.querySelector('.class-part')?.dispatchEvent(event);
    }, files);
    await expect(page.locator('[data-quantity="students"]')).toHaveAttribute('data-value', '2');
    await expect(page.locator('.class-problems')).toContainText('notes.rst: no hand-in code in it');
    const points = page.getByRole('region', { name: 'Points by submission' });
    await expect(points.locator('tbody tr')).toHaveCount(4);
    const row = (who: string) => points.getByRole('row', { name: new RegExp(`^${who}`) });
    await expect(row('Eve').locator('td').first()).toHaveText('100');
    await expect(row('Fay')).toContainText('syntax error');
    const [cem, dee] = await Promise.all(
      ['Cem', 'Dee'].map((who) => row(who).locator('td').first().innerText()),
    );
    expect(cem).toBe(dee);
    expect(Number(cem)).toBeGreaterThan(50);
    const weight = page.getByLabel('weight of hard cases');
    await weight.fill('-1');
    await weight.press('Tab');
    await expect(page.locator('.grades .refusal:not(:empty)')).toContainText([
      "Weight of hard cases: '-1' is no weight: a number from 0 on is.",
    ]);
    for (const group of ['ordinary', 'special', 'invalid']) {
      await page.getByLabel(`weight of ${group} cases`).fill('0');
      await page.getByLabel(`weight of ${group} cases`).press('Tab');
    }
    await weight.fill('2');
    await weight.press('Tab');
    const [, right = '', of = ''] =
      /^(\d+) of (\d+)$/.exec(await row('Cem').locator('td').nth(3).innerText()) ?? [];
    await expect(row('Cem').locator('td').first()).toHaveText(
      String(Math.round((1e4 * Number(right)) / Number(of)) / 100),
    );
    for (const [button, name, has] of [
      ['CSV', 'graze-programs.csv', 'Eve,100,'],
      ['Gradescope', 'graze-results.zip', 'results.Fay.json'],
      ['JUnit XML', 'graze-junit.xml', '<testsuite name="Dee"'],
      ['Markdown', 'report.md', '| Eve | 100 |'],
    ] as const) {
      const [file] = await Promise.all([
        page.waitForEvent('download'),
        page.locator('.grades').getByRole('button', { name: button, exact: true }).click(),
      ]);
      expect(file.suggestedFilename()).toBe(name);
      expect(readFileSync(await file.path(), 'latin1')).toContain(has);
    }
    expect(await violationsInThemes(page, '.grades')).toEqual([]);
    await page.setViewportSize({ width: 375, height: 800 });
    expect((await extent(page)).width).toBeLessThanOrEqual(375);
  },
);

test('a set is saved for course systems, and printed on the paper that is chosen', async ({
  page,
}) => {
  await openCheck(page, `part=set&${LINK}`);
  for (const [button, name, begins] of [
    ['Moodle XML', 'graze-moodle.xml', '<?xml'],
    ['GIFT', 'graze.gift.txt', '::'],
    ['QTI 2.1', 'graze-qti.zip', 'PK'],
    ['STACK', 'graze-stack.xml', '<?xml'],
  ] as const) {
    const [file] = await Promise.all([
      page.waitForEvent('download'),
      page.getByRole('button', { name: button, exact: true }).click(),
    ]);
    expect(file.suggestedFilename()).toBe(name);
    expect(readFileSync(await file.path(), 'latin1').startsWith(begins)).toBe(true);
  }
  await page.getByLabel('to', { exact: true }).fill('43');
  await page.getByLabel('to', { exact: true }).press('Enter');
  for (const [paper, width] of [
    ['a4', 595],
    ['letter', 612],
  ] as const) {
    await page.getByLabel('paper').selectOption(paper);
    const pdf = (await page.pdf({ preferCSSPageSize: true })).toString('latin1');
    const boxes = [...pdf.matchAll(/\/MediaBox \[0 0 ([\d.]+)/g)].map(([, w]) =>
      Math.round(Number(w)),
    );
    // Three sheets, and three keys.
    expect(boxes).toEqual(Array.from({ length: 6 }, () => width));
  }
});

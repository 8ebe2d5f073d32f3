import { box, expectInLink, slider, typeInto } from './support/controls.ts';
import { hashOf, linkWritten, open, problems, quantities, settle } from './support/page.ts';
import { expect, visit as test } from './support/test.ts';

test.describe.configure({ mode: 'default' });

/** Where, what is typed, and what the reason has to quote. */
const REFUSED: readonly (readonly [box: string, typed: string, reason: RegExp])[] = [
  ['E.x', 'abc', /'abc' is not a number/],
  ['E.y', '1/0', /'1\/0'/],
  ['E.z', '1e400', /'1e400' is beyond the largest double/],
  ['d.x', 'sqrt(-1)', /'sqrt\(-1\)'/],
  ['d.y', '', /type a number/],
  ['C.x', '1,2,x', /'x'/],
  ['r', '-1', /≥ 0, got -1/],
  ['r', 'NaN', /'NaN'/i],
  ['r', '<b>1</b>', /'<b>1<\/b>'/],
];

test('what is not allowed stays in its box with the reason below, and changes nothing', async ({
  page,
}) => {
  await open(page, '#/explore?shape=cylinder&E=3,1,0.5&method=exact');
  await expectInLink(page, { E: '3,1,0.5' });
  const before = await quantities(page);
  const link = await hashOf(page);
  for (const [name, typed, reason] of REFUSED) {
    const input = box(page, name);
    await typeInto(page, name, typed);
    await expect(input, `${name} = ${typed}`).toHaveValue(typed);
    await expect(input).toHaveAttribute('aria-invalid', 'true');
    const alert = problems(page);
    await expect(alert).toHaveText(reason);
    expect(await input.getAttribute('aria-describedby')).toBe(await alert.getAttribute('id'));
    const [above, below] = [await input.boundingBox(), await alert.boundingBox()];
    expect((below?.y ?? 0) - ((above?.y ?? 0) + (above?.height ?? 0))).toBeGreaterThanOrEqual(0);
    expect(await quantities(page), `${name} = ${typed}`).toEqual(before);
    await linkWritten(page);
    expect(await hashOf(page)).toBe(link);
    await input.press('Escape');
    await settle(page);
    await expect(input).toHaveAttribute('aria-invalid', 'false');
    await expect(input).not.toHaveValue(typed);
    await expect(alert).toHaveCount(0);
  }
});

test('a refused text outlives losing the focus, and a slider of the same number ends it', async ({
  page,
}) => {
  await open(page, '#/explore?shape=cylinder&method=exact');
  await box(page, 'r').fill('-1');
  await box(page, 'E.x').focus();
  await settle(page);
  await expect(box(page, 'r')).toHaveValue('-1');
  await expect(box(page, 'r')).toHaveAttribute('aria-invalid', 'true');
  await slider(page, 'r').press('ArrowRight');
  await settle(page);
  await expect(box(page, 'r')).toHaveAttribute('aria-invalid', 'false');
  await expect(problems(page)).toHaveCount(0);
});

test('d cannot be made zero by its three boxes, nor by its sliders', async ({ page }) => {
  await open(page, '#/explore?shape=plane&d=1,0,2&method=exact');
  await typeInto(page, 'd.x', '0');
  await typeInto(page, 'd.z', '0');
  await expect(problems(page)).toHaveText(/must not be zero, got \(0, 0, 0\)/);
  expect(await quantities(page)).toMatchObject({ 'd.x': '0', 'd.y': '0', 'd.z': '2' });
  await box(page, 'd.z').press('Escape');
  await typeInto(page, 'd.z', '0.05');
  await slider(page, 'd.z').press('ArrowLeft');
  await settle(page);
  expect(await quantities(page)).toMatchObject({ 'd.z': '0.05' });
  const rest = await slider(page, 'd.z').evaluate((input: HTMLInputElement) => input.valueAsNumber);
  expect(rest, 'the slider stays where the state is').toBe(0.05);
});

test('the arrows step in a box, and what was typed is shown again with the focus', async ({
  page,
}) => {
  await open(page, '#/explore?shape=cylinder&method=exact');
  const input = box(page, 'E.x');
  await input.press('ArrowUp');
  await settle(page);
  expect((await quantities(page))['E.x']).toBe('3.1');
  await input.press('Shift+ArrowDown');
  await settle(page);
  expect((await quantities(page))['E.x']).toBe('3.09');
  await typeInto(page, 'E.x', '1/3');
  await box(page, 'E.y').focus();
  await settle(page);
  await expect(input).toHaveValue(/^≈0\.3+$/);
  await input.focus();
  await settle(page);
  await expect(input).toHaveValue('1/3');
  await slider(page, 'E.x').press('ArrowRight');
  await input.focus();
  await settle(page);
  await expect(input, 'no longer what was typed').not.toHaveValue('1/3');
});

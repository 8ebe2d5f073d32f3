import { SHAPES, type Shape, type Vec3 } from '../../src/math/index.ts';
import { pick, type Random, randomSign, seeded, uniform, wide } from '../../src/math/rng.ts';
import { checkParam } from '../../src/math/shapes/params.ts';
import { byTurns } from '../unit/many.ts';
import { cone } from '../unit/math/shorthand.ts';
import { box, expectInLink, press, slider, typeInto } from './support/controls.ts';
import { expected, linkOf } from './support/expected.ts';
import {
  expectSaid,
  hashOf,
  linkWritten,
  NO_SCENE,
  open,
  quantities,
  settle,
  withoutScene,
} from './support/page.ts';
import { expect, visit as test } from './support/test.ts';

test.describe.configure({ mode: 'default' });
test.use({ provoked: NO_SCENE });
test.beforeEach(({ page }) => withoutScene(page));

const ODD = [-0, 0, 5e-324, -5e-324, 1.7976931348623157e308, 1 / 3, -1e21, 1e-7, 0.1] as const;
const SEED = 20261;

function anyNumber(random: Random): number {
  const kinds = [
    () => pick(random, ODD),
    () => wide(random),
    () => uniform(random, -5, 5),
  ] as const;
  return pick(random, kinds)();
}

const anyVector = (random: Random): Vec3 => [
  anyNumber(random),
  anyNumber(random),
  anyNumber(random),
];

/** A shape with any numbers that it allows. */
function anyShape(kind: Shape['kind'], random: Random): Shape {
  const params = SHAPES.find((shape) => shape.kind === kind)?.params ?? [];
  const values = params.map((param) => {
    for (;;) {
      const value =
        param.type === 'vector'
          ? anyVector(random)
          : param.type === 'number'
            ? anyNumber(random)
            : pick(random, ['x', 'y', 'z']);
      try {
        checkParam(param, value);
        return [param.key, value] as const;
      } catch {
        // A zero normal or a negative radius: another one.
      }
    }
  });
  return { kind, ...Object.fromEntries(values) } as Shape;
}

test(`a link restores the bits (seed ${SEED})`, async ({ page }) => {
  const random = seeded(SEED);
  for (const [i, { kind }] of byTurns([...SHAPES, ...SHAPES, ...SHAPES]).entries()) {
    const shape = anyShape(kind, random);
    const origin = anyVector(random);
    const direction = anyVector(random).map((x) => x || randomSign(random)) as unknown as Vec3;
    const ray = { origin, direction };
    const t = String(uniform(random, -3, 3));
    const given = linkOf(shape, ray, { method: 'exact', view: 'top', t });
    await open(page, given);
    const shown = await quantities(page);
    expect(shown, given).toMatchObject(expected(shape, ray, 'exact'));
    await linkWritten(page);
    await expectInLink(page, { shape: kind, method: 'exact', view: 'top', t });
    const canonical = await hashOf(page);
    // A new page and the same one read it alike: some of every kind of shape are loaded again.
    if (i % 5 === 0) {
      await page.reload();
      await page.locator('[data-quantity="class"]').waitFor();
      // The bead comes with the graph's code, after the page's own.
      const count = Object.keys(shown).length;
      await expect(page.locator('[data-quantity]')).toHaveCount(count);
      await settle(page);
    } else {
      await open(page, '#/explore');
      await open(page, canonical);
    }
    expect(await quantities(page), canonical).toEqual(shown);
    expect(await hashOf(page)).toBe(canonical);
  }
});

test('a link written by hand is understood, and completed with the method', async ({ page }) => {
  await open(page, '#/explore?shape=cone&E=4,1,0.5&d=-1,0,0&V=0,0,0&c=0.5');
  const ray = { origin: [4, 1, 0.5], direction: [-1, 0, 0] } as const;
  expect(await quantities(page)).toMatchObject(expected(cone([0, 0, 0], 0.5), ray, 'exact'));
  await expectInLink(page, { shape: 'cone', E: '4,1,0.5', d: '-1,0,0', V: '0,0,0', c: null });
  expect(new URLSearchParams((await hashOf(page)).split('?')[1]).get('method')).toBeTruthy();
  await open(page, '#/explore?E=1/3,sqrt(2),1e0&shape=cylinder');
  expect(await quantities(page)).toMatchObject({
    'E.x': String(1 / 3),
    'E.y': String(Math.SQRT2),
    r: '1.5',
  });
});

test('a hash typed into the address bar shows its state, also right after a change', async ({
  page,
}) => {
  await open(page, '#/explore?shape=cone&method=exact');
  await page.evaluate(() => {
    location.hash = '#/explore?shape=circle&E=1,2,3&method=stable';
  });
  await expect(page.locator('[data-quantity="E.z"]')).toHaveAttribute('data-value', '3');
  // The page writes its own link a moment after a change (and at once when it is left): a person's
  // must not get lost.
  await press(page, slider(page, 'E.x'), 'ArrowRight');
  await page.evaluate(() => {
    location.hash = '#/explore?shape=plane&E=5,5,5&method=exact';
    dispatchEvent(new Event('pagehide'));
  });
  await expectInLink(page, { shape: 'plane', E: '5,5,5' });
  await expect(page.locator('[data-quantity="E.z"]')).toHaveAttribute('data-value', '5');
});

test('what was typed is in the link, and in its box again after a reload', async ({ page }) => {
  await open(page, '#/explore?shape=cone&V=0,0,0&c=0.5&E=1,3,0&d=1,3,0&method=exact');
  await expect(page.locator('.as-typed')).toHaveCount(0);
  await typeInto(page, 'c', '1/3');
  await expectInLink(page, { c: '1/3' });
  await page.reload();
  await expect(page.locator('[data-quantity="typed.class"]')).toHaveAttribute(
    'data-value',
    'contained',
  );
  await box(page, 'c').focus();
  await expect(box(page, 'c')).toHaveValue('1/3');
  await typeInto(page, 'c', 'tan(30)');
  await expect(box(page, 'c')).toHaveAccessibleDescription(/radians; tan\(30 deg\) in degrees/);
  await expectInLink(page, { c: 'tan(30)' });
});

test('history does not grow while something is slid, typed or turned', async ({ page }) => {
  await open(page, '#/explore?shape=cone&method=exact');
  const before = await page.evaluate(() => history.length);
  for (let i = 0; i < 12; i++) await press(page, slider(page, 'E.x'), 'ArrowRight');
  await typeInto(page, 'c', '1/3');
  await expectInLink(page, { E: '4.2,1,1', c: '1/3', method: 'exact' });
  expect(await page.evaluate(() => history.length)).toBe(before);
});

test('Copy link puts the address on the clipboard, up to date', async ({ page, context }) => {
  await context.grantPermissions(['clipboard-read', 'clipboard-write']);
  await open(page, '#/explore?shape=hyperboloid&method=exact');
  await slider(page, 'a').press('ArrowRight');
  await page.getByRole('button', { name: 'Copy link' }).click();
  await expectSaid(page, /copied/);
  const copied = await page.evaluate(() => navigator.clipboard.readText());
  expect(copied).toBe(page.url());
  expect(copied).toContain('a=0.45');
});

/** What is wrong, the words that say so, and what is to be seen nevertheless. */
const BROKEN: readonly (readonly [hash: string, problem: RegExp, shown: Record<string, string>])[] =
  [
    ['#/explore?shape=cone&V=abc&c=2', /V.*'abc'/, { 'V.y': '3', c: '2' }],
    ['#/explore?shape=torus&E=1,2,3', /'torus'/, { 'E.z': '3' }],
    ['#/explore?shape=cylinder&E=1,2', /E.*'1,2'/, { 'E.x': '3', r: '1.5' }],
    ['#/explore?shape=cone&d=0,0,0', /d.*zero.*\(0, 0, 0\)/, { 'd.x': '-0.8' }],
    ['#/explore?shape=cylinder&r=-1&C=1,2,3', /r.*-1/, { r: '1.5', 'C.z': '3' }],
    ['#/explore?shape=cone&zoom=3', /'zoom'/, { c: '0.5' }],
    ['#/explore?shape=cone&view=behind', /view.*'behind'/, { c: '0.5' }],
    ['#/explore?shape=cone&method=guess', /method.*'guess'/, { c: '0.5' }],
    ['#/explore?shape=square&axis=w', /axis.*'w'/, { axis: 'x' }],
    ['#/explore?shape=cone&E=1e400,0,0', /E.*'1e400'/, { 'E.x': '3' }],
    ['#/explore?shape=plane&N=0,0,0', /N.*zero/, { 'N.x': '1' }],
    ['#/explore?unit=maybe', /unit.*'maybe'/, { 'd.x': '-0.8' }],
    ['#/nowhere?shape=circle', /'nowhere'/, { r: '2' }],
    ['#complete nonsense', /nonsense/, { c: '0.5' }],
  ];

test('a broken link opens the nearest state and quotes what was wrong', async ({ page }) => {
  const banner = page.locator('.problems');
  await open(page, '#/explore?shape=cone&method=exact');
  await expect(banner).toHaveCount(0);
  for (const [hash, problem, shown] of BROKEN) {
    await open(page, hash);
    await expect(banner, hash).toHaveText(problem);
    expect(await quantities(page), hash).toMatchObject(shown);
    await banner.getByRole('button').click();
    await expect(banner, hash).toHaveCount(0);
  }
  await open(page, '#/explore?shape=cone&V=abc&c=x&zoom=1');
  await expect(banner).toHaveText(/'abc'.*'x'.*'zoom'/);
  await open(page, '#/explore?shape=cone');
  await expect(banner).toHaveCount(0);
});

import { DEFAULT_METHOD } from '../../src/math/find-method.ts';
import { intersect, SHAPES } from '../../src/math/index.ts';
import { unitVector } from '../../src/math/unit.ts';
import { byTurns } from '../unit/many.ts';
import { cone } from '../unit/math/shorthand.ts';
import { CASES } from './support/cases.ts';
import { expected, expectedBead, linkOf } from './support/expected.ts';
import { NO_SCENE, open, quantities, readable, withoutScene } from './support/page.ts';
import { expect, visit as test } from './support/test.ts';

test.describe.configure({ mode: 'default' });

/** Words that only a program would say. ∞ is a number's name, 'Infinity' is not. */
const NO_WORDS = /\b(NaN|undefined|Infinity|null|true|false)\b|\[object/;

/** The page's own, the answer that all are measured by, and the two whose digits differ most. */
const METHODS = [...new Set([DEFAULT_METHOD, 'exact', 'textbook', 'stable'])];

const FLAT = ['contained', 'none', 'one'];
const CURVED = ['contained', 'none', 'one', 'tangent', 'two'];
/** B is 0 wherever A is on a cylinder; A is never 0 on a sphere. */
const NEVER: Readonly<Record<string, readonly string[]>> = {
  cylinder: ['one'],
  sphere: ['contained', 'one'],
};

test('the list has every shape, and every class that a shape can have', () => {
  for (const { kind } of SHAPES) {
    const cases = CASES.filter(({ shape }) => shape.kind === kind);
    const isCurved = cases.some(({ class: verdict }) => verdict === 'two');
    const can = (isCurved ? CURVED : FLAT).filter((c) => !NEVER[kind]?.includes(c));
    expect([...new Set(cases.map((c) => c.class))].sort(), kind).toEqual(can);
  }
});

/** One visit: a link to another shape, or of another class, leaves nothing of the one before. */
const see = (method: string, cases: typeof CASES) => {
  test(`by ${method}, what is shown is what the math module found`, async ({ page }) => {
    for (const { title, shape, ray, class: verdict } of cases) {
      const name = `${shape.kind}: ${title}`;
      expect(intersect(shape, ray, 'exact').class, name).toBe(verdict);
      await open(page, linkOf(shape, ray, { method }));
      const shown = await quantities(page);
      const t = shown['bead.t'];
      const bead = t === undefined ? {} : expectedBead(shape, ray, Number(t));
      expect.soft(shown, name).toEqual({ ...expected(shape, ray, method), ...bead });
      const lines = (await readable(page)).split('\n');
      const nonsense = lines.filter((line) => NO_WORDS.test(line));
      expect.soft(nonsense, name).toEqual([]);
    }
  });
};

for (const [n, method] of METHODS.entries()) see(method, byTurns(CASES, n, METHODS.length));

test('the bead stands where the link says', async ({ page }) => {
  const shape = cone([0, 3, 0], 0.5);
  const ray = { origin: [3, 1, 1], direction: [-0.8, -0.2, -0.3] } as const;
  for (const t of [0, 1 / 3, -2.5, 1e7, 4e-320]) {
    await open(page, linkOf(shape, ray, { t: String(t), method: 'exact' }));
    expect(await quantities(page)).toMatchObject(expectedBead(shape, ray, t));
  }
});

test('with unit d the kernel gets, and the page shows, the rounded unit vector', async ({
  page,
}) => {
  for (const { title, shape, ray } of CASES.filter((_, i) => i % 6 === 0)) {
    await open(page, linkOf(shape, ray, { unit: '1', method: 'exact' }));
    const unit = { origin: ray.origin, direction: unitVector(ray.direction) };
    expect(await quantities(page), title).toMatchObject(expected(shape, unit, 'exact'));
  }
});

test.describe('boxes', () => {
  test.use({ provoked: NO_SCENE });

  test('no box cuts its number: it is shown whole, or rounded with ≈', async ({ page }) => {
    await withoutScene(page);
    for (const numbers of [
      'E=-0.500000001,3e-9,2.9483721&d=-8.7654321e-10,1/3,-123456.789&C=-1.23e-300,100000' +
        ',0.1&r=8.7e-10',
      'E=3,1,1&d=-0.8,-0.2,-0.3&C=1234567,-1e300,-0.000123456&r=12345.678',
    ]) {
      await open(page, `#/explore?shape=cylinder&${numbers}`);
      const cut = await page
        .locator('input.number')
        .evaluateAll((inputs) =>
          (inputs as HTMLInputElement[])
            .filter(({ scrollWidth, clientWidth }) => scrollWidth > clientWidth)
            .map(({ value }) => value),
        );
      expect(cut).toEqual([]);
    }
  });
});

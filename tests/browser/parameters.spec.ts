import { SHAPES, type Vec3 } from '../../src/math/index.ts';
import { RAY_PARAMS } from '../../src/state/state.ts';
import { box, expectInLink, paste, press, resetOf, slider, typeInto } from './support/controls.ts';
import { linkOf, text } from './support/expected.ts';
import { NO_SCENE, open, quantities, settle, withoutScene } from './support/page.ts';
import {
  currentOf,
  expectShown,
  initial,
  type Moved,
  type MovedValue,
  movedParams,
  type Question,
  withValue,
} from './support/question.ts';
import { expect, visit as test } from './support/test.ts';

test.describe.configure({ mode: 'default' });
test.use({ provoked: NO_SCENE });
test.beforeEach(({ page }) => withoutScene(page));

/** What a person types, the double that it means, and what the link has of it. */
const TYPED: readonly (readonly [string, number, string])[] = [
  ['1/3', 1 / 3, '1/3'],
  ['sqrt(2)', Math.sqrt(2), 'sqrt(2)'],
  ['1e7', 1e7, '1e7'],
  ['2^-40', 2 ** -40, '2^-40'],
  ['0,75', 0.75, '0.75'],
  ['+3', 3, '3'],
];
const TYPED_NEGATIVE: readonly (readonly [string, number, string])[] = [
  ['-2^-40', -(2 ** -40), '-2^-40'],
  ['−3', -3, '-3'],
  ['-0,25', -0.25, '-0.25'],
];

const mapped = (value: MovedValue, f: (x: number, i: number) => number): MovedValue =>
  typeof value === 'number' ? f(value, 0) : (value.map(f) as unknown as Vec3);

/**
 * Every parameter two steps away from where it begins, so that a reset of one has others to leave
 * alone.
 */
function moved(kind: (typeof SHAPES)[number]['kind']): Question {
  return movedParams(kind).reduce<Question>((question, param) => {
    const away = mapped(param.initial, (x) => Number((x + 2 * param.step).toPrecision(12)));
    return withValue(question, param, away);
  }, initial(kind));
}

/** The names of a parameter's boxes: E.x, E.y, E.z or r. */
const names = ({ symbol, type }: Moved): string[] =>
  type === 'number' ? [symbol] : ['x', 'y', 'z'].map((axis) => `${symbol}.${axis}`);

for (const [turn, { kind }] of SHAPES.entries()) {
  test(`${kind}: each parameter changes exactly what depends on it`, async ({ page }) => {
    const start = moved(kind);
    await open(page, linkOf(start.shape, start.ray, { method: 'exact' }));
    await expectShown(page, start);
    let count = 0;
    for (const param of movedParams(kind)) {
      let now = start;
      const written: string[] = [];
      const put = (i: number, x: number): void => {
        now = withValue(
          now,
          param,
          mapped(currentOf(now, param), (old, k) => (k === i ? x : old)),
        );
      };
      const mayBeNegative = param.type === 'vector' || param.least === undefined;
      for (const [i, name] of names(param).entries()) {
        const from = [currentOf(now, param)].flat()[i] as number;
        const [key, sign] = count % 2 ? ['ArrowDown', -1] : ['ArrowRight', 1];
        // The slider and the box by turns, on the next shape the other way round.
        if ((count + turn) % 2 === 0) {
          const stepped = Number((from + Number(sign) * param.step).toPrecision(12)) + 0;
          await press(page, slider(page, name), String(key));
          put(i, stepped);
          await expectShown(page, now);
          written.push(text(stepped));
          count++;
          continue;
        }
        const list = mayBeNegative && count % 3 === 2 ? TYPED_NEGATIVE : TYPED;
        const [typed, x, linked] = list[count++ % list.length] ?? ['1', 1, '1'];
        written.push(linked);
        await typeInto(page, name, typed);
        put(i, x);
        await expectShown(page, now);
        const end = Math.min(Math.max(x, param.range[0]), param.range[1]);
        const rest = await slider(page, name).evaluate((at: HTMLInputElement) => at.valueAsNumber);
        expect(rest, `the slider of ${name} for ${typed}`).toBeCloseTo(end, 12);
      }
      await expectInLink(page, { shape: kind, [param.symbol]: written.join(',') });
      await resetOf(page, param.symbol).click();
      await settle(page);
      await expectShown(page, withValue(start, param, param.initial));
      // What links have always meant without the key is left out.
      const linked = param.linkDefault === undefined ? null : String(param.initial);
      await expectInLink(page, { [param.symbol]: linked });
      await open(page, linkOf(start.shape, start.ray, { method: 'exact' }));
    }
  });
}

test('a slider is dragged: everything follows, and the value is on its step', async ({ page }) => {
  const start = initial('cylinder');
  await open(page, linkOf(start.shape, start.ray, { method: 'exact' }));
  const track = await slider(page, 'E.y').boundingBox();
  if (!track) throw new Error('the slider is not shown');
  const at = (share: number): [number, number] => [
    track.x + share * track.width,
    track.y + track.height / 2,
  ];
  await page.mouse.move(...at(0.6));
  await page.mouse.down();
  for (const share of [0.5, 0.4, 0.3, 0.2, 0.25]) {
    await page.mouse.move(...at(share));
    await settle(page);
    const y = Number((await quantities(page))['E.y']);
    expect(y * 10).toBe(Math.round(y * 10));
    await expectShown(page, withValue(start, RAY_PARAMS.E, [2.5, y, 2]));
  }
  await page.mouse.move(track.x + track.width + 300, track.y);
  await page.mouse.up();
  await settle(page);
  expect((await quantities(page))['E.y']).toBe('5');
  await expectInLink(page, { E: '2.5,5,2' });
});

test('three numbers pasted into any box of E or d fill all three', async ({ page, context }) => {
  await open(page, '#/explore?shape=cone&method=exact');
  const pasted: [string, string, Vec3][] = [
    ['E.x', '(1, 2, 3)', [1, 2, 3]],
    ['E.z', '1,5; 2; -3', [1.5, 2, -3]],
    ['d.y', 'vec3(1.0, −0.5, 1/4)', [1, -0.5, 0.25]],
    ['d.x', '[-0.1\t0.2\t0.3]', [-0.1, 0.2, 0.3]],
    ['V.y', '0 1 0', [0, 1, 0]],
  ];
  for (const [name, given, [x, y, z]] of pasted) {
    await paste(page, name, given);
    const letter = name.charAt(0);
    const wanted = { [`${letter}.x`]: text(x), [`${letter}.y`]: text(y), [`${letter}.z`]: text(z) };
    expect(await quantities(page), given).toMatchObject(wanted);
  }
  await context.grantPermissions(['clipboard-read', 'clipboard-write']);
  await page.evaluate(() => navigator.clipboard.writeText('7, 8, 9'));
  await press(page, box(page, 'E.y'), 'ControlOrMeta+v');
  expect(await quantities(page)).toMatchObject({ 'E.x': '7', 'E.y': '8', 'E.z': '9' });
  await paste(page, 'd.x', '(0, 0, 0)');
  expect(await quantities(page), 'a zero direction is not taken').toMatchObject({ 'd.x': '-0.1' });
});

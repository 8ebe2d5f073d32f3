import fc from 'fast-check';
import { describe, expect, test } from 'vitest';
import { METHODS } from '../../../../src/math/index.ts';
import { addThing, remove } from '../../../../src/scene/edit.ts';
import { EFFECTS } from '../../../../src/scene/effects/index.ts';
import { sceneToJson } from '../../../../src/scene/json.ts';
import { PRESETS } from '../../../../src/scene/presets/index.ts';
import { BUDGET, budgetWords } from '../../../../src/state/picture/budget.ts';
import { causeWords } from '../../../../src/state/picture/compare-words.ts';
import { AGAINST, lessWords, otherSide } from '../../../../src/state/picture/comparison.ts';
import { newThing } from '../../../../src/state/picture/edits.ts';
import { sceneFromText, textOfScene } from '../../../../src/state/picture/scene-link.ts';
import {
  changed,
  forcedTexts,
  pictureSettings,
  readPicture,
} from '../../../../src/state/picture/settings.ts';
import { readStartRule, startText } from '../../../../src/state/picture/start-rule.ts';
import { decode, encode } from '../../../../src/state/url.ts';
import { DEFAULT_SETTINGS } from '../../../../src/tracer/types.ts';
import { OLD_SCENES } from './old-scenes.ts';

const SEED = 20261;

describe('a scene in a link', () => {
  test.each(PRESETS.map((preset) => [preset.id, preset] as const))('%s by its id', (id, preset) => {
    expect(textOfScene(preset.scene)).toBe(id);
    expect(sceneFromText(id)).toBe(preset.scene);
  });

  test('an edited one comes back the same, through the hash, −0 and all', () => {
    const [first] = PRESETS;
    if (!first) throw new RangeError('no scene');
    const cone = { ...newThing(first.scene, 'cone'), id: 'mine' };
    for (const { scene } of PRESETS) {
      const camera = { ...scene.camera, eye: [-0, 1 / 3, 7e-9] as const };
      const edited = { ...addThing(scene, cone), camera };
      const state = decode(`#/picture?scene=${textOfScene(edited)}`);
      const again = decode(encode(state)).settings.picture.scene ?? '';
      const back = sceneFromText(again);
      expect(back).toEqual(edited);
      expect(Object.is(back.camera.eye[0], -0)).toBe(true);
    }
  });

  test.each(OLD_SCENES)('an old one opens as $scene.title, and is still its text', (old) => {
    expect(sceneFromText(old.link)).toEqual(old.scene);
    expect(textOfScene(old.scene)).toBe(old.link);
  });

  test('stays short enough for an address', () => {
    const lengths = PRESETS.map(({ scene }) => textOfScene({ ...scene }).length);
    expect(Math.max(...lengths)).toBeLessThan(4000);
  });

  test.each([
    ['nothing', "there is no scene 'nothing'"],
    ['~', "'~' is not a packed scene"],
    ['~%%%', 'is not a packed scene'],
    ['~AAAA', 'is not a packed scene'],
    [`~${'A'.repeat(40_000)}`, 'at most 30000 letters, got 40000'],
  ])('%s is refused in words', (text, words) => {
    expect(() => sceneFromText(text)).toThrow(words);
  });

  test('a packed text that is no scene is refused as a scene is', () => {
    const [first] = PRESETS;
    const scene = { ...first?.scene, title: 3 } as never;
    expect(() => sceneFromText(textOfScene(scene))).toThrow('title must be a text');
  });

  test('a link with anything in it never throws', () => {
    fc.assert(
      fc.property(fc.string(), fc.string(), (key, value) => {
        readPicture({ scene: value, [key]: value });
        pictureSettings({ scene: `~${value}`, [key]: value });
      }),
      { seed: SEED, numRuns: 300 },
    );
  });
});

describe('settings', () => {
  test('what a link leaves out has its default', () => {
    const settings = pictureSettings({});
    expect(settings).toMatchObject({
      width: 752,
      height: 424,
      samples: 1,
      forced: {},
      against: null,
    });
    expect(settings.start).toEqual({ rule: 'from' });
  });

  test('what is right is kept, what is wrong is dropped and quoted', () => {
    const given = {
      size: '160x90',
      samples: '3',
      split: '200',
      pixel: '1,x',
      zoom: '2',
      on: 'fog',
    };
    const { settings, problems } = readPicture(given);
    expect(settings).toEqual({ size: '160x90' });
    expect(problems).toHaveLength(5);
    for (const word of ['3', '200', '1,x', 'zoom', 'fog']) {
      expect(problems.join('\n')).toContain(`'${word}'`);
    }
  });

  test.each(['0x90', '160x0', '9999x90', '160', 'axb', '-1x2', '1e2x3'])('size %s', (size) => {
    expect(readPicture({ size }).problems).toHaveLength(1);
    expect(pictureSettings({ size })).toMatchObject({ width: 752, height: 424 });
  });

  test('a default that a link spells out stays: opening it is no step that undo takes back', () => {
    const given = { scene: 'cone-on-mirror', split: '50' };
    expect(readPicture(given)).toEqual({ settings: given, problems: [] });
  });

  test('a pixel outside of the picture is no pixel', () => {
    expect(pictureSettings({ size: '160x90', pixel: '159,89' }).pixel).toEqual([159, 89]);
    expect(pictureSettings({ size: '160x90', pixel: '160,0' }).pixel).toBeNull();
    expect(pictureSettings({ size: '160x90', pixel: '0,90' }).pixel).toBeNull();
    expect(readPicture({ size: '160x90', pixel: '9999,1' })).toEqual({
      settings: { size: '160x90' },
      problems: ["opened without pixel: '9999,1' is outside of a picture of 160 × 90"],
    });
    expect(readPicture({ size: '160x90', pixel: '159,89' }).problems).toEqual([]);
  });

  test('a default is taken out of the link', () => {
    expect(changed({ size: '752x424', split: '20' })).toEqual({ size: null, split: '20' });
  });

  test('a scene keeps its identity while its text is the same', () => {
    const [first] = PRESETS;
    const text = textOfScene({ ...(first as (typeof PRESETS)[number]).scene });
    expect(pictureSettings({ scene: text }).scene).toBe(pictureSettings({ scene: text }).scene);
  });
});

describe('forcing', () => {
  test('on, off and back', () => {
    const on = forcedTexts({}, 'reflection', 'on');
    expect(on).toEqual({ on: 'reflection', off: '' });
    const { forced } = pictureSettings(on);
    expect(forcedTexts(forced, 'shadow', 'off')).toEqual({ on: 'reflection', off: 'shadow' });
    expect(forcedTexts(forced, 'reflection', 'off')).toEqual({ on: '', off: 'reflection' });
    expect(forcedTexts(forced, 'reflection', 'no')).toEqual({ on: '', off: '' });
  });
});

describe('the other side of a comparison', () => {
  const texts = [
    ...['start:none', 'start:from', 'start:1e-9', 'off:boxes', 'bounces:0', 'bounces:64'],
    ...METHODS.map(({ id }) => `method:${id}`),
    ...EFFECTS.flatMap(({ id }) => [`on:${id}`, `off:${id}`]),
  ];
  test.each(texts)('%s comes back', (text) => {
    expect(AGAINST.write(AGAINST.read(text))).toBe(text);
  });

  test.each(['method:nothing', 'start:-1', 'start:', 'off:fog', 'x', 'off:'])(
    '%s is refused',
    (text) => {
      expect(() => AGAINST.read(text)).toThrow(/^['"]?.+ is /);
    },
  );

  test('differs in that one thing', () => {
    for (const text of texts) {
      const against = AGAINST.read(text);
      if (!against) throw new Error(text);
      const other = otherSide(DEFAULT_SETTINGS, against);
      const keys = Object.keys(other) as (keyof typeof other)[];
      const differing = keys.filter(
        (key) => JSON.stringify(other[key]) !== JSON.stringify(DEFAULT_SETTINGS[key]),
      );
      const isSame = text === 'start:from' || text === `method:${DEFAULT_SETTINGS.method}`;
      expect(differing, text).toEqual(isSame ? [] : [expect.any(String)]);
    }
  });
});

test('the whole picture leaves nothing out, and is said to differ in what this one does', () => {
  const against = AGAINST.read('whole');
  if (against?.change !== 'whole') throw new Error('no comparison with the whole');
  expect(AGAINST.write(against)).toBe('whole');
  expect(otherSide(DEFAULT_SETTINGS, against)).toEqual({ ...DEFAULT_SETTINGS, forced: {} });
  const less = { forced: { shadow: 'off' }, bounces: 3, method: 'moment' } as const;
  expect(otherSide({ ...DEFAULT_SETTINGS, ...less }, against)).toEqual(DEFAULT_SETTINGS);
  expect(lessWords(DEFAULT_SETTINGS)).toBe('');
  expect(lessWords(less)).toBe('without shadows; at most 3 bounces; by moment');
});

test('a comparison with what the picture is already says so', () => {
  const scene = PRESETS.find(({ id }) => id === 'shadows.2')?.scene;
  if (!scene) throw new Error('no such preset');
  const cause = (text: string, main: Partial<typeof DEFAULT_SETTINGS> = {}): string => {
    const against = AGAINST.read(text);
    return against ? causeWords(scene, { ...DEFAULT_SETTINGS, ...main }, against) : '';
  };
  const same = 'Both sides are the same picture.';
  const { method } = DEFAULT_SETTINGS;
  for (const text of [`method:${method}`, 'start:from', 'bounces:64', 'whole', 'on:shadow']) {
    expect(cause(text), text).toBe(same);
  }
  expect(cause('off:refraction')).toBe(same);
  expect(cause('off:shadow', { forced: { shadow: 'off' } })).toBe(same);
  expect(cause('off:shadow')).toContain('only the left one is without shadows');
  expect(cause('on:reflection')).toContain('only the left one has reflection forced on');
  expect(cause('whole', { bounces: 3 })).toBe('Left: the whole picture. Right: at most 3 bounces.');
  for (const text of ['off:boxes', 'bounces:2', 'start:none', 'method:textbook32']) {
    expect(cause(text), text).not.toBe(same);
  }
});

describe('a budget', () => {
  const texts = BUDGET.differences.flatMap(({ value: difference }) =>
    BUDGET.parts.map(({ value: part }) => BUDGET.write(difference, part)),
  );
  test.each(texts)('%s comes back', (text) => {
    const budget = BUDGET.read(text);
    if (!budget) throw new Error(text);
    expect(BUDGET.write(...BUDGET.texts(budget))).toBe(text);
    expect(budgetWords(budget)).toMatch(/^no more than .+ (every pixel|of the pixels)$/);
  });
  test.each(['x', '3%', '1%,7', '1%,1,1', '0.5,'.repeat(2)])('%s is refused', (text) => {
    expect(() => BUDGET.read(text)).toThrow(`'${text}' is not a budget`);
  });
});

describe('the start rule', () => {
  test.each(['from', 'none', '1e-9', '0.3', '5e-324', '1e300'])('%s', (text) => {
    expect(startText(readStartRule(text))).toBe(text);
  });
  test.each(['0', '-1', 'no', '', 'Infinity', 'NaN'])('%s is refused', (text) => {
    expect(() => readStartRule(text)).toThrow('is not from, none or a positive number');
  });
});

test('without the mirror the scene is another one, and says so', () => {
  const preset = PRESETS.find(({ id }) => id === 'cone-on-mirror');
  if (!preset) throw new Error('no such preset');
  const text = textOfScene(remove(preset.scene, 'mirror'));
  expect(text.startsWith('~')).toBe(true);
  expect(sceneToJson(sceneFromText(text))).not.toContain('"id": "mirror"');
});

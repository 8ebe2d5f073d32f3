import { InvalidInput } from '../../math/index.ts';
import { quote } from '../../math/shapes.ts';
import { EFFECTS, type EffectId } from '../../scene/effects/index.ts';
import type { Forced } from '../../scene/effects/plan.ts';
import type { Scene } from '../../scene/types.ts';
import type { StartRule } from '../../tracer/types.ts';
import type { Settings } from '../state.ts';
import { readBounces } from './bounces.ts';
import { BUDGET, type Budget } from './budget.ts';
import { AGAINST, type Against } from './comparison.ts';
import { DRAG_PLANES, type DragPlane } from './drag.ts';
import { DEFAULT_SCENE, sceneFromText } from './scene-link.ts';
import { readStartRule } from './start-rule.ts';

/** The settings of the Picture page, which its link carries. */
export interface PictureSettings {
  /** As the link has it: a preset's id, or an edited scene. */
  readonly sceneText: string;
  readonly scene: Scene;
  readonly width: number;
  readonly height: number;
  readonly samples: number;
  readonly lightSamples: number;
  readonly start: StartRule;
  readonly forced: Forced;
  /** Most bounces of a ray. */
  readonly bounces: number;
  /** The other side of a comparison: the same picture with one thing changed. */
  readonly against: Against | null;
  /** Position of the divider, in percent of the width. */
  readonly split: number;
  /** What the map beside the picture shows; 'both', an old word, for questions. */
  readonly show: 'both' | 'roots' | 'rays' | 'errors';
  /** What drags of things and lights keep to. */
  readonly along: DragPlane;
  /** The pixel whose rays are followed. */
  readonly pixel: readonly [x: number, y: number] | null;
  /** Whether it is measured how the price grows. */
  readonly grows: boolean;
  /** What the cheapest picture may differ by; null if none is looked for. */
  readonly budget: Budget | null;
}

export const SIZES = ['160x90', '320x180', '640x360', '752x424', '960x540', '1280x720'] as const;
export const SAMPLES = [1, 4, 9, 16] as const;
export const LIGHT_SAMPLES = [4, 9, 16, 25, 64] as const;
const MOST_SIDE = 2000;

interface Key {
  readonly initial: string;
  /** Throws InvalidInput that quotes the text. */
  readonly read: (text: string) => unknown;
}

const KEYS = {
  scene: { initial: DEFAULT_SCENE, read: memoised(sceneFromText) },
  size: { initial: '752x424', read: readSize },
  samples: { initial: '1', read: oneOf(SAMPLES) },
  light: { initial: '16', read: oneOf(LIGHT_SAMPLES) },
  start: { initial: 'from', read: readStartRule },
  on: { initial: '', read: readEffects },
  off: { initial: '', read: readEffects },
  bounces: { initial: '64', read: readBounces },
  against: { initial: '', read: AGAINST.read },
  split: { initial: '50', read: readPercent },
  show: { initial: 'both', read: word(['both', 'errors', 'roots', 'rays']) },
  pixel: { initial: '', read: readPixel },
  growth: { initial: '', read: word(['', 'on']) },
  budget: { initial: '', read: BUDGET.read },
  drag: { initial: 'floor', read: word(DRAG_PLANES) },
} as const satisfies Record<string, Key>;

export type PictureKey = keyof typeof KEYS;

/** The settings with every default put in; what cannot be read has its default. */
export function pictureSettings(settings: Settings): PictureSettings {
  const value = <K extends PictureKey>(key: K): ReturnType<(typeof KEYS)[K]['read']> => {
    const { initial, read } = KEYS[key];
    try {
      return read(settings[key] ?? initial) as ReturnType<(typeof KEYS)[K]['read']>;
    } catch (error) {
      if (!(error instanceof InvalidInput)) throw error;
      return read(initial) as ReturnType<(typeof KEYS)[K]['read']>;
    }
  };
  const scene = value('scene');
  const [width, height] = value('size');
  const pixel = value('pixel');
  return {
    scene,
    sceneText: readable('scene', settings.scene) ? (settings.scene ?? '') : DEFAULT_SCENE,
    width,
    height,
    samples: value('samples'),
    lightSamples: value('light'),
    start: value('start'),
    forced: forcedOf(value('on'), value('off')),
    bounces: value('bounces'),
    against: value('against'),
    split: value('split'),
    show: value('show') as PictureSettings['show'],
    along: value('drag') as DragPlane,
    pixel: pixel && pixel[0] < width && pixel[1] < height ? pixel : null,
    grows: value('growth') === 'on',
    budget: value('budget'),
  };
}

/** The valid settings of a link, and what is wrong with the others. */
export function readPicture(settings: Settings): {
  readonly settings: Settings;
  readonly problems: readonly string[];
} {
  const problems: string[] = [];
  const usable: [string, string][] = [];
  for (const [key, text] of Object.entries(settings)) {
    if (!Object.hasOwn(KEYS, key)) {
      problems.push(`${quote(key)} means nothing for a picture`);
      continue;
    }
    try {
      KEYS[key as PictureKey].read(text);
      usable.push([key, text]);
    } catch (error) {
      if (!(error instanceof InvalidInput)) throw error;
      problems.push(`opened without ${key}: ${error.message}`);
    }
  }
  const found = Object.fromEntries(usable);
  const { width, height, pixel } = pictureSettings(found);
  if (found.pixel && !pixel) {
    problems.push(
      `opened without pixel: ${quote(found.pixel)} is outside of a picture of ${width} × ${height}`,
    );
    delete found.pixel;
  }
  return { settings: found, problems };
}

/** Values for the action 'settings': null for a default, which the link leaves out. */
export function changed(
  values: Readonly<Partial<Record<PictureKey, string>>>,
): Readonly<Record<string, string | null>> {
  const pairs = Object.entries(values).map(([key, text]) => [
    key,
    text === KEYS[key as PictureKey].initial ? null : text,
  ]);
  return Object.fromEntries(pairs);
}

/** The texts of the keys `on` and `off` after an effect is forced, or no longer is ('no'). */
export function forcedTexts(
  forced: Forced,
  id: EffectId,
  how: 'on' | 'off' | 'no',
): Readonly<Record<'on' | 'off', string>> {
  return textsOf({ ...forced, [id]: how });
}

/** The texts of the keys `on` and `off`. */
export function textsOf(
  all: Readonly<Partial<Record<EffectId, string>>>,
): Readonly<Record<'on' | 'off', string>> {
  const texts = (word: string): string =>
    EFFECTS.filter((effect) => all[effect.id] === word)
      .map((effect) => effect.id)
      .join(',');
  return { on: texts('on'), off: texts('off') };
}

function readable(key: PictureKey, text: string | undefined): boolean {
  try {
    if (text !== undefined) KEYS[key].read(text);
    return text !== undefined;
  } catch {
    return false;
  }
}

function forcedOf(on: readonly EffectId[], off: readonly EffectId[]): Forced {
  return Object.fromEntries([
    ...on.map((id) => [id, 'on'] as const),
    ...off.map((id) => [id, 'off'] as const),
  ]);
}

function readEffects(text: string): readonly EffectId[] {
  const words = text === '' ? [] : text.split(',');
  return words.map((word) => {
    const found = EFFECTS.find(({ id }) => id === word);
    if (!found) throw new InvalidInput(`${quote(word)} is not an effect`);
    return found.id;
  });
}

function readSize(text: string): readonly [number, number] {
  const [, w, h] = /^(\d{1,5})x(\d{1,5})$/.exec(text) ?? [];
  const [width, height] = [Number(w), Number(h)];
  if (!(width >= 1 && height >= 1 && width <= MOST_SIDE && height <= MOST_SIDE)) {
    throw new InvalidInput(`${quote(text)} is not a size like 640x360`);
  }
  return [width, height];
}

function readPixel(text: string): readonly [number, number] | null {
  if (text === '') return null;
  const [, x, y] = /^(\d{1,4}),(\d{1,4})$/.exec(text) ?? [];
  if (x === undefined) throw new InvalidInput(`${quote(text)} is not a pixel like 142,300`);
  return [Number(x), Number(y)];
}

function readPercent(text: string): number {
  const percent = Number(text);
  if (!/^\d+(\.\d+)?$/.test(text) || percent > 100) {
    throw new InvalidInput(`${quote(text)} is not a percentage`);
  }
  return percent;
}

function oneOf(numbers: readonly number[]) {
  return (text: string): number => {
    const found = numbers.find((n) => String(n) === text);
    if (found === undefined)
      throw new InvalidInput(`${quote(text)} is none of ${numbers.join(', ')}`);
    return found;
  };
}

function word(words: readonly string[]) {
  return (text: string): string => {
    if (!words.includes(text))
      throw new InvalidInput(`${quote(text)} is not ${words.join(' or ')}`);
    return text;
  };
}

/** Caches the latest few results, so that a scene keeps its identity while its text is the same. */
function memoised<T>(read: (text: string) => T): (text: string) => T {
  const known = new Map<string, T>();
  return (text) => {
    const found = known.get(text) ?? read(text);
    known.delete(text);
    known.set(text, found);
    const [oldest] = known.keys();
    if (known.size > 8 && oldest !== undefined) known.delete(oldest);
    return found;
  };
}

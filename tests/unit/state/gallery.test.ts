import { describe, expect, test } from 'vitest';
import { intersect } from '../../../src/math/index.ts';
import { GALLERY } from '../../../src/state/gallery/index.ts';
import { rayOf, shapeOf } from '../../../src/state/state.ts';
import { decode } from '../../../src/state/url.ts';

test('there are at least 20 presets, each named once', () => {
  expect(GALLERY.length).toBeGreaterThanOrEqual(20);
  expect(new Set(GALLERY.map(({ id }) => id)).size).toBe(GALLERY.length);
});

describe.each(GALLERY.map((preset) => [preset.id, preset] as const))('%s', (_, preset) => {
  const state = decode(preset.link);
  test('opens without complaint', () => expect(state.problems).toEqual([]));
  test(`is ${preset.class}`, () => {
    expect(intersect(shapeOf(state), rayOf(state), 'exact').class).toBe(preset.class);
  });
  test('says in one sentence what to look at', () => {
    expect(preset.look.endsWith('.')).toBe(true);
    expect(preset.look.split(/\.\s/)).toHaveLength(1);
  });
});

test('every shape has a hit, and every class appears', () => {
  const kinds = GALLERY.filter((p) => p.class !== 'none' && p.class !== 'contained').map(
    ({ link }) => decode(link).kind,
  );
  expect(new Set(kinds).size).toBe(6);
  expect(new Set(GALLERY.map((p) => p.class)).size).toBe(5);
});

test('the far and the nearly parallel one fail by the textbook formula as they say', () => {
  const found = (id: string, method: string) => {
    const state = decode(GALLERY.find((p) => p.id === id)?.link ?? '');
    return intersect(shapeOf(state), rayOf(state), method);
  };
  expect(found('cylinder-far', 'textbook').class).not.toBe('two');
  const [rough] = found('cone-near-generator', 'textbook').hits;
  const [right] = found('cone-near-generator', 'exact').hits;
  expect(rough?.t).not.toBe(right?.t);
});

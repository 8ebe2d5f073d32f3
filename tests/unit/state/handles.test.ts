import { describe, expect, test } from 'vitest';
import { SHAPES } from '../../../src/math/index.ts';
import { createDerive } from '../../../src/state/derive.ts';
import { exploreDetails } from '../../../src/state/explore-details.ts';
import type { Handle, PointHandle, ReachHandle } from '../../../src/state/handles.ts';
import { INITIAL } from '../../../src/state/state.ts';
import { update } from '../../../src/state/update.ts';
import { decode } from '../../../src/state/url.ts';

const at = (link: string) => decode(`#/explore?method=exact&${link}`, INITIAL);
const handlesAt = (link: string): readonly Handle[] =>
  createDerive(() => exploreDetails)(at(link)).scene.handles;
const named = (link: string, symbol: string): Handle => {
  const found = handlesAt(link).find((handle) => handle.symbol === symbol);
  if (!found) throw new Error(`${symbol} has no handle in ${link}`);
  return found;
};

const LINKS = SHAPES.map(({ kind }) => `shape=${kind}`);

describe('every shape', () => {
  test.each([
    ['plane', 'E d P'],
    ['cylinder', 'E d C r'],
    ['cone', 'E d V c'],
    ['hyperboloid', 'E d C a r'],
    ['circle', 'E d C r'],
    ['square', 'E d P L'],
  ])('%s: %s', (kind, symbols) => {
    expect(
      handlesAt(`shape=${kind}`)
        .map(({ symbol }) => symbol)
        .join(' '),
    ).toBe(symbols);
  });

  test.each(LINKS)('%s: a reach read back gives the value', (link) => {
    for (const handle of handlesAt(link)) {
      if (handle.type !== 'reach') continue;
      expect(handle.grip.value(handle.grip.reach)).toBeCloseTo(handle.value, 12);
    }
  });

  test.each(LINKS)('%s: the action of a handle moves what it names, and nothing else', (link) => {
    const before = at(link);
    for (const handle of handlesAt(link)) {
      const value = handle.type === 'point' ? ([0.25, 0.5, 2] as const) : 0.75;
      const after = update(before, handle.action(value));
      const moved = createDerive(() => exploreDetails)(after).scene.handles;
      expect(moved.find(({ symbol }) => symbol === handle.symbol)?.value).toEqual(value);
      for (const other of moved) {
        if (other.symbol === handle.symbol) continue;
        const was = named(link, other.symbol);
        expect(other.value).toEqual(was.value);
      }
    }
  });

  test.each(LINKS)('%s: what the math module refuses is refused, in its words', (link) => {
    for (const handle of handlesAt(link)) {
      const nan = handle.type === 'point' ? ([Number.NaN, 0, 0] as const) : Number.NaN;
      expect(handle.refusal(nan)).toMatch(/finite/);
      expect(handle.refusal(handle.value)).toBeNull();
    }
    expect(named(link, 'd').refusal([0, 0, 0])).toMatch(/direction/);
  });
});

test('the tip of d stands at E + d; with a unit d at the kernel’s own', () => {
  const free = named('E=1,2,3&d=3,0,4', 'd') as PointHandle;
  expect(free.at).toEqual([4, 2, 7]);
  const unit = named('E=1,2,3&d=3,0,4&unit=1', 'd') as PointHandle;
  expect(unit.at).toEqual([1.6, 2, 3.8]);
  expect(unit.value, 'a drag sets the raw d').toEqual([3, 0, 4]);
  expect(unit.here).toEqual([0.6, 0, 0.8]);
});

test('negative radii and sides are refused; a slope keeps its sign', () => {
  expect(named('shape=cylinder', 'r').refusal(-0.1)).toMatch(/radius must be ≥ 0/);
  expect(named('shape=square', 'L').refusal(-0.1)).toMatch(/side must be ≥ 0/);
  const steep = named('shape=cone&c=-0.5', 'c') as ReachHandle;
  expect(steep.grip.value(2 * steep.grip.reach)).toBeCloseTo(-1, 12);
});

test('a hyperboloid can be closed to an ellipsoid by its own handle', () => {
  const open = named('shape=hyperboloid&a=0.4&r=1', 'a') as ReachHandle;
  expect(open.grip.value(1), 'as wide as the waist').toBeCloseTo(0, 12);
  expect(open.grip.value(0)).toBeLessThan(-1);
});

describe('tangency', () => {
  test('E is exactly tangent on the grid', () => {
    const { tangency } = named('shape=cylinder&C=0,1,0&r=1.5&E=3,1,1&d=-1,0,0', 'E');
    expect(tangency?.exact([3, 1, 1.5])).toMatchObject({ sign: 0, isTangent: true });
    expect(tangency?.exact([3, 1, 1.4]).sign).toBe(1);
    expect(tangency?.exact([2.7, 4, 1.6]).sign).toBe(-1);
    expect(tangency?.quick([3, 1, 1.4])).toBeGreaterThan(0);
  });

  test('values that are not allowed have no sign, and nothing throws', () => {
    const { tangency } = named('shape=cylinder', 'd');
    expect(tangency?.exact([0, 0, 0]).sign).toBeNull();
    expect(tangency?.quick([0, 0, 0])).toBeNaN();
    expect(named('shape=cylinder', 'r').tangency?.exact(-1).sign).toBeNull();
  });

  test('a flat shape has none, and hidden results do not give it away', () => {
    expect(named('shape=plane', 'E').tangency?.exact([1, 2, 3]).sign).toBeNull();
    const hidden = update(at('shape=cone'), { type: 'reveal', lines: 0 });
    for (const handle of createDerive(() => exploreDetails)(hidden).scene.handles)
      expect(handle.tangency).toBeNull();
  });
});

test('handles keep their identity while nothing of theirs changes', () => {
  const derive = createDerive(() => exploreDetails);
  const state = at('shape=cone');
  const { handles } = derive(state).scene;
  expect(derive(update(state, { type: 'view', view: 'top' })).scene.handles).toBe(handles);
});

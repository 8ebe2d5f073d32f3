import { describe, expect, test } from 'vitest';
import { sixShapes } from '../../src/scene/presets/six-shapes.ts';
import type { Scene } from '../../src/scene/types.ts';
import { createDerive } from '../../src/state/derive.ts';
import { exploreDetails } from '../../src/state/explore-details.ts';
import { exploreLink } from '../../src/state/explore-link.ts';
import { surfaceSteps } from '../../src/state/picture/surface-steps.ts';
import { treeRows } from '../../src/state/picture/tree-rows.ts';
import { INITIAL } from '../../src/state/state.ts';
import { update } from '../../src/state/update.ts';
import { decode, encode } from '../../src/state/url.ts';
import { DEFAULT_SETTINGS } from '../../src/tracer/types.ts';
import { tracerFor } from '../unit/tracer/tracing.ts';

/*
 * Where a thing is kept between heights the list of a pixel's rays named the right hit, the algebra
 * below it called the root before it, which is cut off, the first hit, and Explore showed the whole
 * shape.
 */

/** A hyperboloid with a = 0.5, r = 0.8 between y = −0.5 and 1. */
const spout: Scene = {
  ...sixShapes.scene,
  things: sixShapes.scene.things
    .filter(({ id }) => id === 'hyperboloid')
    .map((thing) => ({
      ...thing,
      id: 'spout',
      shape: { kind: 'hyperboloid', center: [0, 0, 0], flare: 0.5, radius: 0.8 },
      between: [-0.5, 1],
    })),
};

describe.each([
  ['six-shapes', sixShapes.scene, 224, 68, 'cylinder'],
  ['a spout', spout, 160, 94, 'spout'],
] as const)('%s', async (_, scene, x, y, name) => {
  const settings = { ...DEFAULT_SETTINGS, width: 320, height: 180 };
  const [root] = (await tracerFor(scene, settings)).record(x, y).rays;
  if (root?.end.end !== 'hit') throw new Error('a hit was expected');
  const hit = root.end.t;
  const [row] = treeRows(scene, root, new Set(), settings);
  if (!row?.shape) throw new Error('a row was expected');

  test('the list says which root is cut off, and why', () => {
    expect(row.verdict).toBe(name);
    expect(row.rest).toMatch(/ at t = [\d.]+; t₁ = [\d.]+, cut off: y = [\d.]+ > [\d.]+$/);
  });

  test('the algebra calls the tracer’s hit the first', () => {
    const roots = row.shape && surfaceSteps(row.shape, row.rootFilter, 'certified')?.roots;
    expect(roots?.map(({ fate }) => fate)).toEqual(['cut', 'hit']);
    expect(roots?.[1]?.t).toBe(hit);
    expect(roots?.[1]?.words).toContain('first hit, leaves');
  });

  test('Explore has the same ends, and keeps them', () => {
    const { shape, ray, rootFilter: meeting } = row;
    if (!shape) throw new Error('a shape was expected');
    const state = decode(exploreLink(shape, ray, 'certified', { between: meeting.between }));
    expect(state.problems).toEqual([]);
    expect(state.between).toEqual(meeting.between);
    expect(decode(encode(state)).between).toEqual(meeting.between);
    const { hits, verdict } = createDerive(() => exploreDetails)(state);
    expect(hits.map(({ role }) => role)).toEqual(['cut', 'first']);
    expect(hits[0]?.text).toMatch(/^cut off: y = \S+ > \S+$/);
    expect(verdict.text).toMatch(/^uncut, two points.*; cut at .*: t₁ is cut off, first hit t₂$/);
    for (const action of [
      { type: 'method', id: 'exact' },
      { type: 'bead', t: 1 },
      { type: 'origin', value: [9, 9, 9] },
      { type: 'direction', value: [0, 1, 0] },
      { type: 'unit', on: true },
      { type: 'param', key: 'radius', value: 3 },
      { type: 'shape', kind: 'plane' },
      { type: 'reset', what: 'E' },
    ] as const) {
      expect(update(state, action).between).toEqual(meeting.between);
    }
  });
});

test.each(['1', '1,2,3', '2,1', '1,1', 'a,b'])(
  'between=%s is said to be no two heights',
  (text) => {
    const { between, problems } = decode(`#/explore?between=${text}`, INITIAL);
    expect(between).toBeNull();
    expect(problems.join()).toMatch(/opened without between: .*'/);
  },
);

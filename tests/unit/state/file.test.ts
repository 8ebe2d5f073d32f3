import fc from 'fast-check';
import { describe, expect, test } from 'vitest';
import { fromFile, toFile } from '../../../src/state/file.ts';
import { type AppState, INITIAL } from '../../../src/state/state.ts';
import { update } from '../../../src/state/update.ts';

const double = fc.double({ noNaN: true, noDefaultInfinity: true });
const vector = fc.tuple(double, double, double);

function open(text: string): AppState {
  const opened = fromFile(text);
  if (!opened.ok) throw new Error(opened.reason);
  return opened.state;
}

describe('a saved state', () => {
  test('comes back with every bit, the other shapes included (seed 3)', () => {
    fc.assert(
      fc.property(vector, vector, double, (E, V, c) => {
        let state = update(INITIAL, { type: 'origin', value: E });
        state = update(state, { type: 'param', key: 'vertex', value: V });
        state = update(state, { type: 'param', key: 'slope', value: c });
        state = update(state, { type: 'shape', kind: 'square' });
        const back = open(toFile(state));
        expect(back.E).toEqual(state.E);
        expect(back.shapes).toEqual(state.shapes);
        expect(back.kind).toBe('square');
        expect(back.problems).toEqual([]);
      }),
      { seed: 3, numRuns: 300 },
    );
  });

  test('keeps minus zero', () => {
    const state = update(INITIAL, { type: 'origin', value: [-0, 0, -0] });
    expect(Object.is(open(toFile(state)).E[0], -0)).toBe(true);
    const shape = update(INITIAL, { type: 'param', key: 'vertex', value: [-0, 1, -0] });
    expect(open(toFile(update(shape, { type: 'shape', kind: 'plane' }))).shapes.cone).toEqual(
      shape.shapes.cone,
    );
  });
});

describe('a file that is something else', () => {
  test.each([
    ['', "'' is not a saved state"],
    ['hello', "'hello' is not a saved state"],
    ['null', 'this file holds no state of Graze'],
    ['[1, 2]', 'this file holds no state of Graze'],
    ['{"graze": 2, "link": "#/explore"}', 'this file holds no state of Graze'],
    ['{"graze": 1}', 'this file holds no state of Graze'],
  ])('%s', (text, reason) => {
    expect(fromFile(text)).toEqual({ ok: false, reason });
  });

  test('a broken shape is left out and said', () => {
    const text = JSON.stringify({
      graze: 1,
      link: '#/explore?shape=cone',
      shapes: [
        { kind: 'cylinder', center: [0, 0, 0], radius: -1 },
        { kind: 'torus' },
        { kind: 'circle', normal: [0, 0, 1], center: [1, 2, 3], radius: 4, __proto__: { x: 1 } },
      ],
    });
    const state = open(text);
    expect(state.problems).toEqual([
      'opened without a shape: radius must be ≥ 0, got -1',
      "opened without a shape: unknown shape 'torus'",
    ]);
    expect(state.shapes.cylinder).toBe(INITIAL.shapes.cylinder);
    expect(state.shapes.circle).toEqual({
      kind: 'circle',
      normal: [0, 0, 1],
      center: [1, 2, 3],
      radius: 4,
    });
  });
});

import { describe, expect, test } from 'vitest';
import './gallery-loaded.ts';
import type { Action } from '../../../src/state/actions.ts';
import { advance, type History, historyOf } from '../../../src/state/history.ts';
import { INITIAL } from '../../../src/state/state.ts';

const move = (x: number): Action => ({ type: 'origin', value: [x, 0, 0] });
const run = (start: History, ...steps: readonly (readonly [Action, string | null])[]): History =>
  steps.reduce((history, [action, gesture]) => advance(history, action, gesture), start);
const undo: Action = { type: 'undo' };
const redo: Action = { type: 'redo' };
const start = historyOf(INITIAL);

describe('a step of undo', () => {
  test('is an action by itself when it belongs to no gesture', () => {
    const history = run(start, [move(1), null], [move(2), null], [undo, null]);
    expect(history.present.E).toEqual([1, 0, 0]);
  });

  test('is a whole gesture, however many actions it had', () => {
    const history = run(start, [move(1), 'a'], [move(2), 'a'], [move(3), 'a'], [undo, null]);
    expect(history.present.E).toEqual(INITIAL.E);
    expect(history.past).toEqual([]);
  });

  test('ends with its gesture', () => {
    const history = run(start, [move(1), 'a'], [move(2), 'b'], [undo, null]);
    expect(history.present.E).toEqual([1, 0, 0]);
  });

  test('is not joined to the gesture that it took back', () => {
    const history = run(start, [move(1), 'a'], [undo, null], [move(2), 'a'], [undo, null]);
    expect(history.present.E).toEqual(INITIAL.E);
  });
});

describe('a gesture that comes back to where it began', () => {
  const E = INITIAL.E;
  test('leaves no step', () => {
    const history = run(start, [move(1), 'a'], [{ type: 'origin', value: [...E] }, 'a']);
    expect(history.past).toEqual([]);
  });

  test('and is one step again when it goes on', () => {
    const back: Action = { type: 'origin', value: [...E] };
    const history = run(start, [move(1), 'a'], [back, 'a'], [move(2), 'a'], [move(3), 'a']);
    expect(history.past).toHaveLength(1);
    expect(advance(history, undo, null).present.E).toEqual(E);
  });
});

describe('redo', () => {
  test('brings back what undo took, in order', () => {
    const back = run(start, [move(1), null], [move(2), null], [undo, null], [undo, null]);
    expect(run(back, [redo, null]).present.E).toEqual([1, 0, 0]);
    expect(run(back, [redo, null], [redo, null]).present.E).toEqual([2, 0, 0]);
  });

  test('is lost when something new is done', () => {
    const history = run(start, [move(1), null], [undo, null], [move(5), null], [redo, null]);
    expect(history.present.E).toEqual([5, 0, 0]);
  });
});

describe('what is no step', () => {
  test('undo and redo with nothing to do', () => {
    expect(run(start, [undo, null], [redo, null]).present).toBe(INITIAL);
  });

  test('an action that changes nothing', () => {
    expect(advance(start, { type: 'direction', value: [0, 0, 0] }, null)).toBe(start);
  });

  test('looking around: view, bead, hiding, the ghost', () => {
    const history = run(
      start,
      [{ type: 'view', view: 'top' }, null],
      [{ type: 'bead', t: 2 }, null],
      [{ type: 'reveal', lines: 0 }, null],
      [{ type: 'ghost', on: true }, null],
    );
    expect(history.past).toEqual([]);
    expect(history.present.view).toBe('top');
  });

  test('and looking around survives an undo', () => {
    const history = run(
      start,
      [move(1), null],
      [{ type: 'view', view: 'top' }, null],
      [undo, null],
    );
    expect(history.present.view).toBe('top');
    expect(history.present.E).toEqual(INITIAL.E);
  });
});

test('every undoable action is undone whole', () => {
  const actions: readonly Action[] = [
    { type: 'shape', kind: 'circle' },
    move(9),
    { type: 'direction', value: [1, 2, 3] },
    { type: 'unit', on: true },
    { type: 'param', key: 'slope', value: 1.5 },
    { type: 'method', id: 'textbook' },
    { type: 'reset', what: 'all' },
    { type: 'example', id: 'plane-hit' },
    { type: 'browse', by: -1 },
    { type: 'link', hash: '#/explore?shape=square&L=3' },
  ];
  for (const action of actions) {
    const moved = advance(historyOf({ ...INITIAL, E: [7, 7, 7] }), action, null);
    const { kind, shapes, E, d, unit, method } = advance(moved, undo, null).present;
    expect([action, kind, shapes, E, d, unit, method]).toEqual([
      action,
      INITIAL.kind,
      INITIAL.shapes,
      [7, 7, 7],
      INITIAL.d,
      INITIAL.unit,
      INITIAL.method,
    ]);
  }
});

test('the past is bounded', () => {
  let history = start;
  for (let i = 0; i < 500; i++) history = advance(history, move(i + 10), null);
  expect(history.past.length).toBe(200);
});

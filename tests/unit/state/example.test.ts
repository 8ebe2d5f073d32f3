import { describe, expect, test } from 'vitest';
import './gallery-loaded.ts';
import type { Action } from '../../../src/state/actions.ts';
import { exampleOf, type ShownExample, titleOf } from '../../../src/state/example.ts';
import { GALLERY } from '../../../src/state/gallery/index.ts';
import { advance, type History, historyOf } from '../../../src/state/history.ts';
import { type AppState, INITIAL } from '../../../src/state/state.ts';
import { decode, encode } from '../../../src/state/url.ts';

const doing = (history: History, ...actions: Action[]): History =>
  actions.reduce((h, action) => advance(h, action, null), history);
const shown = (state: AppState): string | null => {
  const example = exampleOf(state);
  return example && `${example.number} ${titleOf(example)}`;
};
const start = historyOf(INITIAL);

describe.each(GALLERY.map(({ id, title }, i) => [id, `${i + 1} ${title}`] as const))(
  '%s',
  (id, named) => {
    const open = doing(start, { type: 'example', id });

    test('is the example while nothing is changed, however one looks at it', () => {
      const looked = doing(open, { type: 'view', view: 'side' }, { type: 'bead', t: 2 });
      expect([shown(open.present), shown(looked.present)]).toEqual([named, named]);
    });

    test('is the example again when its link is opened', () => {
      const again = decode(encode(open.present), INITIAL);
      expect([again.example, shown(again)]).toEqual([null, named]);
      const edited = doing(historyOf(again), { type: 'method', id: 'stable' });
      expect(shown(edited.present)).toBe(`${named}, changed`);
    });

    test('changed says so, and undone no more', () => {
      const { E } = open.present;
      const edits: Action[] = [
        { type: 'origin', value: [E[0], E[1] + 0.3, E[2]] },
        { type: 'unit', on: true },
        { type: 'method', id: 'stable' },
      ];
      for (const edit of edits) {
        const changed = doing(open, edit);
        expect(shown(changed.present)).toBe(`${named}, changed`);
        const undone = doing(changed, { type: 'undo' });
        expect(shown(undone.present)).toBe(named);
        expect(shown(doing(undone, { type: 'redo' }).present)).toBe(`${named}, changed`);
      }
    });

    test('undone as a whole is what was there before', () => {
      expect(shown(doing(open, { type: 'undo' }).present)).toBeNull();
    });
  },
);

test('two examples in a row, the second undone: the first one is back', () => {
  const two = doing(start, { type: 'example', id: 'cone-hit' }, { type: 'browse', by: 1 });
  const back = doing(two, { type: 'undo' }).present;
  expect((exampleOf(back) as ShownExample).entry.id).toBe('cone-hit');
});

test('of another shape it is no example', () => {
  const other = doing(start, { type: 'example', id: 'cone-hit' }, { type: 'shape', kind: 'plane' });
  expect(exampleOf(other.present)).toBeNull();
});

test('next goes on from the link of an example', () => {
  const link = encode(doing(start, { type: 'example', id: 'cone-hit' }).present);
  const next = doing(historyOf(decode(link, INITIAL)), { type: 'browse', by: 1 });
  expect(exampleOf(next.present)?.entry.id).toBe('cone-miss');
});

test('what the page opens with is no example', () => {
  for (const kind of Object.keys(INITIAL.shapes)) {
    expect(exampleOf(decode(`#/explore?shape=${kind}`)), kind).toBeNull();
  }
});

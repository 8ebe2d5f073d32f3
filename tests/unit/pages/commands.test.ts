import { expect, test } from 'vitest';
import { commandsOf, type PageActions } from '../../../src/pages/commands.ts';
import { INITIAL } from '../../../src/state/state.ts';
import { createStore } from '../../../src/state/store.ts';

test('while predicting, next shows a line and back takes it away, down to none', () => {
  const total = 3;
  const store = createStore({ ...INITIAL, revealed: 0 });
  const tools = {
    lines: () => ({ total, shown: store.get().revealed ?? total }),
    answer: () => null,
  } as Partial<PageActions> as PageActions;
  const run = (id: string): number | null => {
    commandsOf(store, tools)
      .find((command) => command.id === id)
      ?.run();
    return store.get().revealed;
  };
  expect(['next', 'next', 'next'].map(run)).toEqual([1, 2, 3]);
  expect(['previous', 'previous', 'previous'].map(run)).toEqual([2, 1, 0]);
});

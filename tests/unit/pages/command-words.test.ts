import { describe, expect, test } from 'vitest';
import '../state/gallery-loaded.ts';
import { commandWords } from '../../../src/pages/command-words.ts';
import { type Command, commandsOf, type PageActions } from '../../../src/pages/commands.ts';
import { announcement } from '../../../src/state/announce.ts';
import { createDerive } from '../../../src/state/derive.ts';
import { answerShown } from '../../../src/state/example.ts';
import { exploreDetails } from '../../../src/state/explore-details.ts';
import { lineCount } from '../../../src/state/reveal.ts';
import { type AppState, INITIAL } from '../../../src/state/state.ts';
import { createStore, type Store } from '../../../src/state/store.ts';
import { decode } from '../../../src/state/url.ts';

const derive = createDerive(() => exploreDetails);

/** The commands on a store; those that are the page's own say so in `called`. */
function commandsOn(store: Store): { commands: readonly Command[]; called: string[] } {
  const called: string[] = [];
  const own = {
    lines: () => {
      const total = lineCount(derive(store.get()));
      return { total, shown: store.get().revealed ?? total };
    },
    answer: () => answerShown(store.get()),
  };
  const tools = new Proxy(own, {
    get: (target, name: string) => target[name as keyof typeof own] ?? (() => called.push(name)),
  }) as unknown as PageActions;
  return { commands: commandsOf(store, tools), called };
}

/**
 * What the page itself does, with words of its own or with a dialog that gets the focus:
 * tests/browser/voice.spec.ts has them all run.
 */
const PAGES_OWN = new Set(
  ['copyLink', 'save', 'openFile', 'exportDialog', 'gallery', 'help', 'fullScreen', 'black'].concat(
    ['theme', 'play', 'hear', 'present', 'second', 'turn', 'collect'],
  ),
);

const STATES: Readonly<Record<string, AppState>> = {
  'at first': INITIAL,
  'an example': decode('#/explore?shape=cone&E=4,1,0.5&d=-1,0,0', INITIAL),
  hidden: decode('#/explore?shape=circle&E=4,1,0.5&d=-1,0,0&hide=1', INITIAL),
  'almost shown': { ...decode('#/explore?shape=cone&hide=1', INITIAL), revealed: 99 },
  deriving: decode('#/explore?shape=cone&derive=1', INITIAL),
  'at the end of the derivation': decode('#/explore?shape=cone&derive=99', INITIAL),
  'with a ghost': { ...INITIAL, ghost: null, told: true },
};

describe.each(Object.entries(STATES))('every command says something: %s', (_, initial) => {
  const names = commandsOn(createStore(initial)).commands.map(({ id }) => id);
  test.each(names)('%s', (id) => {
    const store = createStore(initial);
    const { commands, called } = commandsOn(store);
    const command = commands.find((one) => one.id === id);
    // Twice: what is there already has to be said too.
    for (const _ of [1, 2]) {
      const before = store.get();
      called.length = 0;
      command?.run();
      const after = store.get();
      if (called.length > 0) {
        expect(called.filter((name) => !PAGES_OWN.has(name))).toEqual([]);
        continue;
      }
      // The derivation says its steps where it draws them.
      if (after.derive !== null && after.derive !== before.derive) continue;
      const words = commandWords(id, before, after);
      expect(`${words}${announcement(derive(before), derive(after))}`).not.toBe('');
    }
  });
});

test('undo and redo say what has come back', () => {
  const store = createStore({ ...INITIAL, page: 'check' });
  const { commands } = commandsOn(store);
  store.dispatch({ type: 'settings', values: { seed: '41', scene: `~${'x'.repeat(99)}` } });
  store.dispatch({ type: 'page', page: 'explore' });
  const told = (id: string): string => {
    const before = store.get();
    commands.find((one) => one.id === id)?.run();
    return commandWords(id, before, store.get());
  };
  expect(told('undo')).toBe('Undone. Check. seed as at first. scene as at first.');
  expect(told('undo')).toBe('There is nothing to undo.');
  expect(told('redo')).toBe('Done again. seed 41. scene as it was.');
});

import { SHAPES } from '../math/index.ts';
import type { Store } from '../state/store.ts';

/** What the page itself can do beyond changing the state. */
export interface PageActions {
  copyLink(): void;
  save(): void;
  openFile(): void;
  exportDialog(): void;
  gallery(): void;
  help(): void;
  fullScreen(): void;
  /** Makes the page black until a key or a click. */
  black(): void;
  theme(): void;
  play(): void;
  /** f along the ray as a sound, once; or stops it. */
  hear(): void;
  /** Shows or hides a second view beside the scene. */
  second(): void;
  /** Goes one step of a lesson forward or back. */
  turn(by: 1 | -1): void;
  /** Opens the presenter's window. */
  present(): void;
  /** Adds what is shown to the own lesson, as its next step. */
  collect(): void;
  /** Number of lines of the result, and how many are shown. */
  lines(): { total: number; shown: number };
  /** Whether the answer to the example's question is shown; null where none is asked. */
  answer(): boolean | null;
}

/** Something a person can do by key and by button; the help lists all of them. */
export interface Command {
  /** Its title is in command-titles.ts. */
  readonly id: string;
  /** Values of KeyboardEvent.key; 'Ctrl+' also means the command key on a Mac. */
  readonly keys: readonly string[];
  /** Ids of the pages on which it works; absent: all. */
  readonly pages?: readonly string[];
  run(): void;
}

export function commandsOf(store: Store, tools: PageActions): readonly Command[] {
  return [
    ...exploreCommands(store, tools),
    ...lessonCommands(tools),
    ...commonCommands(store, tools),
  ];
}

/** The commands for the ray and shape on Explore. */
function exploreCommands(store: Store, tools: PageActions): Command[] {
  const { dispatch } = store;
  const commands: Command[] = [
    ...SHAPES.map(({ kind }, i) => ({
      id: `shape-${kind}`,
      keys: [String(i + 1)],
      run: () => dispatch({ type: 'shape', kind }),
    })),
    {
      id: 'next',
      keys: ['PageDown', 'ArrowRight'],
      run: () => next(store, tools),
    },
    {
      id: 'previous',
      keys: ['PageUp', 'ArrowLeft'],
      run: () => {
        if (stepped(store, -1)) return;
        const { shown } = tools.lines();
        if (store.get().revealed !== null && shown > 0) {
          dispatch({ type: 'reveal', lines: shown - 1 });
        } else if (tools.answer()) dispatch({ type: 'tell', on: false });
        else dispatch({ type: 'browse', by: -1 });
      },
    },
    {
      id: 'answer',
      keys: ['a'],
      run: () => dispatch({ type: 'tell', on: tools.answer() === false }),
    },
    {
      id: 'gallery',
      keys: ['x'],
      run: tools.gallery,
    },
    {
      id: 'derive',
      keys: ['d'],
      run: () => dispatch({ type: 'derive', step: (now) => (now ? null : 1) }),
    },
    {
      id: 'hide',
      keys: ['h'],
      run: () => dispatch({ type: 'reveal', lines: store.get().revealed === null ? 0 : null }),
    },
    {
      id: 'reveal',
      keys: ['n'],
      run: () => reveal(store, tools),
    },
    {
      id: 'ghost',
      keys: ['g'],
      run: () => dispatch({ type: 'ghost', on: store.get().ghost === null }),
    },
    { id: 'second', keys: ['v'], run: tools.second },
    { id: 'play', keys: ['p'], run: tools.play },
    { id: 'hear', keys: ['m'], run: tools.hear },
    {
      id: 'reset',
      keys: ['Shift+r'],
      run: () => dispatch({ type: 'reset', what: 'all' }),
    },
  ];
  return commands.map((command) => ({ ...command, pages: ['explore'] }));
}

function lessonCommands(tools: PageActions): Command[] {
  return [
    {
      id: 'lesson-next',
      keys: ['PageDown', 'ArrowRight'],
      pages: ['lesson'],
      run: () => tools.turn(1),
    },
    {
      id: 'lesson-back',
      keys: ['PageUp', 'ArrowLeft'],
      pages: ['lesson'],
      run: () => tools.turn(-1),
    },
    { id: 'present', keys: ['p'], pages: ['lesson'], run: tools.present },
    { id: 'present-explore', keys: ['Shift+p'], pages: ['explore'], run: tools.present },
    { id: 'picture-more', keys: ['n'], pages: ['picture'], run: () => tools.turn(1) },
    { id: 'picture-less', keys: ['Shift+n'], pages: ['picture'], run: () => tools.turn(-1) },
    {
      id: 'collect',
      keys: ['c'],
      pages: ['explore', 'accuracy', 'picture', 'check'],
      run: tools.collect,
    },
  ];
}

function commonCommands({ dispatch }: Store, tools: PageActions): Command[] {
  return [
    { id: 'undo', keys: ['Ctrl+z'], run: () => dispatch({ type: 'undo' }) },
    {
      id: 'redo',
      keys: ['Ctrl+Shift+z', 'Ctrl+y'],
      run: () => dispatch({ type: 'redo' }),
    },
    { id: 'link', keys: ['l'], run: tools.copyLink },
    { id: 'save', keys: ['s'], run: tools.save },
    { id: 'open', keys: ['o'], run: tools.openFile },
    {
      id: 'export',
      keys: ['e'],
      run: tools.exportDialog,
    },
    {
      id: 'theme',
      keys: ['t'],
      run: tools.theme,
    },
    { id: 'full', keys: ['f'], run: tools.fullScreen },
    { id: 'black', keys: ['b', '.'], run: tools.black },
    { id: 'help', keys: ['?'], run: tools.help },
  ];
}

type Stepped = Pick<Store, 'get' | 'dispatch'>;

function reveal({ get, dispatch }: Stepped, tools: Pick<PageActions, 'lines'>): void {
  const { revealed } = get();
  if (revealed === null) return;
  const { total } = tools.lines();
  dispatch({ type: 'reveal', lines: Math.min(revealed + 1, total) });
}

/** Goes one step of the derivation forward or back; false if it is closed. */
function stepped({ get, dispatch }: Stepped, by: 1 | -1): boolean {
  if (!get().derive) return false;
  dispatch({ type: 'derive', step: (now) => now && now + by });
  return true;
}

/** A clicker's key for "next": reveals a line, then the answer, then opens the next example. */
export function next(store: Stepped, tools: Pick<PageActions, 'lines' | 'answer'>): void {
  if (stepped(store, 1)) return;
  const state = store.get();
  const { total, shown } = tools.lines();
  if (state.revealed !== null && shown < total) reveal(store, tools);
  else if (tools.answer() === false) store.dispatch({ type: 'tell', on: true });
  else store.dispatch({ type: 'browse', by: 1 });
}

/** Keys without a modifier can be switched off, for speech input and unintended key presses. */
interface KeySettings {
  readonly singleKeys: boolean;
  readonly page: string;
}

/** The command of a key press, unless the control that has the focus uses the key itself. */
export function commandFor(
  event: KeyboardEvent,
  commands: readonly Command[],
  { singleKeys, page }: KeySettings,
): Command | undefined {
  if (event.defaultPrevented || event.altKey || event.isComposing) return undefined;
  const control = event.ctrlKey || event.metaKey;
  const target = event.target instanceof Element ? event.target : null;
  if (target?.closest('dialog[open]')) return undefined;
  if (target?.closest('input:not([type=range]):not([type=checkbox]), select, textarea')) {
    return undefined;
  }
  if (!control && !singleKeys && event.key.length === 1) return undefined;
  const needsKeys = target?.closest('input[type=range], [role=slider], [role=application], .scene');
  if (needsKeys && /^(Arrow|Page|Home|End)/.test(event.key)) return undefined;
  const shift = event.shiftKey && /^[a-z]$/i.test(event.key) ? 'Shift+' : '';
  const key = event.key.length === 1 ? event.key.toLowerCase() : event.key;
  const name = `${control ? 'Ctrl+' : ''}${shift}${key}`;
  return commands.find(({ keys, pages }) => keys.includes(name) && (pages?.includes(page) ?? true));
}

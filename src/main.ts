import { render } from 'lit';
import { type Command, commandFor, commandsOf, type PageActions } from './pages/commands.ts';
import type { DialogParts, Dialogs } from './pages/dialogs.ts';
import { lazyEmbed } from './pages/embed/lazy-embed.ts';
import type { BeadPlayer } from './pages/explore/bead-player.ts';
import { type Explore, type ExploreTools, mountExplore } from './pages/explore/explore-page.ts';
import type { Sonification } from './pages/explore/sonification.ts';
import type { ExportItem } from './pages/export-dialog.ts';
import type { PageView } from './pages/page.ts';
import { createPageSwitcher } from './pages/page-switcher.ts';
import { shell } from './pages/shell.ts';
import { createDerive, type ExploreModel, type FullModel, isFull } from './state/derive.ts';
import { answerShown, exampleOf, provideExamples } from './state/example.ts';
import type { ExploreDetails } from './state/explore-details.ts';
import { lineCount } from './state/reveal.ts';
import { type AppState, INITIAL, PAGES } from './state/state.ts';
import { createStore } from './state/store.ts';
import { decode, encode } from './state/url.ts';
import type { Announce } from './ui/announcer.ts';
import { copyText } from './ui/clipboard.ts';
import { watchGestures } from './ui/gesture.ts';
import { lazy, watchStyles } from './ui/lazy.ts';
import type { Mounted } from './ui/mounted.ts';
import { onNotKept, recall, remember } from './ui/storage.ts';
import { THEMES, watchTheme } from './ui/theme.ts';
import './ui/tokens.css';
import './ui/base.css';
import './ui/fields.css';
import './ui/print.css';
import './ui/touch.css';

/** ms between writes of the link: browsers allow about ten a second. */
const LINK_DELAY_MS = 150;
const SAID_MS = 2500;
const SINGLE_KEYS = 'graze.single-keys';
const TITLE = document.title;

const app = document.getElementById('app') as HTMLElement;
const header = document.createElement('div');
const main = document.createElement('main');
app.replaceChildren(header, main);

let frame = 0;
const store = createStore(decode(location.hash, INITIAL), watchGestures(document.body));
let exploreDetails: ExploreDetails | null = null;
let announcement: typeof import('./state/announce.ts').announcement | null = null;
let exampleQuestion: ExploreTools['exampleQuestion'] = null;
let normalLine: ExploreTools['normalLine'] = null;
let ends: ExploreTools['ends'] = null;
let secondView: ExploreTools['secondView'] = null;
let followExplore: ((state: AppState) => void) | null = null;
let sonification: Sonification | null = null;
const derive = createDerive(() => exploreDetails);
const voice = lazy(() => import('./ui/announcer.ts')).then(({ createAnnouncer }) =>
  createAnnouncer(document.body),
);
voice.catch(() => {});
/** Nothing is announced if its code did not come. */
const announce: Announce = (...words) => {
  voice.then((speak) => speak(...words)).catch(() => {});
};
let player: BeadPlayer | null = null;
let motion: ((model: FullModel) => FullModel) | null = null;
const theme = watchTheme(document.documentElement, requestRender);
let explore: Explore | null = null;
/** The parts of Explore alone, in a host's page. */
let embedded: Mounted<ExploreModel> | null = null;
const isPart = store.get().embed !== null;
const isFramed = window.parent !== window;
let host: ReturnType<typeof import('./pages/embed/frame.ts').watchHost> | null = null;
const modelNow = (): ExploreModel => derive(store.get());
/** What Explore shows, and the model whose news were announced last. */
let model: ExploreModel | null = null;
let heard: ExploreModel | null = null;
let said = '';
let shownPage = '';

/** Says so where the results are hidden, which would be told. */
function areHidden(): boolean {
  const { hits } = modelNow().shown;
  if (!hits) say('not while results are hidden: it would tell them');
  return !hits;
}

const tools: PageActions = {
  copyLink: async () => {
    writeLink();
    const copied = await copyText(location.href);
    say(copied ? 'link copied' : 'the link could not be copied: it is in the address bar');
  },
  save: () => withCode(files(), ({ save }) => save()),
  openFile: () => withCode(files(), ({ open }) => open()),
  exportDialog: () => openDialog('export'),
  gallery: () => openDialog('gallery'),
  help: () => openDialog('help'),
  fullScreen: () => {
    const done = document.fullscreenElement
      ? document.exitFullscreen()
      : document.documentElement.requestFullscreen();
    done.then(
      () => say(document.fullscreenElement ? 'full screen' : 'no full screen any more'),
      () => say('this browser does not allow full screen here'),
    );
  },
  black() {
    player?.stop();
    withCode(clicker(), (black) => black());
  },
  theme: () => {
    const next = THEMES[(THEMES.indexOf(theme.current()) + 1) % THEMES.length] ?? 'system';
    theme.set(next);
    say(`theme: ${next}`);
  },
  // Not while results are hidden: the bead pauses at each root.
  play: () =>
    withCode(theRest(), () => {
      const now = modelNow();
      if (areHidden() || !isFull(now) || !player) return;
      player.toggle(now.graph);
      announce(player.playing ? 'The bead plays.' : 'The bead has stopped.', 'deed');
    }),
  hear: () => {
    const code = lazy(() => import('./pages/explore/sonification.ts'));
    withCode(Promise.all([code, theRest()]), ([{ createSonification }]) => {
      if (areHidden()) return;
      const move = (t: number) => store.dispatch({ type: 'bead', t });
      sonification ??= createSonification(move, requestRender, announce);
      const now = modelNow();
      if (isFull(now)) sonification.toggle(now.graph);
    });
  },
  second: () => withCode(theRest(), () => secondView?.toggle()),
  turn: (by) => withCode(shownView(), (view) => view?.turn?.(by)),
  present: () =>
    withCode(shownView(), (view) => {
      if (view) view.present?.();
      else {
        withCode(theRest(), ({ presentExplore }) => tellProblem(presentExplore(announce)));
      }
    }),
  collect: () => withCode(files(), ({ collect }) => collect()),
  lines: () => {
    const total = lineCount(modelNow());
    return { total, shown: store.get().revealed ?? total };
  },
  answer: () => answerShown(store.get()),
};
function runNow({ id, run }: Command): void {
  const before = store.get();
  run();
  const after = store.get();
  lazy(() => import('./pages/command-words.ts')).then(
    ({ commandWords }) => {
      const words = commandWords(id, before, after);
      if (words) announce(words, 'deed');
    },
    () => {},
  );
}
const commands = commandsOf(store, tools).map((command) => ({
  ...command,
  // What is asked for before examples and player are loaded waits for them, and keeps its turn.
  run() {
    const now = () => runNow(command);
    if (player || store.get().page !== 'explore') now();
    else marked(theRest()).then(now, now);
  },
}));
const command = (id: string): Command | undefined => commands.find((c) => c.id === id);
const dialogParts: DialogParts = {
  commands,
  exports: async () => (await shownView())?.exports() ?? (explore ? exportsOf(explore) : []),
  example: () => exampleOf(store.get()),
  hidden: () => store.get().revealed !== null,
  page: () => store.get().page,
  state: store.get,
  dispatch: store.dispatch,
  tools,
  say,
  keys: {
    get: () => recall(SINGLE_KEYS) !== 'off',
    set: (on) => remember(SINGLE_KEYS, on ? 'on' : 'off'),
  },
};

/** The exports, loaded on demand. */
async function exportsOf(shown: Explore): Promise<readonly ExportItem[]> {
  const { exploreExports } = await lazy(() => import('./pages/explore/exports.ts'));
  return exploreExports(shown, modelNow);
}

let rest: Promise<typeof import('./pages/explore/after-first-frame.ts')> | null = null;
/** The code after the first frame, which is put to use first; loaded again after a failure. */
function theRest(): NonNullable<typeof rest> {
  if (rest) return rest;
  rest = lazy(() => import('./pages/explore/after-first-frame.ts'));
  rest.then(
    (code) => {
      ({ exploreDetails, announcement, followExplore, exampleQuestion, normalLine, ends } = code);
      provideExamples(code.GALLERY);
      code.keepLines(store);
      player = code.createPlayer((t) => store.dispatch({ type: 'bead', t }), requestRender);
      secondView = code.createSecondView(store.dispatch, requestRender, say);
      motion = code.createMotion(main, requestRender, store.dispatch, announce);
      code.printsOnPaper(() => (store.get().page === 'explore' ? modelNow() : null));
      // That a link's example is known now is no news; a change before it was known is.
      heard = heard && derive(heard.state);
      requestRender();
    },
    () => {
      rest = null;
    },
  );
  return rest;
}

let watched: (() => void) | null = null;
/** The code for a presenter's clicker. */
const clicker = (): Promise<() => void> =>
  lazy(() => import('./ui/clicker.ts')).then(({ watchClicker }) => {
    watched ??= watchClicker(() => store.get().page === 'explore', announce);
    return watched;
  });

const sayNotLoaded = (): void => say('this could not be loaded: try it again, or reload the page');
let awaited = 0;
/** The page says by an attribute that something which was asked for waits for its code. */
function marked<T>(code: Promise<T>): Promise<T> {
  const count = (by: number): void => {
    awaited += by;
    main.toggleAttribute('data-waiting', awaited > 0);
  };
  count(1);
  const settled = () => count(-1);
  code.then(settled, settled);
  return code;
}
/** Uses code that a person has asked for. */
function withCode<T>(code: Promise<T>, use: (code: T) => void): void {
  marked(code).then(use, sayNotLoaded);
}

let dialogs: Promise<Dialogs> | null = null;
/** Opens a dialog; the dialogs' code is loaded with the first. */
function openDialog(name: keyof Dialogs): void {
  dialogs ??= lazy(() => import('./pages/dialogs.ts')).then(({ createDialogs }) =>
    createDialogs(dialogParts),
  );
  dialogs.catch(() => {
    dialogs = null;
  });
  withCode(dialogs, (made) => made[name]());
}

/** The page that the state names, when its code has come; null for Explore. */
const shownView = async (): Promise<PageView | null> => {
  pages.show(store.get());
  const view = await pages.arrival();
  // A page that has just come does nothing before it has been drawn.
  pages.show(store.get());
  return view;
};
const pages = createPageSwitcher(main, {
  dispatch: store.dispatch,
  changed: requestRender,
  say,
  announce,
  explore: {
    mount(host) {
      if (isPart) embedded = lazyEmbed(host, store.dispatch);
      else explore = mountExplore(host, store.dispatch, requestRender, announce);
    },
    render: renderExplore,
  },
  arrived: readSettings,
});

function renderExplore(state: AppState): void {
  const before = model;
  model = derive(state);
  heard ??= model;
  theRest();
  if (before !== model && !player?.playing && !sonification?.on) announce(tellNews);
  embedded?.render(model);
  explore?.render(motion && isFull(model) ? motion(model) : model, {
    command,
    exampleQuestion,
    normalLine,
    ends,
    secondView,
    second: secondView?.on === true,
    playing: player?.playing === true,
    soundOn: sonification?.on === true,
    large: theme.applied() === 'projector',
  });
}

function tellNews(): string {
  if (!announcement || !heard || !model) return '';
  const words = announcement(heard, model);
  heard = model;
  return words;
}

function renderAll(): void {
  const state = store.get();
  theme.ask(state.theme);
  if (state.page !== 'explore' || !derive(state).shown.hits) {
    player?.stop();
    sonification?.stop();
  }
  const title = PAGES.find(({ id }) => id === state.page)?.title;
  if (shownPage && state.page !== shownPage) announce(`${title}.`, 'page');
  shownPage = state.page;
  document.title = state.page === INITIAL.page ? TITLE : `${title} · Graze`;
  if (!isPart) drawHeader(state);
  pages.show(state);
  followExplore?.(state);
  host?.drawn();
}

function drawHeader(state: AppState): void {
  render(
    shell(state, store.dispatch, {
      theme: theme.current(),
      command,
      turn(page) {
        store.dispatch({ type: 'page', page });
        pages.again();
      },
      canUndo: store.canUndo(),
      canRedo: store.canRedo(),
      said,
    }),
    header,
  );
}

/** Checks a page's settings from a link or file: invalid ones are dropped with a message. */
function readSettings(view: PageView): void {
  const { page, settings, problems } = store.get();
  const given = settings[page];
  const read = view.read(given);
  const dropped = Object.keys(given).filter((key) => !(key in read.settings));
  const values = { ...Object.fromEntries(dropped.map((key) => [key, null])), ...read.settings };
  store.dispatch({ type: 'settings', values });
  const news = read.problems.filter((problem) => !problems.includes(problem));
  if (news.length > 0) store.dispatch({ type: 'say', problems: [...problems, ...news] });
}

// Many events may come in one frame; they are drawn once.
function requestRender(): void {
  if (frame !== 0) return;
  frame = requestAnimationFrame(() => {
    frame = 0;
    renderAll();
  });
}

let linkTimer = 0;
let written = location.hash;
function writeLink(): void {
  clearTimeout(linkTimer);
  linkTimer = 0;
  // If an address was typed while a write was pending, the typed one counts.
  if (location.hash !== written) {
    readLink();
    return;
  }
  const before = written;
  written = encode(store.get());
  if (written === location.hash) return;
  // Another page or the derivation gets a history entry of its own; a step of it does not.
  if (placeOf(before) === placeOf(written) || before === '') {
    history.replaceState(history.state, '', written);
  } else history.pushState(history.state, '', written);
}

const placeOf = (hash: string): string => `${hash.split('?')[0]} ${/[?&]derive=/.test(hash)}`;

function readLink(): void {
  written = location.hash;
  if (written === encode(store.get())) return;
  store.dispatch({ type: 'link', hash: written });
  // Another page stands around them.
  if (isPart !== (store.get().embed !== null)) location.reload();
  readShown();
}

/** Reads the settings of the shown page. */
function readShown(): void {
  pages.show(store.get());
  const view = pages.current();
  if (view) readSettings(view);
}

let saidTimer = 0;
function say(words: string): void {
  said = words;
  announce(`${words}.`, 'deed');
  clearTimeout(saidTimer);
  saidTimer = window.setTimeout(() => {
    said = '';
    requestRender();
  }, SAID_MS);
  requestRender();
}

let desk: ReturnType<typeof import('./pages/open-and-save.ts').createFiles> | null = null;
/** The code for files. */
const files = async () => {
  const { createFiles } = await lazy(() => import('./pages/open-and-save.ts'));
  desk ??= createFiles({ store, say, view: shownView, readShown, withCode });
  return desk;
};

store.subscribe(() => {
  requestRender();
  if (linkTimer === 0) linkTimer = window.setTimeout(writeLink, LINK_DELAY_MS);
});
window.addEventListener('pagehide', writeLink);
window.addEventListener('hashchange', readLink);
document.addEventListener('keydown', (event) => {
  // In a frame keys are the host's, but for those of the control that has the focus.
  if (isFramed || isPart) return;
  const wanted = commandFor(event, commands, {
    singleKeys: recall(SINGLE_KEYS) !== 'off',
    page: store.get().page,
  });
  if (!wanted) return;
  event.preventDefault();
  wanted.run();
});
/** Adds a message to those below the header, once. */
function tellProblem(words: string | null): void {
  const { problems } = store.get();
  if (!words || problems.includes(words)) return;
  store.dispatch({ type: 'say', problems: [...problems, words] });
}
onNotKept(() => {
  theRest().then(({ NOT_KEPT }) => tellProblem(NOT_KEPT), sayNotLoaded);
});
// If this cannot be loaded, symbols are not highlighted; nothing else is missing.
lazy(() => import('./ui/highlight.ts')).then(
  ({ watchHighlight }) => watchHighlight(app),
  () => {},
);
if (isFramed) {
  lazy(() => import('./pages/embed/frame.ts')).then(
    ({ watchHost }) => {
      const shown = (state: AppState) => (state.page === 'explore' ? derive(state) : null);
      const score = () => pages.current()?.score?.() ?? null;
      host = watchHost({ store, model: shown, score, content: app });
      requestRender();
    },
    // The host hears nothing then; everything else works.
    () => {},
  );
} else clicker().catch(() => {});
document.documentElement.classList.toggle('embed-page', isPart);
watchStyles(document);
renderAll();
writeLink();
files().catch(sayNotLoaded);
// Without it every control is a stop of its own.
lazy(() => import('./ui/tab-stops.ts')).then(
  ({ watchTabStops }) => watchTabStops(main, !isPart),
  () => {},
);

import { render } from 'lit';
import { type Command, commandFor, commandsOf, type PageTools } from './pages/commands.ts';
import { createDialogs } from './pages/dialogs.ts';
import { mountExplore } from './pages/explore.ts';
import { createPlayer } from './pages/play.ts';
import { shell } from './pages/shell.ts';
import { announcement } from './state/announce.ts';
import { createDerive, type ExploreModel } from './state/derive.ts';
import { fromFile, toFile } from './state/file.ts';
import { lineCount } from './state/reveal.ts';
import { INITIAL } from './state/state.ts';
import { createStore } from './state/store.ts';
import { decode, encode } from './state/url.ts';
import { createAnnouncer } from './ui/announcer.ts';
import { copyText } from './ui/clipboard.ts';
import { download, pickFile, watchDrops } from './ui/files.ts';
import { watchGestures } from './ui/gesture.ts';
import { watchHighlight } from './ui/highlight.ts';
import { recall, remember, THEMES, watchTheme } from './ui/theme.ts';
import './ui/tokens.css';
import './ui/base.css';
import './ui/fields.css';
import './ui/print.css';

/** Browsers refuse a history entry that is rewritten more than about ten times a second. */
const LINK_DELAY_MS = 150;
const SAID_MS = 2500;
const SINGLE_KEYS = 'graze.single-keys';

const app = document.getElementById('app') as HTMLElement;
const header = document.createElement('div');
const main = document.createElement('main');
app.append(header, main);

const store = createStore(decode(location.hash, INITIAL), watchGestures(document.body));
const derive = createDerive();
const announce = createAnnouncer(document.body);
const page = mountExplore(main, store.dispatch, requestRender);
const player = createPlayer((t) => store.dispatch({ type: 'bead', t }), requestRender);
const theme = watchTheme(document.documentElement, requestRender);
let model: ExploreModel = derive(store.get());
let said = '';

const tools: PageTools = {
  copyLink: async () => {
    writeLink();
    const copied = await copyText(location.href);
    say(copied ? 'link copied' : 'the link could not be copied: it is in the address bar');
  },
  save: () => download('graze.json', toFile(store.get()), 'application/json'),
  openFile: async () => openText(await pickFile('.json,application/json')),
  share: () => dialogs.share(),
  gallery: () => dialogs.gallery(),
  help: () => dialogs.help(),
  fullScreen: () => {
    const done = document.fullscreenElement
      ? document.exitFullscreen()
      : document.documentElement.requestFullscreen();
    done.catch(() => say('this browser does not allow full screen here'));
  },
  theme: () => {
    const next = THEMES[(THEMES.indexOf(theme.current()) + 1) % THEMES.length] ?? 'system';
    theme.set(next);
    say(`theme: ${next}`);
  },
  play: () => player.toggle(model.strip),
  lines: () => ({ total: lineCount(model), shown: store.get().revealed ?? lineCount(model) }),
};
const commands = commandsOf(store, tools);
const command = (id: string): Command | undefined => commands.find((c) => c.id === id);
const dialogs = createDialogs({
  commands,
  page,
  model: () => model,
  dispatch: store.dispatch,
  tools,
  say,
  keys: {
    get: () => recall(SINGLE_KEYS) !== 'off',
    set: (on) => remember(SINGLE_KEYS, on ? 'on' : 'off'),
  },
});

function renderAll(): void {
  const state = store.get();
  const before = model;
  model = derive(state);
  if (before !== model && !player.playing) {
    const words = announcement(before, model);
    if (words) announce(words);
  }
  render(
    shell(state, store.dispatch, {
      theme: theme.current(),
      command,
      canUndo: store.canUndo(),
      canRedo: store.canRedo(),
      said,
    }),
    header,
  );
  page.render(model, {
    command,
    playing: player.playing,
    large: theme.applied() === 'projector',
  });
}

// Many events fall into one frame; they are drawn once, in that frame.
let frame = 0;
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
  // Somebody typed an address while a write was pending: theirs is the later word.
  if (location.hash !== written) {
    readLink();
    return;
  }
  written = encode(store.get());
  if (written !== location.hash) history.replaceState(history.state, '', written);
}

function readLink(): void {
  written = location.hash;
  if (written !== encode(store.get())) store.dispatch({ type: 'link', hash: written });
}

let saidTimer = 0;
function say(words: string): void {
  said = words;
  clearTimeout(saidTimer);
  saidTimer = window.setTimeout(() => {
    said = '';
    requestRender();
  }, SAID_MS);
  requestRender();
}

function openText(text: string | null): void {
  if (text === null) return;
  const opened = fromFile(text);
  if (opened.ok) store.dispatch({ type: 'open', state: opened.state });
  else store.dispatch({ type: 'say', problems: [opened.reason] });
}

store.subscribe(() => {
  requestRender();
  if (linkTimer === 0) linkTimer = window.setTimeout(writeLink, LINK_DELAY_MS);
});
window.addEventListener('pagehide', writeLink);
window.addEventListener('hashchange', readLink);
document.addEventListener('keydown', (event) => {
  const wanted = commandFor(event, commands, { singleKeys: recall(SINGLE_KEYS) !== 'off' });
  if (!wanted) return;
  event.preventDefault();
  wanted.run();
});
watchDrops(document.body, openText);
watchHighlight(app);
renderAll();
writeLink();

import { render } from 'lit';
import { mountExplore } from './pages/explore.ts';
import { shell } from './pages/shell.ts';
import { INITIAL } from './state/state.ts';
import { createStore } from './state/store.ts';
import { decode, encode } from './state/url.ts';
import { copyText } from './ui/clipboard.ts';
import { watchHighlight } from './ui/highlight.ts';
import { watchTheme } from './ui/theme.ts';
import './ui/tokens.css';
import './ui/base.css';
import './ui/fields.css';

/** Browsers refuse a history entry that is rewritten more than about ten times a second. */
const LINK_DELAY_MS = 150;
const SAID_MS = 2500;

const app = document.getElementById('app') as HTMLElement;
const header = document.createElement('div');
const main = document.createElement('main');
app.append(header, main);

const store = createStore(decode(location.hash, INITIAL));
const page = mountExplore(main, store.dispatch);
let said = '';

const theme = watchTheme(document.documentElement, () => requestRender());

function renderAll(): void {
  const state = store.get();
  render(
    shell(state, store.dispatch, {
      theme: theme.current(),
      nextTheme: theme.next,
      copyLink,
      said,
    }),
    header,
  );
  page.render(state);
}

// Many events fall into one frame; they are drawn once, in that frame.
let frame = 0;
function requestRender(): void {
  if (frame === 0) {
    frame = requestAnimationFrame(() => {
      frame = 0;
      renderAll();
    });
  }
}

let linkTimer = 0;
function writeLink(): void {
  clearTimeout(linkTimer);
  linkTimer = 0;
  const link = encode(store.get());
  if (link !== location.hash) history.replaceState(history.state, '', link);
}

store.subscribe(() => {
  requestRender();
  if (linkTimer === 0) linkTimer = window.setTimeout(writeLink, LINK_DELAY_MS);
});
window.addEventListener('pagehide', writeLink);
window.addEventListener('hashchange', () => {
  if (location.hash !== encode(store.get())) store.dispatch({ type: 'link', hash: location.hash });
});

async function copyLink(): Promise<void> {
  writeLink();
  const copied = await copyText(location.href);
  said = copied ? 'link copied' : 'the link could not be copied: it is in the address bar';
  requestRender();
  setTimeout(() => {
    said = '';
    requestRender();
  }, SAID_MS);
}

watchHighlight(app);
renderAll();
writeLink();

import type { AppState } from '../../state/state.ts';
import { encode } from '../../state/url.ts';

const attribute = (text: string): string =>
  text.replaceAll('&', '&amp;').replaceAll('"', '&quot;').replaceAll('<', '&lt;');

/** The line of HTML that shows this link of Graze in a frame. */
export const frameLine = (link: string): string =>
  `<iframe src="${attribute(link)}" title="Graze: a ray and a surface" width="100%" height="420" ` +
  `style="border:0" allow="fullscreen"></iframe>`;

/** Text in the element until the module is loaded, or for ever where a policy forbids it. */
const NOT_LOADED = 'Graze shows a ray and a surface here, if the page may load its module.';

/** The lines of HTML that show the state by the element. `site`: address of Graze's own page. */
export function elementLine(state: AppState, site: string): string {
  const query = encode(state).split('?')[1] ?? '';
  const pairs = query.split('&').map((pair) => {
    const [key = '', value = ''] = pair.split(/=(.*)/s);
    return ` ${key === 'embed' ? 'show' : key}="${attribute(decodeURIComponent(value))}"`;
  });
  const module = new URL('embed/graze.js', site).href;
  return (
    `<script type="module" src="${attribute(module)}"></script>\n` +
    `<graze-ray${pairs.join('')}>${NOT_LOADED}</graze-ray>`
  );
}

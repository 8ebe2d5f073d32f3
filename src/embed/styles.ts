import scene from '../canvas/scene.css?inline';
import graph from '../charts/graph.css?inline';
import embed from '../pages/embed/embed.css?inline';
import algebra from '../panels/algebra.css?inline';
import controls from '../panels/controls.css?inline';
import ends from '../panels/ends.css?inline';
import normalLine from '../panels/normal-line.css?inline';
import paramRows from '../panels/param-rows.css?inline';
import base from '../ui/base.css?inline';
import fields from '../ui/fields.css?inline';
import tokens from '../ui/tokens.css?inline';
import element from './element.css?inline';

/** What src/main.ts and the modules behind src/pages/embed import for the whole page. */
const TEXTS = [
  ...[element, tokens, base, fields, controls, paramRows],
  ...[algebra, ends, normalLine, graph, scene, embed],
];

let made: CSSStyleSheet[] | null = null;

/** The styles of the element's shadow tree; a strict policy of the host allows them. */
export function sheets(): CSSStyleSheet[] {
  made ??= TEXTS.map((text) => {
    const sheet = new CSSStyleSheet();
    sheet.replaceSync(text);
    return sheet;
  });
  return made;
}

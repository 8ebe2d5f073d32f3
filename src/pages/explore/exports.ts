import type { ExploreModel } from '../../state/derive.ts';
import { EXPORTS } from '../../state/exports/index.ts';
import { svgText } from '../../ui/svg-text.ts';
import type { ExportItem } from '../export-dialog.ts';
import type { Explore } from './explore-page.ts';

/** The exports of Explore: texts made from the model, and pictures of graph and scene. */
export function exploreExports(explore: Explore, model: () => ExploreModel): ExportItem[] {
  const texts = EXPORTS.map(
    ({ id, title, extension, mime, text }): ExportItem => ({
      id,
      title,
      file: `graze.${extension}`,
      type: mime,
      text: () => text(model()),
      blob: null,
    }),
  );
  const graph: ExportItem = {
    id: 'graph-svg',
    title: 'the graph of f as SVG',
    file: 'graze-f.svg',
    type: 'image/svg+xml',
    text: () => {
      const svg = explore.graph();
      return svg ? svgText(svg, getComputedStyle(document.body).getPropertyValue('--bg')) : '';
    },
    blob: null,
  };
  const picture: ExportItem = {
    id: 'picture-png',
    title: 'the picture as PNG',
    file: 'graze.png',
    type: 'image/png',
    text: null,
    blob: () => explore.scene.picture(),
  };
  // While results are hidden, only the scene's picture does not give them away.
  return model().shown.hits ? [...texts, graph, picture] : [picture];
}

import type { ExploreModel } from '../../state/derive.ts';
import { EXPORTS } from '../../state/exports/index.ts';
import { svgText } from '../../ui/svg-text.ts';
import type { ExportItem } from '../export-dialog.ts';
import type { Explore } from './explore-page.ts';

/** What can be taken from the Explore page: texts made from the model, and its two pictures. */
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
  // Hidden, only the picture says nothing of where the ray meets the shape.
  return model().shown.hits ? [...texts, graph, picture] : [picture];
}

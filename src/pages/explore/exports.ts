import { drawStill } from '../../canvas/thumbnail.ts';
import type { ExploreModel } from '../../state/derive.ts';
import { EXPORTS } from '../../state/exports/index.ts';
import type { SceneModel } from '../../state/scene-model.ts';
import { svgText } from '../../ui/svg-text.ts';
import type { ExportItem } from '../export-dialog.ts';
import type { Explore } from './explore-page.ts';

/** Of the scene as a file, in CSS pixels. */
const FILE = { width: 960, height: 540 };

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
  const drawing: ExportItem = {
    id: 'picture-svg',
    title: 'the picture as SVG',
    file: 'graze.svg',
    type: 'image/svg+xml',
    text: () => {
      const { scene } = model();
      return scene ? sceneSvg(scene) : '';
    },
    blob: null,
  };
  // While results are hidden, only the scene's pictures do not give them away.
  return model().shown.hits ? [...texts, graph, drawing, picture] : [drawing, picture];
}

/** The scene as lines, in the size of a wide page's. */
function sceneSvg(scene: SceneModel): string {
  const host = document.createElement('div');
  host.className = 'scene-for-file';
  document.body.append(host);
  try {
    const { fontSize } = getComputedStyle(host);
    const scale = Number.parseFloat(getComputedStyle(host).getPropertyValue('--mark-scale')) || 1;
    const size = { ...FILE, scale, label: Number.parseFloat(fontSize) };
    const svg = drawStill(host, scene, size);
    return svgText(svg, getComputedStyle(svg).backgroundColor);
  } finally {
    host.remove();
  }
}

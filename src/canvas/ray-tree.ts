import type { TreeScene } from '../state/picture/tree-scene.ts';
import type { FreeView } from '../state/view.ts';
import type { Mounted } from '../ui/mounted.ts';
import { GlPainter } from './gl-painter.ts';
import { ground } from './ground.ts';
import { listenToOrbit } from './orbit.ts';
import { outline } from './outline.ts';
import type { Painter } from './painter.ts';
import { PathPainter } from './path-painter.ts';
import { Projection } from './projection.ts';
import { lineStrokes, TreeMarks } from './ray-tree-lines.ts';
import { silhouette } from './silhouette.ts';
import { StageUnits } from './stage-units.ts';
import type { Stroke } from './stroke.ts';
import { type Grid, tessellate } from './tessellation.ts';
import { onThemeChange, readTheme, type Theme } from './theme.ts';
import './scene.css';
import './ray-tree.css';

const SVG = 'http://www.w3.org/2000/svg';
/** Initial view; nearer than Explore's, since large shapes need not be seen whole. */
const FIRST = { elevation: 16, zoom: 1.4 } as const;
const TOUCHED = { ink: 'shape', width: 1.8, alpha: 0.9, dash: null } as const;
const OTHER = { ink: 'edge', width: 1.2, alpha: 0.75, dash: null } as const;
/** Factor on the walls' opacity. */
const FAINT = 0.7;

export interface TreeModel {
  readonly scene: TreeScene;
  /** Path of the ray that is chosen in the list. */
  readonly chosen: string | null;
}

/** A pixel's rays in space, among the shapes that they touch. Drawn only after a change. */
export function mountTree(host: HTMLElement): Mounted<TreeModel> {
  const root = document.createElement('div');
  root.className = 'scene-root tree-root';
  root.tabIndex = 0;
  root.setAttribute('role', 'group');
  const canvas = document.createElement('canvas');
  canvas.className = 'scene-canvas';
  canvas.setAttribute('aria-hidden', 'true');
  const paths = svg('scene-fallback');
  const overlay = svg('scene-overlay');
  root.append(canvas, paths, overlay);
  host.append(root);
  const gl = GlPainter.on(canvas);
  const lines = new PathPainter(paths);
  const marks = new TreeMarks(overlay);
  let painter: Painter = gl ?? lines;
  let theme = faint(readTheme(host));
  let model: TreeModel | null = null;
  let prepared: Prepared | null = null;
  let view: FreeView = { azimuth: 0, ...FIRST };
  let [width, height] = [host.clientWidth, host.clientHeight];
  let request = 0;

  const ask = (): void => {
    request ||= requestAnimationFrame(draw);
  };

  function draw(): void {
    request = 0;
    if (!model || !prepared || width === 0 || height === 0) return;
    const { units, touched, others, still } = prepared;
    const projection = new Projection({ target: [0, 0, 0], ...view }, width, height);
    const edges = (grids: readonly Grid[], style: typeof TOUCHED | typeof OTHER): Stroke[] =>
      grids.flatMap((grid) =>
        silhouette(grid, projection, units).map((chain) => ({ ...chain, ...style })),
      );
    painter.paint(
      {
        ground: [...still.ground, ...still.others, ...edges(others, OTHER)],
        ray: lineStrokes(model.scene.lines, model.chosen, units),
        shape: [...still.touched, ...edges(touched, TOUCHED)],
      },
      projection,
      theme,
    );
    marks.draw(model.scene.lines, model.chosen, units, projection, theme);
    host.dataset.frames = String(Number(host.dataset.frames ?? 0) + 1);
  }

  const usePainter = (next: Painter): void => {
    painter = next;
    root.classList.toggle('scene-without-gl', next !== gl);
    if (next === gl) lines.dispose();
    ask();
  };
  const lost = (event: Event): void => {
    event.preventDefault();
    usePainter(lines);
  };
  canvas.addEventListener('webglcontextlost', lost);
  const observer = new ResizeObserver(() => {
    [width, height] = [host.clientWidth, host.clientHeight];
    for (const element of [paths, overlay]) {
      element.setAttribute('viewBox', `0 0 ${width} ${height}`);
    }
    theme = faint(readTheme(host));
    ask();
  });
  observer.observe(host);
  const turn = (next: typeof view): void => {
    view = next;
    ask();
  };
  const stops = [
    onThemeChange(host, () => {
      theme = faint(readTheme(host));
      ask();
    }),
    listenToOrbit(root, {
      current: () => view,
      keep: () => {
        const kept = view;
        return () => turn(kept);
      },
      turn,
      home: () => {
        view = { azimuth: model?.scene.azimuth ?? 0, ...FIRST };
        ask();
      },
    }),
  ];
  usePainter(painter);

  return {
    render(next) {
      if (next.scene !== model?.scene) {
        if (next.scene.azimuth !== model?.scene.azimuth) {
          view = { azimuth: next.scene.azimuth, ...FIRST };
        }
        prepared = prepare(next.scene);
        gl?.fill(prepared.touched);
        root.setAttribute(
          'aria-label',
          `${next.scene.description}. Arrow keys turn it, plus and minus zoom, 0 goes back.`,
        );
      } else if (next.chosen === model.chosen) return;
      model = next;
      ask();
    },
    dispose() {
      cancelAnimationFrame(request);
      observer.disconnect();
      for (const stop of stops) stop();
      canvas.removeEventListener('webglcontextlost', lost);
      gl?.dispose();
      root.remove();
    },
  };
}

interface Prepared {
  readonly units: StageUnits;
  readonly touched: readonly Grid[];
  readonly others: readonly Grid[];
  readonly still: {
    readonly ground: readonly Stroke[];
    readonly touched: readonly Stroke[];
    readonly others: readonly Stroke[];
  };
}

/** The parts of the picture that do not depend on the view. */
function prepare({ stage, touched, others }: TreeScene): Prepared {
  const units = new StageUnits(stage);
  const sampled = ({ patches }: TreeScene['touched']): Grid[] =>
    patches.map((patch) => tessellate(patch, units));
  const noRings = others.patches.map((patch) => ({ ...patch, rings: [] }));
  const drawing = (figure: TreeScene['touched']) => ({ ...figure, grips: [] });
  return {
    units,
    touched: sampled(touched),
    others: sampled(others),
    still: {
      ground: ground(units),
      touched: outline(drawing(touched), units),
      others: outline(drawing({ ...others, patches: noRings }), units).map((stroke) => ({
        ...stroke,
        ...OTHER,
      })),
    },
  };
}

function faint(theme: Theme): Theme {
  const less = ({ base, rim }: Theme['back']) => ({ base: FAINT * base, rim: FAINT * rim });
  return { ...theme, back: less(theme.back), front: less(theme.front) };
}

function svg(name: string): SVGSVGElement {
  const element = document.createElementNS(SVG, 'svg');
  element.setAttribute('class', name);
  element.setAttribute('aria-hidden', 'true');
  return element;
}

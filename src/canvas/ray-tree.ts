import type { FreeView } from '../state/camera-view.ts';
import type { DragPlane } from '../state/picture/drag.ts';
import type { TreeLine, TreeScene } from '../state/picture/tree-scene.ts';
import type { Mounted } from '../ui/mounted.ts';
import { GlPainter } from './gl-painter.ts';
import { ground } from './ground.ts';
import { listenToOrbit } from './orbit.ts';
import { outline } from './outline.ts';
import type { Painter } from './painter.ts';
import { PathPainter } from './path-painter.ts';
import { Projection } from './projection.ts';
import { listenToPicks } from './ray-pick.ts';
import { type LightTools, listenToLights, TreeLights } from './ray-tree-lights.ts';
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
  /** Paths of the rays that are chosen, here or in the list. */
  readonly chosen: ReadonlySet<string>;
  /** Paths of the rays that are there; null for all. */
  readonly shown: ReadonlySet<string> | null;
  /** In so many ms the chosen rays grow from their starts, when they come. */
  readonly growMs: number;
  /** What drags of lights keep to. */
  readonly along: DragPlane;
}

export interface TreeTools {
  /** Chooses a ray, or none. */
  pick(path: string | null): void;
  /** Goes to the next ray or the one before. */
  go(by: 1 | -1): void;
  /** Plays them one after another, or stands still. */
  play(): void;
  readonly lights: LightTools;
}

/** A pixel's rays in space, among the shapes that they touch. Drawn only after a change. */
export function mountTree(host: HTMLElement, tools: TreeTools): Mounted<TreeModel> {
  const root = document.createElement('div');
  root.className = 'scene-root tree-root';
  root.tabIndex = 0;
  root.setAttribute('role', 'group');
  const canvas = document.createElement('canvas');
  canvas.className = 'scene-canvas';
  canvas.setAttribute('aria-hidden', 'true');
  const paths = svg('scene-fallback');
  const overlay = svg('scene-overlay');
  const handles = svg('scene-handles-over');
  handles.removeAttribute('aria-hidden');
  root.append(canvas, paths, overlay, handles);
  host.append(root);
  const gl = GlPainter.on(canvas);
  const lines = new PathPainter(paths);
  const marks = new TreeMarks(overlay);
  const lights = new TreeLights(handles);
  let painter: Painter = gl ?? lines;
  let theme = faint(readTheme(host));
  let model: TreeModel | null = null;
  let prepared: Prepared | null = null;
  let view: FreeView = { azimuth: 0, ...FIRST };
  let [width, height] = [host.clientWidth, host.clientHeight];
  let request = 0;
  let hovered: string | null = null;
  let drawn: { lines: readonly TreeLine[]; units: StageUnits; projection: Projection } | null =
    null;
  /** When the chosen rays began to grow. */
  let grewAt = 0;

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
    const { chosen, growMs, shown } = model;
    const grown = growMs > 0 ? Math.min((performance.now() - grewAt) / growMs, 1) : 1;
    if (grown < 1) ask();
    const lines = model.scene.lines
      .filter(({ path }) => shown === null || shown.has(path))
      .map((line) => (grown < 1 && chosen.has(line.path) ? partOf(line, grown) : line));
    drawn = { lines, units, projection };
    const lit = hovered === null ? chosen : new Set([...chosen, hovered]);
    painter.paint(
      {
        ground: [...still.ground, ...still.others, ...edges(others, OTHER)],
        ray: lineStrokes(lines, lit, units),
        shape: [...still.touched, ...edges(touched, TOUCHED)],
      },
      projection,
      theme,
    );
    marks.draw(lines, lit, units, projection, theme);
    lights.draw(model.scene.lights, units, projection, theme);
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
  const controller = new AbortController();
  const { signal } = controller;
  listenToLights(root, () => (model && drawn ? { ...drawn, model } : null), tools.lights, signal);
  listenToPicks(
    root,
    {
      drawn: () => drawn,
      hover(path) {
        if (path === hovered) return;
        hovered = path;
        root.classList.toggle('on-ray', path !== null);
        ask();
      },
      pick: tools.pick,
    },
    signal,
  );
  const keys: Readonly<Record<string, () => void>> = {
    PageDown: () => tools.go(1),
    PageUp: () => tools.go(-1),
    ' ': tools.play,
    Escape: () => tools.pick(null),
  };
  root.addEventListener(
    'keydown',
    (event) => {
      const press = keys[event.key];
      if (!press || event.target !== root) return;
      if (event.ctrlKey || event.altKey || event.metaKey) return;
      event.preventDefault();
      event.stopPropagation();
      press();
    },
    { signal },
  );
  const stops = [
    () => controller.abort(),
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
          `${next.scene.description}. Arrow keys turn it, plus and minus zoom, 0 goes back. Page ` +
            'Down and Page Up choose a ray, Space plays them one after another.',
        );
      } else if (isSame(next, model)) return;
      const isLess = matchMedia('(prefers-reduced-motion: reduce)').matches;
      if (!sameSet(next.chosen, model?.chosen ?? null)) grewAt = performance.now();
      model = isLess ? { ...next, growMs: 0 } : next;
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

const sameSet = (a: ReadonlySet<string> | null, b: ReadonlySet<string> | null): boolean =>
  a === b || (a !== null && b !== null && a.size === b.size && [...a].every((x) => b.has(x)));

const isSame = (a: TreeModel, b: TreeModel): boolean =>
  a.along === b.along &&
  sameSet(a.chosen, b.chosen) &&
  sameSet(a.shown, b.shown) &&
  a.growMs === b.growMs;

/** The first part of a ray, before it has come to its end. */
function partOf(line: TreeLine, share: number): TreeLine {
  const { from, to } = line;
  const at = (i: 0 | 1 | 2): number => from[i] + share * (to[i] - from[i]);
  return { ...line, to: [at(0), at(1), at(2)], end: 'background', light: null };
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

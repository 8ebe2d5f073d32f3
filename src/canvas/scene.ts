import type { Dispatch } from '../state/actions.ts';
import type { SceneModel } from '../state/scene-model.ts';
import type { FreeView } from '../state/view.ts';
import { highlighted, onHighlight } from '../ui/highlight.ts';
import type { Mounted } from '../ui/mounted.ts';
import { freeOf, poseOf } from './camera.ts';
import { sceneFrame } from './frame.ts';
import { Glide } from './glide.ts';
import { GlPainter } from './glpainter.ts';
import { Lens } from './lens.ts';
import { listenToOrbit } from './orbit.ts';
import { Overlay } from './overlay.ts';
import type { Painter } from './painter.ts';
import { PathPainter } from './pathpainter.ts';
import './scene.css';
import { Scenery } from './scenery.ts';
import { onThemeChange, readTheme } from './theme.ts';

const NO_WEBGL =
  'This browser has no WebGL: the shading is missing, all lines, numbers, formulas and plots work.';

const FIRST: FreeView = { azimuth: 16, elevation: 14, zoom: 1 };

/**
 * The 3D view. It draws when something changed and never else; `host.dataset.frames` counts the frames. The state owns
 * the camera: gestures ask for a view, and the next render brings it.
 */
export function mountScene(host: HTMLElement, dispatch: Dispatch): Mounted<SceneModel> {
  const frame = sceneFrame(host, dispatch);
  const overlay = new Overlay(frame.overlay);
  const scenery = new Scenery();
  const glide = new Glide();
  const gl = GlPainter.on(frame.canvas);
  const paths = new PathPainter(frame.paths);
  let painter: Painter = gl ?? paths;
  let theme = readTheme(host);
  let model: SceneModel | null = null;
  let [width, height] = [host.clientWidth, host.clientHeight];
  let request = 0;
  let frames = 0;
  let filled = 0;
  host.dataset.frames = '0';

  const ask = () => {
    request ||= requestAnimationFrame(draw);
  };

  function draw(now: number): void {
    request = 0;
    if (!model || width === 0 || height === 0) return;
    const space = scenery.take(model);
    if (filled !== scenery.version) gl?.fill(scenery.grids);
    filled = scenery.version;
    aim(now, false);
    const wasMoving = glide.isMoving;
    const lens = new Lens(glide.pose(now), width, height);
    // At the end of a move the labels may find their best places anew.
    if (wasMoving && !glide.isMoving) overlay.forget();
    const lit = highlighted();
    const strokes = scenery.strokes(model, lens, lit);
    painter.paint(strokes, lens, theme);
    overlay.draw(model, strokes.ray, space, lens, theme, lit);
    host.dataset.frames = String(++frames);
    if (glide.isMoving) ask();
  }

  /** Points the camera at the model's view; `asked` when the view itself changed. */
  function aim(now: number, asked: boolean): void {
    if (!model) return;
    const goal = poseOf(model.view, model.ray, scenery.take(model));
    const how = typeof model.view === 'string' ? 'travel' : 'follow';
    glide.aim(goal, asked ? how : 'jump', now);
  }

  /** Where a gesture starts: the view that was asked for last, even if it is not painted yet; on the way to a named one, where the camera is. */
  function currentView(): FreeView {
    if (model && typeof model.view !== 'string') return model.view;
    return glide.shown ? freeOf(glide.shown) : FIRST;
  }

  function usePainter(next: Painter): void {
    painter = next;
    if (next === gl) paths.dispose();
    frame.root.classList.toggle('scene-without-gl', next !== gl);
    if (model) frame.tell(model, next === gl ? '' : NO_WEBGL);
    ask();
  }

  const lost = (event: Event) => {
    event.preventDefault();
    usePainter(paths);
  };
  const restored = () => {
    if (gl) usePainter(gl);
  };
  frame.canvas.addEventListener('webglcontextlost', lost);
  frame.canvas.addEventListener('webglcontextrestored', restored);
  const observer = new ResizeObserver(() => {
    [width, height] = [host.clientWidth, host.clientHeight];
    frame.resize(width, height);
    // A media query may have changed the sizes of marks and labels.
    theme = readTheme(host);
    ask();
  });
  observer.observe(host);
  const stops = [
    onThemeChange(() => {
      theme = readTheme(host);
      ask();
    }),
    onHighlight(ask),
    listenToOrbit(frame.root, {
      current: currentView,
      turn: (view) => dispatch({ type: 'view', view }),
      home: () => dispatch({ type: 'view', view: 'iso' }),
    }),
  ];
  frame.resize(width, height);
  usePainter(painter);

  return {
    render(next) {
      const viewChanged = model !== null && !sameView(model, next);
      model = next;
      frame.tell(next, painter === gl ? '' : NO_WEBGL);
      if (viewChanged) aim(performance.now(), true);
      ask();
    },
    dispose() {
      cancelAnimationFrame(request);
      observer.disconnect();
      for (const stop of stops) stop();
      frame.canvas.removeEventListener('webglcontextlost', lost);
      frame.canvas.removeEventListener('webglcontextrestored', restored);
      gl?.dispose();
      frame.root.remove();
    },
  };
}

function sameView({ view: a }: SceneModel, { view: b }: SceneModel): boolean {
  if (typeof a === 'string' || typeof b === 'string') return a === b;
  return a.azimuth === b.azimuth && a.elevation === b.elevation && a.zoom === b.zoom;
}

import type { Dispatch } from '../state/actions.ts';
import type { SceneModel } from '../state/scene-model.ts';
import { highlighted, onHighlight } from '../ui/highlight.ts';
import type { Mounted } from '../ui/mounted.ts';
import { DragHandles, handleCaptions, shownArrows } from './drag-handles.ts';
import { GlPainter } from './gl-painter.ts';
import { HandleDrag } from './handle-drag.ts';
import { listenToHandles } from './handle-events.ts';
import { type HandlePlace, placeHandle } from './handle-place.ts';
import { listenToClicks, markedAt } from './mark-on-ray.ts';
import { listenToOrbit } from './orbit.ts';
import { Overlay } from './overlay.ts';
import type { Painter } from './painter.ts';
import { PathPainter } from './path-painter.ts';
import { Projection } from './projection.ts';
import { createSceneElements } from './scene-elements.ts';
import { PNG_SCALE, scenePng } from './scene-png.ts';
import './scene.css';
import { SceneLines } from './scene-lines.ts';
import { onThemeChange, readTheme } from './theme.ts';
import { Viewpoint } from './viewpoint.ts';

interface MountedScene extends Mounted<SceneModel> {
  /** The picture as a PNG; null before there is one. */
  picture(): Promise<Blob | null>;
}

const NO_WEBGL = 'This browser has no WebGL: drawn without shading.';

/**
 * The 3D view. It draws only after a change; `host.dataset.frames` counts the frames. The camera is
 * part of the state: a gesture requests a view, which the next render shows.
 */
export function mountScene(host: HTMLElement, dispatch: Dispatch): MountedScene {
  const frame = createSceneElements(host, dispatch);
  const overlay = new Overlay(frame.overlay);
  const sceneLines = new SceneLines();
  const viewpoint = new Viewpoint();
  const dragHandles = new DragHandles(frame.handles);
  const gl = GlPainter.on(frame.canvas);
  const paths = new PathPainter(frame.paths);
  let painter: Painter = gl ?? paths;
  let theme = readTheme(host);
  let model: SceneModel | null = null;
  let [width, height] = [host.clientWidth, host.clientHeight];
  let request = 0;
  let frames = 0;
  let filled = 0;
  let projection = new Projection({ target: [0, 0, 0], ...viewpoint.current(null) }, 1, 1);
  let handles: readonly HandlePlace[] = [];
  host.dataset.frames = '0';

  const frameNow = () => ({ width, height, scale: theme.scale });
  const ask = () => {
    request ||= requestAnimationFrame((now) => draw(now));
  };

  function draw(now: number, ratio?: number): void {
    request = 0;
    if (!model || width === 0 || height === 0) return;
    const shown = viewpoint.framed(model);
    const units = sceneLines.take(shown);
    if (filled !== sceneLines.version) gl?.fill(sceneLines.grids);
    filled = sceneLines.version;
    viewpoint.aim(shown, units, frameNow(), now);
    const wasMoving = viewpoint.isMoving;
    projection = new Projection(viewpoint.pose(now), width, height);
    // After a camera transition labels choose their best places again.
    if (wasMoving && !viewpoint.isMoving) overlay.forget();
    const lit = highlighted(host);
    const strokes = sceneLines.strokes(shown, projection, lit);
    painter.paint(strokes, projection, theme, ratio);
    handles = shown.handles.map((handle) => placeHandle(handle, units, projection));
    const words = handleCaptions(handles, drag.shown, projection, theme.scale);
    const arrows = shownArrows(handles, drag.shown, projection, theme);
    overlay.draw(shown, strokes.ray, units, projection, theme, lit, words, arrows);
    dragHandles.draw(handles, drag.shown, projection, theme, frame.keys);
    host.dataset.frames = String(++frames);
    if (viewpoint.isMoving) ask();
  }

  const units = () => sceneLines.take(viewpoint.framed(model as SceneModel));
  const drag = new HandleDrag({
    ...{ units, dispatch, changed: ask },
    projection: () => projection,
    hold: () => model && viewpoint.hold(viewpoint.framed(model).stage),
    release: () =>
      model && viewpoint.release(model, sceneLines.take(model), frameNow(), performance.now()),
  });

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
    onThemeChange(host, () => {
      theme = readTheme(host);
      ask();
    }),
    onHighlight(host, ask),
    listenToHandles(frame.handles, drag, () => handles),
    listenToClicks(frame.root, (at, pointer) => {
      if (!model?.mark?.isOpen) return;
      const t = markedAt(viewpoint.framed(model), units(), projection, at, pointer);
      if (t !== null) dispatch({ type: 'bead', t });
    }),
    listenToOrbit(frame.root, {
      current: () => viewpoint.current(model),
      keep: () => {
        const view = model?.view ?? 'iso';
        return () => dispatch({ type: 'view', view });
      },
      turn: (view) => dispatch({ type: 'view', view }),
      home: () => dispatch({ type: 'view', view: 'iso' }),
    }),
  ];
  frame.resize(width, height);
  usePainter(painter);

  return {
    render(next) {
      model = next;
      frame.tell(next, painter === gl ? '' : NO_WEBGL);
      // The initial view is shown without a transition.
      if (frames > 0) viewpoint.aim(next, units(), frameNow(), performance.now());
      ask();
    },
    async picture() {
      cancelAnimationFrame(request);
      draw(performance.now(), PNG_SCALE);
      const picture = scenePng(
        frame.root,
        painter === gl ? frame.canvas : frame.paths,
        frame.overlay,
      );
      // Draws again at the screen's resolution.
      ask();
      return model && picture;
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

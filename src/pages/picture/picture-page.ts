import { nothing, render } from 'lit';
import type { Vec3 } from '../../math/index.ts';
import { DEFAULT_METHOD } from '../../math/shapes.ts';
import { pictureBar } from '../../panels/picture-bar.ts';
import { budgetPanel, budgetSaid } from '../../panels/picture-budget.ts';
import { cameraLine } from '../../panels/picture-camera.ts';
import { type CompareTools, sidePickers } from '../../panels/picture-compare.ts';
import { growthPanel, growthSaid } from '../../panels/picture-growth.ts';
import type { Scene } from '../../scene/types.ts';
import { firstAgainst } from '../../state/picture/comparison.ts';
import { arrowStep, movedFrom } from '../../state/picture/drag.ts';
import type { Measure } from '../../state/picture/ledger.ts';
import {
  type PictureSettings,
  pictureSettings,
  readPicture,
} from '../../state/picture/settings.ts';
import type { Picture } from '../../tracer/compare.ts';
import type { MountPage, PageContext, PageView } from '../page.ts';
import { createBudgetSearch } from './budget.ts';
import { atRest, createCameraMotion } from './camera-motion.ts';
import { createCompareView } from './compare-view.ts';
import { compareViewModel } from './compare-view-model.ts';
import { type DraggedThing, dragTo, thingAt } from './dragged-thing.ts';
import { openScene, pictureExports } from './exports.ts';
import { createGrowth } from './growth.ts';
import { lazyRayTree } from './lazy-ray-tree.ts';
import { pictureActions } from './page-actions.ts';
import { type PictureModel, type PictureVisit, pictureModel } from './picture-model.ts';
import { createPixelMagnifier } from './pixel-magnifier.ts';
import { createPixelMap } from './pixel-map.ts';
import { createPixelView } from './pixel-view.ts';
import { createRayRecorder } from './ray-recorder.ts';
import { createRefiner, MOST_SAMPLES, oneAfterAnother } from './refiner.ts';
import { createRepeats } from './repeats.ts';
import { createSceneHandles, placeWords } from './scene-handles.ts';
import { createSidePanel } from './side-panel.ts';
import { loadTracer, type StartTracer } from './start-tracer.ts';
import { statusLine } from './status-line.ts';
import { themeColours } from './theme-colours.ts';
import { coresOf, createTraceQueue } from './trace-queue.ts';
import { type TraceRequest, type TraceRequests, traceRequests } from './trace-request.ts';
import './picture-page.css';

/** The page, once it is known how its workers are started. */
export async function loadPicture(): Promise<MountPage> {
  const spawn = await loadTracer(coresOf(navigator));
  return (host, context) => mountPicture(host, context, spawn);
}

/** The picture with its bars and panels on the left; ledger or scene editor on the right. */
function mountPicture(host: HTMLElement, context: PageContext, spawn: StartTracer): PageView {
  const { changed, dispatch, announce } = context;
  const parts = sections(host);
  const tools = pictureActions(dispatch);
  const repeats = createRepeats();
  const refiner = createRefiner();
  const growth = createGrowth();
  const budgets = createBudgetSearch();
  const cameraMotion = createCameraMotion({
    changed,
    rest(edit) {
      landed = true;
      const { height } = still;
      tools.scene((scene) => ({ ...scene, camera: atRest(edit, height)(scene.camera) }));
    },
  });
  const traceQueue = createTraceQueue({
    spawn,
    workers: coresOf(navigator),
    changed,
    background: oneAfterAnother(repeats, budgets, growth, refiner),
  });
  const compareView = createCompareView(parts.compareView, {
    split: (edit) => tools.edit(({ split }) => ({ split: String(edit(split)) })),
    pixel: (x, y) => tools.set({ pixel: `${x},${y}` }),
    cursor: (x, y) => announce(`pixel ${x}, ${y}: ${pixelMap.words(x, y)}`),
    point,
    grab(x, y) {
      const frame = sidePanel.isEditing() ? model?.main?.frame : undefined;
      held = model && frame ? thingAt(model.picture.scene, frame, x, y) : null;
      if (held) sidePanel.edit(held.id);
      return held !== null;
    },
    drag(x, y) {
      if (held && model) tools.scene(dragTo(held, x, y, model.picture.along));
    },
    drop(isCancelled) {
      const taken = held;
      held = null;
      if (taken && isCancelled) tools.scene(() => taken.scene);
    },
    camera: {
      move(edit) {
        hinted = true;
        cameraMotion.move(edit);
      },
      hold: cameraMotion.hold,
      release: cameraMotion.release,
    },
  });
  const pixelMap = createPixelMap(parts.map, {
    show: (what) => tools.set({ show: what === 'questions' ? 'both' : what }),
    point,
    choose: (x, y) => tools.set({ pixel: `${x},${y}` }),
  });
  const magnifier = createPixelMagnifier(parts.magnifiers);
  const pixels = createPixelView(createRayRecorder(spawn), {
    changed,
    announce,
    close: () => tools.set({ pixel: '' }),
  });
  const treeView = lazyRayTree(parts.space, {
    ...pixels,
    lights: {
      hold() {
        taken = model?.picture.scene ?? null;
        pixels.hold(true);
      },
      drag(id, by) {
        if (taken) tools.scene(movedFrom(taken, id, by));
      },
      drop(isCancelled) {
        const before = taken;
        taken = null;
        if (before && isCancelled) tools.scene(() => before);
        pixels.hold(false);
      },
      press: (id, way, isFine) =>
        model && moveBy(id, way(arrowStep(model.picture.scene, id, isFine))),
    },
  });
  const moveBy = (id: string, by: Vec3): void => {
    tools.scene((now) => movedFrom(now, id, by)(now));
    announce(() => (model ? placeWords(model.picture.scene, id) : ''), 'place');
  };
  /** Key of the picture for which the ledger's last column was requested; '' for none. */
  let counting = '';
  let held: DraggedThing | null = null;
  /** The scene in which a light was taken hold of in the view in space. */
  let taken: Scene | null = null;
  let told = '';
  let by: Measure = 'questions';
  /** The settings of the picture at rest, while the camera moves too. */
  let still: PictureSettings = pictureSettings({});
  /** Whether the picture is the first one after the camera moved. */
  let landed = false;
  let hinted = false;
  let pointed: readonly [number, number] | null = null;
  let model: PictureModel | null = null;
  const sidePanel = createSidePanel(parts.sidePanel, {
    dispatch,
    changed,
    announce,
    tools,
    asks: {
      by(measure) {
        by = measure;
        changed();
      },
      count() {
        counting = model?.requests.main.key ?? '';
        changed();
      },
      isCounting: () => counting === model?.requests.main.key && traceQueue.current() !== null,
      time() {
        if (model) repeats.start(toTime(model.requests));
        changed();
      },
      stopTiming() {
        repeats.stop();
        changed();
      },
      timing: repeats.progress,
    },
  });
  const handles = createSceneHandles(parts.handles, {
    scene: tools.scene,
    edit: (id) => sidePanel.edit(id),
    move: moveBy,
  });
  const compareTools: CompareTools = {
    left: (value) => tools.set({ against: value }),
    right: tools.right,
  };

  /** Begins the comparison that the scene promises, or ends the one that there is. */
  const compare = ({ main }: TraceRequests): void =>
    tools.edit(({ against, sceneText, start, forced }) => ({
      against: against ? '' : firstAgainst(sceneText, start, main.settings.method, forced),
      show: against ? 'both' : 'errors',
    }));

  const bar = ({ picture, requests }: PictureModel) =>
    pictureBar(picture, {
      set: tools.set,
      compare: () => compare(requests),
      again: () => traceQueue.again([requests.main, ...(requests.other ? [requests.other] : [])]),
      cancel: traceQueue.cancel,
      isTracing: traceQueue.current() !== null,
      hasSoftLight: picture.scene.lights.some(({ light }) => light === 'sphere'),
    });

  const over = ({ picture: { scene, against }, requests: { main, other } }: PictureModel) =>
    against && other
      ? sidePickers(scene, main.settings, other.settings, against, compareTools)
      : nothing;

  /** How to move the camera, until somebody has; and how fine the picture has become. */
  const restLine = ({ picture: { against }, requests: { main } }: PictureModel) => {
    const done = refiner.progress(main);
    return cameraLine({
      hint: !hinted && against === null && !sidePanel.isEditing(),
      done: cameraMotion.isMoving() ? null : done,
      most: MOST_SAMPLES,
      refines: refiner.next() !== null,
      stop() {
        refiner.stop();
        changed();
      },
    });
  };

  const drawPixel = (now: PictureModel): void => {
    const { picture, main, other } = now;
    render(pixels.panel(now), parts.rays);
    parts.pixel.classList.toggle('compared', picture.against !== null);
    magnifier.render(
      picture.pixel && {
        pixel: picture.pixel,
        left: other?.frame ?? null,
        right: main?.frame ?? null,
        comparing: picture.against !== null,
      },
    );
    treeView.render(pixels.space(now));
    render(pixels.bar() ?? nothing, parts.play);
    showRow(parts.rays, pixels.wanted());
  };

  const drawMap = ({ picture, main, comparison }: PictureModel): void => {
    pixelMap.render({
      frame: main?.state === 'finished' ? main.frame : null,
      size: [picture.width, picture.height],
      comparing: picture.against !== null,
      comparison,
      show: picture.show === 'both' ? 'questions' : picture.show,
      pixel: pointed ?? picture.pixel,
      theme: themeColours(host).join(),
    });
  };

  const drawPrices = (
    { picture: { budget }, ledger: { by: measure } }: PictureModel,
    stands: boolean,
  ): void => {
    const stop = (run: () => void) => () => {
      run();
      changed();
    };
    render(
      growthPanel(growth.state(), measure, {
        stands,
        measure: () => tools.set({ growth: 'on' }),
        stop: stop(growth.stop),
        again: stop(growth.again),
        close: () => tools.set({ growth: '' }),
      }),
      parts.growth,
    );
    render(
      budgetPanel(budget, budgets.state(), {
        set: (text) => tools.set({ budget: text }),
        stop: stop(budgets.stop),
        again: stop(budgets.again),
        show: tools.showBesideWhole,
        pixel: (x, y) => tools.set({ pixel: `${x},${y}` }),
      }),
      parts.budget,
    );
  };

  function point(pixel: readonly [number, number] | null): void {
    if (pixel?.join() === pointed?.join()) return;
    pointed = pixel;
    if (model) drawMap(model);
  }

  /** The picture with as many rays a pixel as it has got; in a comparison the right one. */
  const shown = (): Picture | null =>
    model && (refiner.finer(model.requests.main) ?? model.main?.frame ?? null);

  const visit = (): PictureVisit => ({ by, times: repeats.times });

  /** Announces once that the picture is finished, and what was simulated. */
  const tell = ({ requests, main, ledger: { total, simulated } }: PictureModel): void => {
    if (main?.state !== 'finished' || told === requests.main.key) return;
    told = requests.main.key;
    const names = simulated.map(({ title }) => title).join(', ') || 'nothing but camera rays';
    announce(`picture finished: ${total.rays} rays; simulated: ${names}`);
  };

  /** Says once what was found of the prices. */
  let toldPrices = '';
  const tellPrices = ({ ledger: { by: measure } }: PictureModel): void => {
    const [grown, sought] = [growth.state(), budgets.state()];
    const found = [grown && growthSaid(grown, measure), sought && budgetSaid(sought)];
    const words = found.filter(Boolean).join('. ');
    if (words !== '' && words !== toldPrices) announce(words);
    toldPrices = words;
  };

  return {
    render(state) {
      still = pictureSettings(state.settings.picture);
      const seenOf = (moved: PictureSettings) =>
        traceQueue.seen(traceRequests(moved, state.method).main);
      const moves = cameraMotion.isMoving();
      const moving = moves ? cameraMotion.coarsePictures(still, seenOf, performance.now()) : null;
      const picture = moving ? (moving.shown ?? moving.next) : still;
      const modelNow = (): PictureModel => pictureModel(state, traceQueue, visit(), picture);
      const { requests, uncounted, main } = modelNow();
      if (!repeats.isOf(requests.main)) repeats.stop();
      const stands = !moves && main?.state === 'finished';
      refiner.setPicture(stands && isRefined(picture) ? requests.main : null, main?.frame ?? null);
      // While the camera moves both are paused and keep their results.
      growth.setPaused(!stands);
      budgets.setPaused(!stands);
      if (!moves) {
        growth.setPicture(picture.grows ? requests.main : null);
        budgets.setPicture(wholeRequest(picture), picture.budget);
      }
      traceQueue.want(
        moving
          ? [{ ...traceRequests(moving.next, state.method).main, atOnce: true }]
          : [
              requests.main,
              ...(requests.other ? [requests.other] : []),
              ...requests.baselines,
              ...(counting === requests.main.key ? uncounted : []),
            ],
      );
      model = modelNow();
      if (landed && model.main && (model.main.state === 'finished' || model.main.step <= 2)) {
        landed = moves;
      }
      render(bar({ ...model, picture: still }), parts.bar);
      compareView.render(
        compareViewModel(model, {
          still,
          finer: refiner.finer(requests.main),
          waits: moves || landed,
        }),
      );
      render(over(model), compareView.over);
      render(restLine(model), parts.rest);
      render(
        statusLine({ ...model, picture: still }, traceQueue, moves, () => compare(requests)),
        parts.status,
      );
      drawMap(model);
      drawPixel(model);
      drawPrices(model, stands);
      sidePanel.render(state, model);
      handles.render(sidePanel.isEditing() && !moves ? still : null, sidePanel.edited());
      host.classList.toggle('editing', sidePanel.isEditing());
      host.dataset.trace = moves ? 'moving' : (model.main?.state ?? 'waiting');
      const refined = refiner.progress(requests.main);
      host.dataset.rest = refined === null || !refiner.next() ? 'still' : 'refining';
      host.dataset.prices = growth.state()?.runs || budgets.state()?.runs ? 'runs' : 'rests';
      if (!moves) tell(model);
      tellPrices(model);
    },
    read: readPicture,
    exports: () => pictureExports(() => model, shown, growth.state, budgets.state),
    open: (text) => openScene(text, dispatch),
    turn: tools.buildUp,
    rest() {
      pixels.rest();
      traceQueue.rest();
    },
  };
}

/** The picture of which nothing is left out. */
const wholeRequest = (picture: PictureSettings): TraceRequest | null =>
  traceRequests({ ...picture, against: { change: 'whole' } }, DEFAULT_METHOD).other;

/** More rays a pixel are for a picture alone: a comparison is of the rays that were asked for. */
const isRefined = ({ against, samples }: PictureSettings): boolean =>
  against === null && samples < MOST_SAMPLES;

/** The pictures whose times are measured in turn: the shown ones, and those without forcing. */
const toTime = ({ main, other, baselines }: TraceRequests): readonly TraceRequest[] => [
  main,
  ...(other ? [other] : []),
  ...baselines.filter(({ key }) => key !== other?.key),
];

/** Scrolls the list of rays, not the page, until a row is in view. */
function showRow(list: HTMLElement, path: string | null): void {
  const row = path === null ? null : list.querySelector(`[data-ray="${path}"]`);
  const room = row?.closest('.rays-room');
  if (!row || !room) return;
  const [at, frame] = [row.getBoundingClientRect(), room.getBoundingClientRect()];
  if (at.top < frame.top) room.scrollTop -= frame.top - at.top;
  if (at.bottom > frame.bottom) room.scrollTop += at.bottom - frame.bottom;
}

function sections(host: HTMLElement) {
  host.classList.add('picture');
  const section = (className: string, parent: Element = host): HTMLElement => {
    const element = document.createElement('div');
    element.className = className;
    parent.append(element);
    return element;
  };
  const work = section('picture-work');
  const bar = section('picture-bar', work);
  const compareView = section('compare-view', work);
  const status = section('picture-status', work);
  const rest = section('picture-rest', compareView);
  const handles = section('picture-handles', compareView);
  const map = section('picture-map');
  const more = section('picture-more');
  const pixel = section('picture-pixel', more);
  const growth = section('picture-growth', more);
  const budget = section('picture-budget', more);
  const side = section('side-panel');
  const rays = section('pixel-list', pixel);
  const magnifiers = section('magnifiers', pixel);
  const beside = section('pixel-beside', pixel);
  const space = section('pixel-space', beside);
  const play = section('pixel-play', beside);
  return {
    bar,
    compareView,
    rest,
    handles,
    status,
    map,
    pixel,
    growth,
    budget,
    rays,
    magnifiers,
    space,
    play,
    sidePanel: side,
  };
}

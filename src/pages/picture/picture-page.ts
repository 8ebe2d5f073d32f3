import { nothing, render } from 'lit';
import { pictureBar } from '../../panels/picture-bar.ts';
import { type CompareTools, sidePickers } from '../../panels/picture-compare.ts';
import { firstAgainst } from '../../state/picture/against.ts';
import { readPicture } from '../../state/picture/settings.ts';
import { download } from '../../ui/files.ts';
import type { MountPage, PageContext, PageView } from '../page.ts';
import { createEasel } from './compare-view.ts';
import { easelModel } from './compare-view-model.ts';
import { dragged, type Grabbed, grabAt } from './drag-thing.ts';
import { openScene, pictureBlob, pictureTakeaways } from './exports.ts';
import { lateTree } from './late-ray-tree.ts';
import { pageTools } from './page-actions.ts';
import { type Sight, sightOf } from './picture-model.ts';
import { createLoupe } from './pixel-magnifier.ts';
import { createPixelView } from './pixel-view.ts';
import { createRecorder } from './ray-recorder.ts';
import { createBeside } from './side-panel.ts';
import { type Spawn, tracerSpawner } from './start-tracer.ts';
import { below } from './status-line.ts';
import { coresOf, createDarkroom } from './trace-queue.ts';
import './picture-page.css';

/** The page, once it is known how its workers are started. */
export async function loadPicture(): Promise<MountPage> {
  const spawn = await tracerSpawner();
  return (host, context) => mountPicture(host, context, spawn);
}

/** The picture with what lies over it and below it on the left; what it cost, or its scene, on the right. */
function mountPicture(host: HTMLElement, context: PageContext, spawn: Spawn): PageView {
  const { changed, dispatch, announce } = context;
  const parts = sections(host);
  const tools = pageTools(dispatch);
  const darkroom = createDarkroom({ spawn, workers: coresOf(navigator), changed });
  const easel = createEasel(parts.easel, {
    split: (edit) => tools.edit(({ split }) => ({ split: String(edit(split)) })),
    pixel: (x, y) => tools.set({ pixel: `${x},${y}` }),
    cursor: (x, y) => announce(`pixel ${x}, ${y}`),
    grab(x, y) {
      const frame = beside.isEditing() ? sight?.main?.frame : undefined;
      held = sight && frame ? grabAt(sight.picture.scene, frame, x, y) : null;
      if (held) beside.edit(held.id);
      return held !== null;
    },
    drag(x, y) {
      if (held) tools.scene(dragged(held, x, y));
    },
  });
  const loupe = createLoupe(parts.loupes);
  const space = lateTree(parts.space);
  const pixels = createPixelView(createRecorder(spawn), {
    changed,
    announce,
    close: () => tools.set({ pixel: '' }),
  });
  /** The picture for which the ledger's last column was asked. */
  let counting = '';
  let held: Grabbed | null = null;
  let told = '';
  let sight: Sight | null = null;
  const beside = createBeside(parts.beside, {
    dispatch,
    changed,
    tools,
    count() {
      counting = sight?.shots.main.key ?? '';
      changed();
    },
    isCounting: () => counting === sight?.shots.main.key && darkroom.current() !== null,
  });
  const compareTools: CompareTools = {
    left: (value) => tools.set({ against: value }),
    right: tools.right,
    show: (show) => tools.set({ show }),
  };

  const save = async (): Promise<void> => {
    const blob = await pictureBlob(sight);
    if (blob) download('graze-picture.png', blob);
  };

  const bar = ({ picture, shots }: Sight) =>
    pictureBar(picture, {
      set: tools.set,
      compare: () =>
        tools.edit(({ against, sceneText, start }) => ({
          against: against ? '' : firstAgainst(sceneText, start, shots.main.settings.method),
          show: 'both',
        })),
      again: () => darkroom.again([shots.main, ...(shots.other ? [shots.other] : [])]),
      cancel: darkroom.cancel,
      save: () => void save(),
      isTracing: darkroom.current() !== null,
      hasSoftLight: picture.scene.lights.some(({ light }) => light === 'sphere'),
    });

  const over = ({ picture: { scene, against }, shots: { main, other } }: Sight) =>
    against && other
      ? sidePickers(scene, main.settings, other.settings, against, compareTools)
      : nothing;

  const drawPixel = (now: Sight): void => {
    const { picture, main, other } = now;
    render(pixels.panel(now), parts.rays);
    parts.pixel.classList.toggle('compared', picture.against !== null);
    loupe.render(
      picture.pixel && {
        pixel: picture.pixel,
        left: other?.frame ?? null,
        right: main?.frame ?? null,
        comparing: picture.against !== null,
      },
    );
    space.render(pixels.space(now));
  };

  /** Said once, when the picture that is asked for is done. */
  const tell = ({ shots, main, ledger: { total, simulated } }: Sight): void => {
    if (main?.state !== 'finished' || told === shots.main.key) return;
    told = shots.main.key;
    const names = simulated.map(({ title }) => title).join(', ') || 'nothing but camera rays';
    announce(`picture finished: ${total.rays} rays; simulated: ${names}`);
  };

  return {
    render(state) {
      const { shots, uncounted } = sightOf(state, darkroom);
      darkroom.want([
        shots.main,
        ...(shots.other ? [shots.other] : []),
        ...shots.baselines,
        ...(counting === shots.main.key ? uncounted : []),
      ]);
      sight = sightOf(state, darkroom);
      render(bar(sight), parts.bar);
      easel.render(easelModel(sight, host));
      render(over(sight), easel.over);
      render(below(sight, darkroom, compareTools), parts.status);
      drawPixel(sight);
      beside.render(state, sight);
      host.classList.toggle('editing', beside.isEditing());
      host.dataset.trace = sight.main?.state ?? 'waiting';
      tell(sight);
    },
    read: readPicture,
    takeaways: () => pictureTakeaways(() => sight),
    open: (text) => openScene(text, dispatch),
    rest: darkroom.rest,
  };
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
  const easel = section('easel', work);
  const status = section('picture-status', work);
  const pixel = section('picture-pixel', work);
  const rays = section('pixel-list', pixel);
  const loupes = section('loupes', pixel);
  const space = section('pixel-space', pixel);
  return { bar, easel, status, pixel, rays, loupes, space, beside: section('picture-beside') };
}

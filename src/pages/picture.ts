import { html, nothing, render, type TemplateResult } from 'lit';
import { pictureBar } from '../panels/picture-bar.ts';
import { comparisonWords, sidePickers } from '../panels/picture-compare.ts';
import { editor } from '../panels/picture-editor.ts';
import { ledger } from '../panels/picture-ledger.ts';
import { methodPanel } from '../panels/picture-method.ts';
import { pictureStatus } from '../panels/picture-status.ts';
import { sceneToJson } from '../scene/json.ts';
import { findPreset } from '../scene/presets/index.ts';
import { textOfScene } from '../state/picture/scene-link.ts';
import { readPicture } from '../state/picture/settings.ts';
import { type AppState, shapeOf } from '../state/state.ts';
import { download, pickFile } from '../ui/files.ts';
import type { MountPage, PageContext, PageView } from './page.ts';
import { coresOf, createDarkroom } from './picture/darkroom.ts';
import { createEasel, type EaselModel } from './picture/easel.ts';
import { errorMap } from './picture/error-map.ts';
import { lateTree } from './picture/late-tree.ts';
import { createPixelView } from './picture/pixel-view.ts';
import { createRecorder } from './picture/recorder.ts';
import { type Sight, sightOf } from './picture/sight.ts';
import { type Spawn, tracerSpawner } from './picture/spawn.ts';
import { openScene, pictureBlob, pictureTakeaways } from './picture/takeaways.ts';
import { inkOf } from './picture/theme-ink.ts';
import { type PageTools, pageTools } from './picture/tools.ts';
import './picture.css';

/** The picture with what lies over it and below it on the left; what it cost, or its scene, on the right. */
export async function loadPicture(): Promise<MountPage> {
  const spawn = await tracerSpawner();
  return (host, context) => mountPicture(host, context, spawn);
}

function mountPicture(host: HTMLElement, context: PageContext, spawn: Spawn): PageView {
  host.classList.add('picture');
  const section = (className: string, parent: Element = host): HTMLElement => {
    const element = document.createElement('div');
    element.className = className;
    parent.append(element);
    return element;
  };
  const work = section('picture-work');
  const bar = section('picture-bar', work);
  const { changed, dispatch, announce } = context;
  const darkroom = createDarkroom({ spawn, workers: coresOf(navigator), changed });
  const tools = pageTools(dispatch);
  const easel = createEasel(section('easel', work), {
    split: (percent) => tools.set({ split: String(percent) }),
    pixel: (x, y) => tools.set({ pixel: `${x},${y}` }),
    cursor: (x, y) => announce(`pixel ${x}, ${y}`),
  });
  const status = section('picture-status', work);
  const pixelHost = section('picture-pixel', work);
  const pixelList = section('pixel-list', pixelHost);
  const space = lateTree(section('pixel-space', pixelHost));
  const beside = section('picture-beside');
  const pixels = createPixelView(createRecorder(spawn), {
    changed,
    announce,
    close: () => tools.set({ pixel: '' }),
  });
  let sight: Sight | null = null;
  /** The picture for which the ledger's last column was asked. */
  let counting = '';
  let told = '';

  const tracing = (): boolean => darkroom.current() !== null;

  const draw = (state: AppState, now: Sight): void => {
    const { picture, shots, main, other, comparison } = now;
    render(
      pictureBar(picture, {
        set: tools.set,
        compare: () => tools.set({ against: picture.against ? '' : 'start:none', show: 'both' }),
        again: () => darkroom.again([shots.main, ...(shots.other ? [shots.other] : [])]),
        cancel: darkroom.cancel,
        save: () => void save(),
        isTracing: tracing(),
        hasSoftLight: picture.scene.lights.some(({ light }) => light === 'sphere'),
      }),
      bar,
    );
    easel.render(easelModel(now, host));
    render(over(now), easel.over);
    render(below(now), status);
    render(pixels.panel(now), pixelList);
    pixelHost.classList.toggle('compared', picture.against !== null);
    space.render(pixels.space(now));
    render(right(state, now), beside);
    host.dataset.trace = main?.state ?? 'waiting';
    host.dataset.compared = String(comparison !== null || (shots.other === null && other === null));
  };

  const over = ({ picture, shots }: Sight): TemplateResult | typeof nothing =>
    picture.against && shots.other
      ? sidePickers(picture.scene, shots.main.settings, shots.other.settings, picture.against, {
          left: (value) => tools.set({ against: value }),
          right: tools.right,
          show: (show) => tools.set({ show }),
        })
      : nothing;

  const below = ({
    picture,
    shots,
    main,
    other,
    comparison,
    trustsLeft,
  }: Sight): TemplateResult => {
    const current = darkroom.current();
    const what = current?.key === shots.main.key ? 'tracing' : current ? 'tracing to compare' : '';
    const running = current && darkroom.seen(current);
    const middle = picture.against
      ? comparisonWords(
          shots.main.settings,
          picture.against,
          comparison,
          trustsLeft,
          picture.show,
          {
            left: (value) => tools.set({ against: value }),
            right: tools.right,
            show: (show) => tools.set({ show }),
          },
        )
      : html`<p>${findPreset(picture.sceneText)?.reason ?? `${picture.scene.title}, edited`}</p>`;
    return pictureStatus(running ?? main, what, middle, other);
  };

  const right = (state: AppState, now: Sight): TemplateResult => {
    const { picture, shots, uncounted } = now;
    if (picture.beside === 'scene') {
      return html`${besideTabs(picture.beside, tools)}
        <div role="tabpanel" aria-label="Scene">${editor(
          picture.scene,
          picture.edit,
          shapeOf(state),
          {
            change: (scene, edit) =>
              tools.set({ scene: textOfScene(scene), ...(edit === undefined ? {} : { edit }) }),
            edit: (edit) => tools.set({ edit: edit ?? '' }),
            save: () =>
              download('graze-scene.json', sceneToJson(picture.scene), 'application/json'),
            open: () => void openFile(),
          },
        )}</div>`;
    }
    return html`${besideTabs(picture.beside, tools)}
      <div role="tabpanel" aria-label="Ledger">${ledger(now.ledger, {
        force: (id, how) => tools.force(picture, id, how),
        measure: () => {
          counting = shots.main.key;
          changed();
        },
        unmeasured: now.main?.state === 'finished' ? uncounted.length : 0,
        isMeasuring: counting === shots.main.key && uncounted.length > 0 && tracing(),
      })}
      ${methodPanel(state.method, picture, dispatch)}</div>`;
  };

  const openFile = async (): Promise<void> => {
    const text = await pickFile('.json,application/json');
    if (text === null || openScene(text, dispatch)) return;
    dispatch({ type: 'say', problems: ['this file holds no scene'] });
  };

  const save = async (): Promise<void> => {
    const blob = await pictureBlob(sight);
    if (blob) download('graze-picture.png', blob);
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
      draw(state, sight);
      tell(sight);
    },
    read: readPicture,
    takeaways: () => pictureTakeaways(() => sight),
    open: (text) => openScene(text, dispatch),
    rest: darkroom.rest,
  };
}

function besideTabs(current: 'ledger' | 'scene', { set }: PageTools): TemplateResult {
  const tab = (id: 'ledger' | 'scene', words: string): TemplateResult =>
    html`<button type="button" role="tab" aria-selected=${id === current} @click=${() => set({ beside: id })}>${words}</button>`;
  return html`<h2 class="visually-hidden">${current === 'ledger' ? 'What this picture needed' : 'The scene'}</h2>
    <div class="beside-tabs" role="tablist" aria-label="beside the picture">${tab('ledger', 'What this picture needed')}${tab('scene', 'Scene')}</div>`;
}

function easelModel(
  { picture, shots, main, other, comparison }: Sight,
  host: HTMLElement,
): EaselModel {
  const { width, height, against, split, show, pixel } = picture;
  const traced = (progress: typeof main) => (progress && progress.done > 0 ? progress.frame : null);
  const mapped = against !== null && show === 'errors' && comparison !== null;
  const [paper, ink] = mapped ? inkOf(host) : [null, null];
  return {
    width,
    height,
    right: traced(main),
    left: traced(other),
    errors: mapped && paper && ink ? errorMap(comparison, width, height, paper, ink) : null,
    comparing: against !== null,
    split,
    pixel,
    version: [
      ...[shots.main.key, main?.done, main?.state, shots.other?.key, other?.done, other?.state],
      ...[mapped, paper],
    ].join('|'),
  };
}

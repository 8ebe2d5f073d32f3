import { html, nothing, render, type TemplateResult } from 'lit';
import { type EditorTools, editor } from '../../panels/picture-editor.ts';
import { ledger, simplifications } from '../../panels/picture-ledger.ts';
import { methodPanel } from '../../panels/picture-method.ts';
import { twoLedgers } from '../../panels/picture-two-ledgers.ts';
import { remove } from '../../scene/edit.ts';
import { sceneToJson } from '../../scene/json.ts';
import { jsonFault } from '../../scene/json-fault.ts';
import { nameIn } from '../../scene/names.ts';
import type { Dispatch } from '../../state/actions.ts';
import { causeWords } from '../../state/picture/compare-words.ts';
import { sideWords } from '../../state/picture/comparison.ts';
import { exploredThing } from '../../state/picture/edits.ts';
import type { Measure } from '../../state/picture/ledger.ts';
import { type AppState, shapeOf } from '../../state/state.ts';
import type { Announce } from '../../ui/announcer.ts';
import { download, pickFile } from '../../ui/files.ts';
import { openScene } from './exports.ts';
import type { PictureActions } from './page-actions.ts';
import type { PictureModel } from './picture-model.ts';
import type { RepeatProgress } from './repeats.ts';

interface SidePanel {
  /** Whether the scene's forms are shown, so that its shapes can be taken hold of. */
  isEditing(): boolean;
  /** The thing or light whose form is open. */
  edited(): string | null;
  /** Opens the form of a thing or light. */
  edit(id: string): void;
  render(state: AppState, model: PictureModel): void;
}

interface LedgerAsks {
  by(measure: Measure): void;
  /** Counts the pixels that each effect changes. */
  readonly count: () => void;
  readonly isCounting: () => boolean;
  time(): void;
  stopTiming(): void;
  readonly timing: () => RepeatProgress | null;
}

interface SidePanelTools {
  readonly dispatch: Dispatch;
  readonly changed: () => void;
  readonly announce: Announce;
  readonly tools: PictureActions;
  /** What the ledger can be asked for. */
  readonly asks: LedgerAsks;
}

type Tab = 'ledger' | 'scene';

/** The ledger, or the scene's editor. The chosen tab is not part of the state, nor of undo. */
export function createSidePanel(
  host: HTMLElement,
  { dispatch, changed, announce, tools, asks }: SidePanelTools,
): SidePanel {
  let tab: Tab = 'ledger';
  let edited: string | null = null;

  const editorTools = ({ scene: now, along }: PictureModel['picture']): EditorTools => ({
    along,
    drag: (next) => tools.set({ drag: next }),
    change: tools.scene,
    add: (add) =>
      tools.scene((scene) => {
        const [next, id] = add(scene);
        edited = id;
        announce(`${nameIn(next, id)} added`, 'deed');
        return next;
      }),
    remove(id) {
      edited = null;
      tools.scene((scene) => remove(scene, id));
    },
    edit(id) {
      edited = id;
      changed();
    },
    save: () => download('graze-scene.json', sceneToJson(now), 'application/json'),
    open: () => void openFile(dispatch),
  });

  const costs = ({ method }: AppState, model: PictureModel): TemplateResult => {
    const { picture, uncounted, main } = model;
    const stands = main?.state === 'finished';
    const tool = {
      ...asks,
      force: tools.force,
      build: tools.buildUp,
      measure: asks.count,
      unmeasured: stands ? uncounted.length : 0,
      isMeasuring: asks.isCounting() && uncounted.length > 0,
      timing: asks.timing(),
      stands,
    };
    const head = { took: stands ? main : null, resolution: resolutionOf(model) };
    return html`<div role="tabpanel"
      aria-label="What this picture needed">${both(model)}${ledger(model.ledger, head, tool)}
      ${methodPanel(method, picture, dispatch)}
      ${simplifications(picture.scene)}</div>`;
  };

  const form = (state: AppState, { picture }: PictureModel): TemplateResult =>
    html`<div role="tabpanel"
      aria-label="Scene">${editor(
        picture.scene,
        edited,
        {
          shape: shapeOf(state),
          thing: (scene) => exploredThing(scene, shapeOf(state), state.between, state.caps),
        },
        editorTools(picture),
      )}</div>`;

  return {
    isEditing: () => tab === 'scene',
    edited: () => edited,
    edit(id) {
      edited = id;
      changed();
    },
    render(state, model) {
      const turn = (next: Tab): void => {
        tab = next;
        changed();
      };
      const panel = tab === 'scene' ? form(state, model) : costs(state, model);
      render(html`${tabs(tab, turn)}${panel}`, host);
    },
  };
}

/** Both ledgers of a comparison; the one below is the right side's. */
function both({ otherLedger, ledger: own, picture, requests }: PictureModel) {
  const { main, other } = requests;
  if (!otherLedger || !other || !picture.against) return nothing;
  return twoLedgers(otherLedger, own, {
    left: sideWords(other.settings, picture.against),
    right: sideWords(main.settings, picture.against),
    cause: causeWords(picture.scene, main.settings, picture.against),
  });
}

/** Which picture the ledger is of. */
function resolutionOf({ requests: { main } }: PictureModel): string {
  const { width, height, samples } = main.settings;
  return `${width} × ${height}, ${samples === 1 ? '1 ray' : `${samples} rays`} a pixel`;
}

async function openFile(dispatch: Dispatch): Promise<void> {
  const text = await pickFile('.json,application/json');
  if (text === null || openScene(text, dispatch)) return;
  dispatch({
    type: 'say',
    problems: [`this file holds no scene: ${jsonFault(text) ?? 'it has no things'}`],
  });
}

const TITLES = { ledger: 'What this picture needed', scene: 'Scene' } as const;

function tabs(current: Tab, turn: (next: Tab) => void): TemplateResult {
  const tab = (id: Tab): TemplateResult =>
    html`<button type="button" role="tab" aria-selected=${id === current}
      tabindex=${id === current ? 0 : -1} @click=${() => turn(id)}>${TITLES[id]}</button>`;
  const key = (event: KeyboardEvent): void => {
    if (event.key !== 'ArrowLeft' && event.key !== 'ArrowRight') return;
    event.preventDefault();
    turn(current === 'ledger' ? 'scene' : 'ledger');
    const list = event.currentTarget as HTMLElement;
    list.querySelector<HTMLElement>('[aria-selected="false"]')?.focus();
  };
  return html`<h2 class="visually-hidden">${TITLES[current]}</h2>
    <div class="side-tabs" role="tablist" aria-label="beside the picture"
      @keydown=${key}>${tab('ledger')}${tab('scene')}</div>`;
}

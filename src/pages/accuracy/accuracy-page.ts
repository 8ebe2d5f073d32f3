import { html, nothing, render } from 'lit';
import { mountFrontier } from '../../charts/frontier.ts';
import { mountHardness } from '../../charts/hardness.ts';
import type { Picked } from '../../charts/hardness-model.ts';
import { sentenceOf } from '../../lab/sentence.ts';
import type { MeasuredRow } from '../../lab/session.ts';
import { findFamily, type Question } from '../../math/families.ts';
import { quote } from '../../math/shapes.ts';
import { measureBar } from '../../panels/measure-bar.ts';
import { frontierOf, questionOf, titleOf } from '../../state/accuracy/frontier.ts';
import { hardnessOf } from '../../state/accuracy/hardness.ts';
import { createRayModel, type RayModel } from '../../state/accuracy/ladder.ts';
import {
  ACCURACY_KEYS,
  type AccuracySettings,
  readAccuracy,
  writeAccuracy,
} from '../../state/accuracy/settings.ts';
import type { AppState, Settings } from '../../state/state.ts';
import { exploreLink } from '../../state/url.ts';
import type { MountPage } from '../page.ts';
import { plotExports, saveButtons, tableExports } from './exports.ts';
import { measureJob, spawnLab, sweepJob } from './lab-jobs.ts';
import { emptyFrontier, frontierHead, hardnessHead, pickedWords } from './plot-headings.ts';
import { createRayView } from './ray-view.ts';
import { measureRequest, provenanceOf, sameRays, sweepRequest } from './requests.ts';
import type { Findings } from './result-files.ts';
import '../../ui/dialog.css';
import './accuracy-page.css';

/**
 * What accuracy costs in time: this ray, a family's rays against the clock, and how hard rays can
 * get.
 */
export const mountAccuracy: MountPage = (host, { dispatch, changed, announce }) => {
  const set = (settings: Partial<AccuracySettings>): void =>
    dispatch({ type: 'settings', values: writeAccuracy(settings) });
  const rayModel = createRayModel();
  const rayView = createRayView(dispatch, announce);
  const measuring = measureJob(spawnLab, changed);
  const sweeping = sweepJob(spawnLab, changed);
  let picked: Picked | null = null;
  let shown: { state: AppState; settings: AccuracySettings; ray: RayModel } | null = null;

  const { top, leftHead, leftPlot, leftEmpty, rightHead, rightPlot, rightFoot, foot } =
    layOut(host);
  const choose = (id: string): void => dispatch({ type: 'method', id });
  const frontier = mountFrontier(leftPlot, choose);
  const hardness = mountHardness(rightPlot, {
    picked: () => picked,
    pick(next) {
      picked = next;
      changed();
    },
    open: openPicked,
  });

  const saves = tableExports(findings);
  const frontierSaves = plotExports('frontier', leftPlot);
  const hardnessSaves = plotExports('difficulty', rightPlot);

  /**
   * What is measured is read from the settings when they are drawn next: they may have been changed
   * since the last time.
   */
  let isAsked = false;
  function measure(): void {
    isAsked = true;
    changed();
  }

  function rowsNow(): readonly MeasuredRow[] {
    const fits = shown && sameRays(measuring.request, measureRequest(shown.settings));
    return (fits && measuring.result?.rows) || [];
  }

  function findings(): Findings | null {
    if (!shown) return null;
    const { settings, ray } = shown;
    const request = measureRequest(settings);
    return {
      provenance: provenanceOf(measuring.result, request, sweepRequest(settings)),
      settings,
      ray,
      rows: rowsNow(),
      sweep: sweeping.result ?? [],
    };
  }

  function pickedSummary() {
    const point = sweeping.result?.find(({ difficulty }) => difficulty === picked?.difficulty);
    return point?.rows.find(({ id }) => id === picked?.id)?.quality ?? null;
  }

  function openPicked(): void {
    const worst = pickedSummary()?.worst;
    if (!worst || !picked) return;
    dispatch({ type: 'link', hash: exploreLink(worst.shape, worst.ray, picked.id) });
  }

  /** The picked method on its worst ray, in the table and in "Where did the digits go?". */
  function takePicked(): void {
    const worst = pickedSummary()?.worst;
    if (!worst || !picked) return;
    const { id } = picked;
    dispatch({ type: 'open', state: (now) => withRay(now, worst, id) });
    top.scrollIntoView();
  }

  return {
    render(state) {
      const before = shown;
      const settings = settingsOf(state);
      const ray = rayModel(state);
      shown = { state, settings, ray };
      const sweepAsked = sweepRequest(settings);
      const asked = sweeping.request;
      if (!asked || asked.family !== sweepAsked.family || asked.seed !== sweepAsked.seed) {
        picked = null;
        sweeping.start(sweepAsked);
      }
      if (isAsked) measuring.start(measureRequest(settings));
      isAsked = false;
      if (before && measuring.running) {
        if (!sameRays(measuring.request, measureRequest(settings))) measuring.cancel();
      }
      const rows = rowsNow();
      render(rayView(state, ray, rows, settings), top);
      const data = frontierOf({ rows }, settings, state.method);
      render(
        frontierHead(
          settings,
          sentenceOf(rows, questionOf(settings.worth), titleOf),
          frontierSaves,
          set,
        ),
        leftHead,
      );
      leftPlot.hidden = data === null;
      render(data ? nothing : emptyFrontier(rows, measuring.running, measure), leftEmpty);
      if (data) frontier.render(data);
      render(hardnessHead(settings, hardnessSaves, set), rightHead);
      const dial = findFamily(settings.hard)?.dial;
      if (dial && sweeping.result) {
        hardness.render({
          ...hardnessOf(sweeping.result, dial, settings.worth),
          chosen: state.method,
          picked,
        });
      }
      render(
        pickedWords(picked, pickedSummary(), { open: openPicked, take: takePicked }),
        rightFoot,
      );
      const fits = sameRays(measuring.request, measureRequest(settings));
      render(
        html`${measureBar(
          {
            measured: fits ? measuring.result : null,
            running: measuring.running,
            failed: measuring.failed,
            provenance: provenanceOf(
              fits ? measuring.result : null,
              measureRequest(settings),
              sweepAsked,
            ),
          },
          { measure, cancel: measuring.cancel },
        )}
        <p class="acc-take">Take home:
          ${saveButtons(saves, ({ title }) => title)}
        </p>`,
        foot,
      );
    },
    read(given) {
      const { values, problems } = readAccuracy(given);
      const usable = Object.entries(writeAccuracy(values)).filter(([, text]) => text !== null);
      const unknown = Object.keys(given).filter((key) => !ACCURACY_KEYS.some((one) => one === key));
      return {
        settings: Object.fromEntries(usable) as Settings,
        problems: [
          ...problems,
          ...unknown.map((key) => `${quote(key)} means nothing on this page`),
        ],
      };
    },
    exports: () => [...saves, ...frontierSaves, ...hardnessSaves],
    rest() {
      if (measuring.running) measuring.cancel();
    },
  };
};

/** The settings of the link, with the defaults of what it does not say. */
function settingsOf({ settings }: AppState): AccuracySettings {
  return readAccuracy(settings.accuracy).values;
}

function withRay(state: AppState, { shape, ray }: Question, method: string): AppState {
  const shapes = { ...state.shapes, [shape.kind]: shape };
  const { origin: E, direction: d } = ray;
  return { ...state, kind: shape.kind, shapes, E, d, unit: false, method };
}

/** The places of the page, in the order in which the eye and the focus go. */
function layOut(host: HTMLElement) {
  host.classList.add('accuracy');
  const area = (name: string, parent = host): HTMLElement => {
    const element = document.createElement('div');
    element.className = name;
    parent.append(element);
    return element;
  };
  const top = area('acc-ray');
  const plots = area('acc-plots');
  const left = area('acc-plot', plots);
  const right = area('acc-plot', plots);
  return {
    top,
    leftHead: area('acc-plot-head', left),
    leftPlot: area('acc-plot-body', left),
    leftEmpty: area('acc-plot-empty', left),
    rightHead: area('acc-plot-head', right),
    rightPlot: area('acc-plot-body', right),
    rightFoot: area('acc-plot-foot', right),
    foot: area('acc-foot'),
  };
}

import { html, nothing, render } from 'lit';
import { mountFrontier } from '../../charts/frontier.ts';
import { mountHardness } from '../../charts/hardness.ts';
import type { Picked } from '../../charts/hardness-model.ts';
import { findFamily, type Question } from '../../math/families.ts';
import { quote } from '../../math/shapes.ts';
import { measureBar } from '../../panels/measure-bar.ts';
import { frontierOf, questionOf } from '../../state/accuracy/frontier.ts';
import { hardnessOf } from '../../state/accuracy/hardness.ts';
import { createRayModel } from '../../state/accuracy/ladder.ts';
import {
  ACCURACY_KEYS,
  type AccuracySettings,
  readAccuracy,
  writeAccuracy,
} from '../../state/accuracy/settings.ts';
import { createDerive } from '../../state/derive.ts';
import { exploreLink } from '../../state/explore-link.ts';
import type { AppState, Settings } from '../../state/state.ts';
import type { MountPage } from '../page.ts';
import { answerWords, emptyWords, REFERENCE_WORDS } from './answer-words.ts';
import { createAtlas } from './atlas/atlas.ts';
import { readyMaps } from './atlas/ready-view.ts';
import { plotExports, saveButtons, tableExports } from './exports.ts';
import { spawnLab, sweepJob } from './lab-jobs.ts';
import { createMeasuring } from './measuring.ts';
import { createAreas } from './page-areas.ts';
import { answerHead, hardnessHead, hardnessWords, plotSaves } from './plot-headings.ts';
import { provenanceOf } from './provenance.ts';
import { createRayView, hiddenRay } from './ray-view.ts';
import { columnOf } from './reference.ts';
import reference from './reference-prices.json';
import { measureRequest, sweepRequest } from './requests.ts';
import type { Findings } from './result-files.ts';
import '../../ui/dialog.css';
import './accuracy-page.css';

/**
 * The page Accuracy: digits against time on a family's rays, against difficulty, and on one ray.
 */
export const mountAccuracy: MountPage = (host, { dispatch, changed, announce }) => {
  const set = (settings: Partial<AccuracySettings>): void =>
    dispatch({ type: 'settings', values: writeAccuracy(settings) });
  const rayModel = createRayModel();
  const derive = createDerive();
  /** Null while results of this ray are hidden on Explore: every method's row tells the answer. */
  const shownRay = (state: AppState) =>
    state.revealed === null || derive(state).shown.hits ? rayModel(state) : null;
  const rayView = createRayView(dispatch, announce);
  const measuring = createMeasuring(spawnLab, changed);
  const sweeping = sweepJob(spawnLab, changed);
  let picked: Picked | null = null;
  let findings: Findings | null = null;

  const places = createAreas(host);
  const frontier = mountFrontier(places.frontier, (id) => dispatch({ type: 'method', id }));
  const hardness = mountHardness(places.hardness, {
    picked: () => picked,
    pick(next) {
      picked = next;
      changed();
    },
    open: openPicked,
  });

  const atlas = createAtlas(places.atlas, { dispatch, changed, announce, toRay });
  /** The areas that are shown while no map is. */
  const plots = [
    ...[places.head, places.plot, places.bar, places.hardHead, places.hard, places.ready],
  ];
  let isMap = false;

  function toRay(withSteps: boolean): void {
    rayView.open(withSteps);
    places.ray.scrollIntoView();
  }

  const saves = tableExports(() => findings);
  const frontierSaves = plotExports('frontier', places.frontier);
  const hardnessSaves = plotExports('difficulty', places.hardness);

  function pickedSummary() {
    const point = sweeping.result?.find(({ difficulty }) => difficulty === picked?.difficulty);
    return point?.rows.find(({ id }) => id === picked?.id)?.quality ?? null;
  }

  function openPicked(): void {
    const worst = pickedSummary()?.worst;
    if (!worst || !picked) return;
    dispatch({ type: 'link', hash: exploreLink(worst.shape, worst.ray, picked.id) });
  }

  /** Chooses the picked method and its worst ray for the table and "Where did the digits go?". */
  function takePicked(): void {
    const worst = pickedSummary()?.worst;
    if (!worst || !picked) return;
    const { id } = picked;
    dispatch({ type: 'open', state: (now) => withRay(now, worst, id) });
    places.ray.scrollIntoView();
  }

  function sweep(settings: AccuracySettings): void {
    const asked = sweepRequest(settings);
    const { request } = sweeping;
    if (request?.family === asked.family && request.seed === asked.seed) return;
    picked = null;
    sweeping.start(asked);
  }

  function renderAnswer(settings: AccuracySettings, method: string) {
    // Two jobs at once would disturb each other's times.
    const known = measuring.update(settings, !sweeping.running);
    const column = columnOf(settings, known.found, reference);
    const words = answerWords(column, questionOf(settings.worth), settings);
    const data = frontierOf(column, settings, method);
    render(answerHead(settings, column, words, set), places.head);
    if (data) frontier.render(data);
    places.frontier.classList.toggle('is-empty', !data);
    render(data ? nothing : html`<p>${emptyWords(column, known)}</p>`, places.empty);
    render(
      html`${measureBar(
        {
          measured: known.now,
          running: known.running,
          failed: known.failed,
          reference: column.isFaint ? REFERENCE_WORDS : '',
        },
        { measure: measuring.longer, cancel: measuring.cancel },
      )}${plotSaves(frontierSaves)}`,
      places.bar,
    );
    return { column, found: known.found };
  }

  function renderHardness(settings: AccuracySettings, method: string): void {
    render(hardnessHead(settings, set), places.hardHead);
    places.hardness.ariaBusy = String(sweeping.running);
    const dial = findFamily(settings.hard)?.dial;
    if (dial && sweeping.result) {
      const lines = hardnessOf(sweeping.result, dial, settings.worth);
      hardness.render({ ...lines, chosen: method, picked });
    }
    const actions = { open: openPicked, take: takePicked };
    render(
      html`${hardnessWords(settings, picked, pickedSummary(), actions)}${plotSaves(hardnessSaves)}`,
      places.hardWords,
    );
  }

  return {
    render(state) {
      const settings = readAccuracy(state.settings.accuracy).values;
      const ray = shownRay(state);
      isMap = settings.atlas !== '';
      // A map would show the hidden results.
      places.atlas.hidden = !isMap || !ray;
      for (const place of plots) place.hidden = isMap;
      host.classList.toggle('has-map', isMap);
      places.foot.hidden = isMap;
      if (isMap) {
        // A map and a measurement at once would disturb the measured times.
        measuring.rest();
        if (ray) atlas.render(state, settings);
        else atlas.rest();
        render(ray ? rayView.draw(state, ray, null, settings) : hiddenRay(dispatch), places.ray);
        return;
      }
      atlas.rest();
      sweep(settings);
      const { column, found } = renderAnswer(settings, state.method);
      renderHardness(settings, state.method);
      render(readyMaps(set, dispatch), places.ready);
      render(ray ? rayView.draw(state, ray, found, settings) : hiddenRay(dispatch), places.ray);
      const provenance = provenanceOf(
        found,
        measureRequest(settings, false),
        sweepRequest(settings),
      );
      const { columns } = found ?? {};
      findings = { provenance, settings, ray, column, columns, sweep: sweeping.result ?? [] };
      render(
        html`<p class="acc-take">Take home: ${saveButtons(saves, ({ title }) => title)}</p>
          <p class="provenance">${provenance}</p>`,
        places.foot,
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
    exports: () => (isMap ? atlas.exports() : [...saves, ...frontierSaves, ...hardnessSaves]),
    rest() {
      measuring.rest();
      atlas.rest();
    },
  };
};

function withRay(state: AppState, { shape, ray }: Question, method: string): AppState {
  const shapes = { ...state.shapes, [shape.kind]: shape };
  const { origin: E, direction: d } = ray;
  // Hidden results were those of the ray before.
  return { ...state, kind: shape.kind, shapes, E, d, unit: false, method, revealed: null };
}

import { html, nothing, render, type TemplateResult } from 'lit';
import { mountFrontier } from '../charts/frontier.ts';
import { mountHardness, type Picked } from '../charts/hardness.ts';
import { sentenceOf } from '../lab/sentence.ts';
import type { MeasuredRow } from '../lab/session.ts';
import { DIAL_FAMILIES } from '../lab/sweep.ts';
import { FAMILIES, findFamily, type Question } from '../math/families.ts';
import { quote } from '../math/invalid-input.ts';
import { type Choice, tabs } from '../panels/choices.ts';
import { digitSteps } from '../panels/digit-steps.ts';
import { ladderTable } from '../panels/ladder-table.ts';
import { measureBar } from '../panels/measure-bar.ts';
import { nudges } from '../panels/nudges.ts';
import { frontierOf, titleOf } from '../state/accuracy/frontier.ts';
import { hardnessOf } from '../state/accuracy/hardness.ts';
import { createRayModel, type RayModel } from '../state/accuracy/ladder.ts';
import {
  ACCURACY_KEYS,
  type AccuracySettings,
  COSTS,
  readAccuracy,
  WORTHS,
  writeAccuracy,
} from '../state/accuracy/settings.ts';
import type { AppState, Settings } from '../state/state.ts';
import { exploreLink } from '../state/url.ts';
import { display } from '../text/format.ts';
import { download } from '../ui/files.ts';
import { svgPng, svgText } from '../ui/svg-text.ts';
import { type Findings, toCsv, toJson } from './accuracy-exports.ts';
import { measureJob, spawnLab, sweepJob } from './accuracy-jobs.ts';
import { measureRequest, provenanceOf, sameRays, sweepRequest } from './accuracy-plans.ts';
import type { MountPage } from './page.ts';
import type { Takeaway } from './share.ts';
import '../ui/dialog.css';
import '../ui/slider.ts';
import './accuracy.css';

const short = (id: string, title: string): Choice => ({ id, title });
const TIMED: readonly Choice[] = [
  short('typical', 'typical'),
  short('far-origin', 'far away'),
  short('near-tangent', 'near tangent'),
  short('near-surface', 'near surface'),
];
const SWEPT: readonly Choice[] = [
  short('far-origin', 'distance'),
  short('near-tangent', 'tangency'),
  short('near-axis', 'generator angle'),
  short('scale-world', 'scale'),
];
const others = (families: readonly Choice[], shown: readonly Choice[]): readonly Choice[] =>
  families.filter(({ id }) => !shown.some((one) => one.id === id));

/** What accuracy costs in time: this ray, a family's rays against the clock, and how hard rays can get. */
export const mountAccuracy: MountPage = (host, { dispatch, changed }) => {
  const set = (settings: Partial<AccuracySettings>): void =>
    dispatch({ type: 'settings', values: writeAccuracy(settings) });
  const rayModel = createRayModel();
  const measuring = measureJob(spawnLab, changed);
  const sweeping = sweepJob(spawnLab, changed);
  let picked: Picked | null = null;
  let shown: { state: AppState; settings: AccuracySettings; ray: RayModel } | null = null;

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
  const leftHead = area('acc-plot-head', left);
  const leftPlot = area('acc-plot-body', left);
  const leftEmpty = area('acc-plot-empty', left);
  const rightHead = area('acc-plot-head', right);
  const rightPlot = area('acc-plot-body', right);
  const rightFoot = area('acc-plot-foot', right);
  const foot = area('acc-foot');
  const choose = (id: string): void => dispatch({ type: 'method', id });
  const frontier = mountFrontier(leftPlot, choose);
  const hardness = mountHardness(rightPlot, {
    pick(next) {
      picked = next;
      changed();
    },
    open: openPicked,
  });

  function measure(): void {
    if (shown) measuring.start(measureRequest(shown.settings));
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

  const textOf = (write: (found: Findings) => string) => (): string => {
    const found = findings();
    return found ? write(found) : '';
  };
  const saves = [
    {
      id: 'table-csv',
      title: 'table as CSV',
      file: 'graze-accuracy.csv',
      type: 'text/csv',
      text: textOf(toCsv),
    },
    {
      id: 'all-json',
      title: 'everything as JSON',
      file: 'graze-accuracy.json',
      type: 'application/json',
      text: textOf(toJson),
    },
  ] as const;

  function open({ shape, ray }: Question): void {
    if (shown) dispatch({ type: 'link', hash: exploreLink(shape, ray, shown.state.method) });
  }

  function pickedSummary() {
    const point = sweeping.result?.find(({ difficulty }) => difficulty === picked?.difficulty);
    return point?.rows.find(({ id }) => id === picked?.id)?.quality ?? null;
  }

  function openPicked(): void {
    const worst = pickedSummary()?.worst;
    if (worst) open(worst);
  }

  function drawRay(state: AppState, ray: RayModel): TemplateResult {
    const timings = new Map(
      rowsNow().flatMap(({ id, roots }) => (roots ? [[id, roots] as const] : [])),
    );
    const model = { rows: ray.rows, where: ray.where, timings, chosen: state.method };
    return html`<div class="acc-head">
        <h2>This ray</h2>
        <p>${ray.words}</p>
        <button type="button" class="button" @click=${() => dispatch({ type: 'open', state: { ...state, page: 'explore' } })}>Open in Explore</button>
      </div>
      ${ladderTable(model, choose)}
      <div class="acc-more">
        <details>
          <summary>Where did the digits go?</summary>
          ${digitSteps(ray.chosenTitle, ray.losses)}
        </details>
        <details>
          <summary>What does one double more or less change?</summary>
          ${nudges(state, dispatch)}
        </details>
      </div>`;
  }

  const plotTools = (
    name: string,
    plot: HTMLElement,
  ): TemplateResult => html`<span class="acc-save">
    ${plotSaves(name, plot).map(
      ({
        title,
        file,
        type,
        text,
        blob,
      }) => html`<button type="button" class="acc-link" aria-label=${`Save ${title}`}
        @click=${async () => {
          const content = text?.() ?? (await blob?.());
          if (content) download(file, content, type);
        }}>${file.split('.').at(-1)?.toUpperCase()}</button>`,
    )}
  </span>`;

  function drawLeft(settings: AccuracySettings, sentence: string): TemplateResult {
    const dial = findFamily(settings.family)?.dial;
    return html`<div class="acc-title">
        <h2>Digits against time</h2>
        ${tabs('Rays to measure', TIMED, settings.family, (family) => set({ family, dial: null }), others(FAMILIES, TIMED))}
      </div>
      <div class="acc-options">
        ${tabs('Upwards', WORTHS, settings.worth, (worth) => set({ worth: worth as AccuracySettings['worth'] }))}
        ${tabs('Time as', COSTS, settings.cost, (cost) => set({ cost: cost as AccuracySettings['cost'] }))}
        ${plotTools('frontier', leftPlot)}
      </div>
      ${
        dial
          ? html`<label class="acc-dial"><span>${dial.title.replace('^-k', '⁻ᵏ').replace('^k', 'ᵏ')}, k = ${settings.dial === null ? `${dial.usual[0]} … ${dial.usual[1]}` : display(settings.dial, 3)}</span>
            <graze-slider .value=${settings.dial ?? (dial.usual[0] + dial.usual[1]) / 2} .least=${dial.range[0]} .most=${dial.range[1]} .step=${(dial.range[1] - dial.range[0]) / 100} .label=${dial.title}
              @graze-value=${({ detail }: CustomEvent<number>) => set({ dial: detail })}></graze-slider>
            <button type="button" class="acc-link" ?hidden=${settings.dial === null} @click=${() => set({ dial: null })}>as usual</button></label>`
          : nothing
      }
      <p class="acc-sentence" role="status">${sentence}</p>`;
  }

  function drawRight(settings: AccuracySettings): TemplateResult {
    return html`<div class="acc-title">
        <h2>How hard can it get</h2>
        ${tabs('Difficulty', SWEPT, settings.hard, (hard) => set({ hard }), others(DIAL_FAMILIES, SWEPT))}
      </div>
      <div class="acc-options"><p class="acc-idea">${findFamily(settings.hard)?.idea ?? ''}</p>${plotTools('difficulty', rightPlot)}</div>`;
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
      if (before && measuring.running) {
        if (!sameRays(measuring.request, measureRequest(settings))) measuring.cancel();
      }
      render(drawRay(state, ray), top);
      const rows = rowsNow();
      const data = frontierOf({ rows }, settings, state.method);
      render(drawLeft(settings, sentenceOf(rows, titleOf)), leftHead);
      leftPlot.hidden = data === null;
      render(data ? nothing : emptyFrontier(rows, measuring.running, measure), leftEmpty);
      if (data) frontier.render(data);
      render(drawRight(settings), rightHead);
      const dial = findFamily(settings.hard)?.dial;
      if (dial && sweeping.result) {
        hardness.render({
          ...hardnessOf(sweeping.result, dial, settings.worth),
          digitsTitle:
            settings.worth === 'worst'
              ? 'digits right, in the worst ray'
              : 'digits right, in 9 rays of 10',
          chosen: state.method,
          picked,
        });
      }
      render(pickedWords(picked, pickedSummary(), openPicked), rightFoot);
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
          ${saves.map(
            ({ title, file, type, text }) =>
              html`<button type="button" class="acc-link" @click=${() => download(file, text(), type)}>${title}</button>`,
          )}
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
    takeaways: () => [
      ...saves.map(({ id, title, file, type, text }) => ({
        id,
        title,
        file,
        type,
        text,
        blob: null,
      })),
      ...plotSaves('frontier', leftPlot),
      ...plotSaves('difficulty', rightPlot),
    ],
    rest() {
      if (measuring.running) measuring.cancel();
    },
  };
};

/** The settings of the link, with the defaults of what it does not say. */
function settingsOf({ settings }: AppState): AccuracySettings {
  return readAccuracy(settings.accuracy).values;
}

/** A plot as a vector drawing and as pixels, as it stands on the page. */
function plotSaves(name: string, plot: HTMLElement): Takeaway[] {
  const drawn = (): SVGSVGElement | null => plot.querySelector('svg');
  const paper = (): string => getComputedStyle(document.body).getPropertyValue('--bg');
  return [
    {
      id: `${name}-svg`,
      title: `the ${name} plot as SVG`,
      file: `graze-${name}.svg`,
      type: 'image/svg+xml',
      text: () => {
        const svg = drawn();
        return svg ? svgText(svg, paper()) : '';
      },
      blob: null,
    },
    {
      id: `${name}-png`,
      title: `the ${name} plot as PNG`,
      file: `graze-${name}.png`,
      type: 'image/png',
      text: null,
      blob: async () => {
        const svg = drawn();
        return svg ? svgPng(svg, paper()) : null;
      },
    },
  ];
}

function emptyFrontier(
  rows: readonly MeasuredRow[],
  running: boolean,
  measure: () => void,
): TemplateResult {
  const words = running
    ? 'Measuring: the first round is under way.'
    : rows.some(({ roots }) => roots)
      ? 'No ray of this family has a root to have digits: look at the wrong verdicts instead.'
      : 'Not measured yet.';
  return html`<div class="plot-empty">
    <p>${words}</p>
    ${running || rows.length > 0 ? nothing : html`<button type="button" class="button primary" @click=${measure}>Measure</button>`}
  </div>`;
}

function pickedWords(
  picked: Picked | null,
  quality: {
    readonly worst?: Question;
    readonly rays: number;
    readonly wrong: number;
    readonly undecided: number;
    readonly digits: number;
    readonly leastDigits: number;
  } | null,
  open: () => void,
): TemplateResult {
  if (!picked || !quality)
    return html`<p class="acc-hint">Choose a point to see one of its rays.</p>`;
  const { wrong, undecided, rays, digits, leastDigits } = quality;
  return html`<p>
    <b>${titleOf(picked.id)}</b>: ${wrong} of ${rays} verdicts wrong, ${undecided} undecided; digits ${display(digits, 3)} in 9 rays of 10, ${display(leastDigits, 3)} in the worst.
    ${quality.worst ? html`<button type="button" class="acc-link" @click=${open}>Open its worst ray in Explore</button>` : nothing}
  </p>`;
}

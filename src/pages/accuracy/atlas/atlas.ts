import { html, nothing, render, type TemplateResult } from 'lit';
import { mountFailureMap } from '../../../charts/failure-map.ts';
import type { Cell, Corners, Gestures } from '../../../charts/map-gestures.ts';
import { numberOn } from '../../../lab/atlas/axes.ts';
import { bordersOf } from '../../../lab/atlas/borders.ts';
import type { MapFrame } from '../../../lab/atlas/frame.ts';
import type { MapRequest } from '../../../lab/atlas/request.ts';
import { atAfterZoom, clampZoom, MIDDLE, SIDE, scaleOf } from '../../../lab/atlas/window.ts';
import type { Question } from '../../../math/families.ts';
import { unitVector } from '../../../math/shapes.ts';
import { type Atlas, type AtlasMap, atlasOf, withPixel } from '../../../state/accuracy/atlas.ts';
import {
  axisWords,
  confirmedWords,
  mapDescription,
  mapSentence,
  numbersAt,
  pixelSize,
  placeWords,
  questionAt,
  saidAt,
} from '../../../state/accuracy/atlas-words.ts';
import {
  type AccuracySettings,
  readAccuracy,
  writeAccuracy,
} from '../../../state/accuracy/settings.ts';
import type { Dispatch } from '../../../state/actions.ts';
import type { AppState, Settings } from '../../../state/state.ts';
import { shortest } from '../../../text/format.ts';
import type { Announce } from '../../../ui/announcer.ts';
import type { ExportItem } from '../../export-dialog.ts';
import { saveButtons } from '../exports.ts';
import { spawnLab } from '../lab-jobs.ts';
import { atlasControls, zoomWords } from './atlas-controls.ts';
import { atlasExports, type ShownMap } from './atlas-exports.ts';
import { legend, paintSamples } from './legend.ts';
import { type MapState, mapJobs } from './map-jobs.ts';
import { ownMapJobs, tryProgram } from './own-map.ts';
import { type Picked, pickedCard } from './picked-card.ts';
import './atlas.css';

interface Context {
  readonly dispatch: Dispatch;
  readonly changed: () => void;
  readonly announce: Announce;
  /** Shows the table of this ray, with the steps of the chosen method open if asked for. */
  readonly toRay: (withSteps: boolean) => void;
}

/** Elements and jobs of one of the two maps. */
interface MapSlot {
  readonly host: HTMLElement;
  readonly head: HTMLElement;
  readonly foot: HTMLElement;
  readonly view: ReturnType<typeof mountFailureMap>;
  readonly jobs: ReturnType<typeof mapJobs>;
  readonly own: ReturnType<typeof ownMapJobs>;
}

/** The failure atlas: one or two maps of one window, with controls, legend and exports. */
export function createAtlas(place: HTMLElement, { dispatch, changed, announce, toRay }: Context) {
  const area = (name: string, parent: HTMLElement = place): HTMLElement => {
    const element = document.createElement('div');
    element.className = name;
    parent.append(element);
    return element;
  };
  place.classList.add('atlas');
  const head = area('atlas-head');
  const body = area('atlas-body');
  const mapsArea = area('atlas-maps', body);
  const side = area('atlas-side', body);
  const sandbox = area('atlas-sandbox');
  const cores = navigator.hardwareConcurrency || 2;
  let state: AppState | null = null;
  let cursor: Cell | null = null;
  let picked: { readonly map: number; readonly cell: Cell; readonly key: string } | null = null;
  let corners: { readonly cells: Corners; readonly key: string } | null = null;
  let isMarking = false;
  let isLeaving = false;
  /** What the student's program said of a chosen ray. */
  let tried: { readonly key: string; readonly words: string } | null = null;
  let shown: readonly ShownMap[] = [];
  const slots = [createSlot(0), createSlot(1)];
  window.addEventListener('beforeprint', () => paintSamples(side, isLeaving, '#000000'));
  window.addEventListener('afterprint', changed);

  function createSlot(index: number): MapSlot {
    const host = area('atlas-map', mapsArea);
    const top = area('atlas-map-head', host);
    const field = area('atlas-field', host);
    const bottom = area('atlas-map-foot', host);
    return {
      host,
      head: top,
      foot: bottom,
      view: mountFailureMap(field, gesturesOf(index)),
      jobs: mapJobs(spawnLab, changed, cores),
      own: ownMapJobs(sandbox, (heard) => mapJobs(spawnLab, heard, cores), changed),
    };
  }

  const set = (values: Partial<AccuracySettings>): void =>
    dispatch({ type: 'settings', values: writeAccuracy(values) });

  /** An edit of the window as it is when the action arrives. */
  function move(edit: (request: MapRequest) => Partial<Pick<MapRequest, 'zoom' | 'at'>>): void {
    const before = state;
    if (!before) return;
    dispatch({
      type: 'settings',
      values: (now: Settings) => {
        const settings = { ...before.settings, accuracy: now };
        const [first] = atlasOf({ ...before, settings }, readAccuracy(now).values).maps;
        if (!first) return {};
        const { zoom, at: middle } = edit(first.request);
        const isMoved = middle?.some((x, i) => !Object.is(x, first.request.at[i]));
        const at = isMoved ? middle : undefined;
        return writeAccuracy({
          ...(zoom !== undefined && { zoom }),
          ...(at && { at: at.map(shortest).join(',') }),
        });
      },
    });
  }

  function zoomBy(decades: number, [column, row]: Cell): void {
    move(({ measure, zoom, at }) => {
      const next = clampZoom(measure, zoom + decades);
      announce(zoomWords(next), 'zoom');
      const both = [zoom, next] as const;
      return {
        zoom: next,
        at: [atAfterZoom(measure, at[0], both, column), atAfterZoom(measure, at[1], both, row)],
      };
    });
  }

  function gesturesOf(index: number): Gestures {
    return {
      point(cell) {
        if (cell?.[0] === cursor?.[0] && cell?.[1] === cursor?.[1]) return;
        cursor = cell;
        if (cell) announce(() => wordsAt(index, cell), 'pixel');
        changed();
      },
      pick(cell) {
        const one = shown[index];
        if (!one) return;
        picked = { map: index, cell, key: windowKey(one.map.request) };
        cursor = cell;
        announce(() => `Chosen: ${wordsAt(index, cell)}`, 'pixel');
        changed();
      },
      zoom: zoomBy,
      pan(columns, rows) {
        move(({ measure, zoom, at }) => ({
          at: [
            scaleOf(measure, zoom, at[0]).numberAt(MIDDLE + columns),
            scaleOf(measure, zoom, at[1]).numberAt(MIDDLE + rows),
          ],
        }));
      },
      mark(cells) {
        const one = shown[index];
        corners = cells && one ? { cells, key: windowKey(one.map.request) } : null;
        changed();
      },
      home: () => set({ at: '' }),
      cursor: () => cursor,
      marks: () => isMarking,
    };
  }

  function wordsAt(index: number, [column, row]: Cell): string {
    const one = shown[index];
    if (!one?.frame) return '';
    const { map, frame } = one;
    return (
      `${numbersAt(map.request, column, row)}: ` +
      `${saidAt(map.title, map.request, frame, row * SIDE + column)}.`
    );
  }

  function drawMap(
    slot: MapSlot,
    map: AtlasMap | undefined,
    atlas: Atlas,
    index: number,
  ): ShownMap | null {
    slot.host.hidden = !map;
    if (!map) {
      slot.jobs.rest();
      slot.own.rest();
      return null;
    }
    const jobs = map.isOwn ? slot.own : slot.jobs;
    jobs.show(map.request);
    const now = jobs.state();
    const frame = now.frame;
    const request = now.shown ?? map.request;
    const isThis = now.shown !== null && windowKey(now.shown) === windowKey(map.request);
    const borders =
      frame && now.summary && isThis && !request.start ? bordersFor(slot, request, now) : [];
    const key = windowKey(map.request);
    const [x, y] = [0, 1].map((which) => {
      const { measure, zoom, at } = map.request;
      return scaleOf(measure, zoom, at[which as 0 | 1]).pixelOf(presentOf(atlas, which as 0 | 1));
    }) as [number, number];
    const isInside = [x, y].every((pixel) => pixel >= 0 && pixel < SIDE);
    const { title } = map;
    render(mapHead(title, now), slot.head);
    slot.view.render({
      label:
        `Map of ${title}. Arrows move the pointer, with Shift the window; plus and minus zoom; ` +
        'Enter chooses the pixel; R begins and ends a rectangle; 0 goes back to the ray.',
      description: mapDescription(title, map.request, atlas.axes, now.summary, now.probe),
      frame,
      borders,
      cursor,
      picked: picked && picked.map === index && picked.key === key ? picked.cell : null,
      here: isInside ? [x, y] : null,
      corners: corners?.key === key ? corners.cells : null,
      busy: now.running,
    });
    render(mapFoot(map, atlas, now, jobs), slot.foot);
    return { map, frame: isThis ? frame : null, borders, summary: now.summary, probe: now.probe };
  }

  const known = new WeakMap<
    MapSlot,
    { readonly frame: unknown; readonly borders: ReturnType<typeof bordersOf> }
  >();
  function bordersFor(slot: MapSlot, request: MapRequest, { frame }: MapState) {
    const before = known.get(slot);
    if (before?.frame === frame) return before.borders;
    const borders = frame ? bordersOf(request.shape, frame) : [];
    known.set(slot, { frame, borders });
    return borders;
  }

  function pickedNow(): Picked | null {
    const one = picked && shown[picked.map];
    if (!picked || !one?.frame || picked.key !== windowKey(one.map.request)) return null;
    const [column, row] = picked.cell;
    const at = questionAt(one.map.request, column, row);
    return { map: one.map, words: wordsAt(picked.map, picked.cell), at };
  }

  const exports = (): readonly ExportItem[] =>
    atlasExports(
      () => shown,
      () => corners?.cells ?? null,
    );

  return {
    /** Draws the maps that the settings call for. */
    render(now: AppState, settings: AccuracySettings): void {
      state = now;
      const atlas = atlasOf(now, settings);
      render(atlasControls(atlas, settings, { set, zoomBy, home: () => set({ at: '' }) }), head);
      shown = slots.flatMap((slot, i) => drawMap(slot, atlas.maps[i], atlas, i) ?? []);
      mapsArea.classList.toggle('has-two', atlas.maps.length > 1);
      render(sideOf(atlas, settings), side);
      isLeaving = atlas.maps[0]?.request.start !== undefined;
      paintSamples(side, isLeaving, getComputedStyle(side).color);
    },
    exports,
    rest(): void {
      for (const slot of slots) {
        slot.jobs.rest();
        slot.own.rest();
      }
    },
  };

  function sideOf(atlas: Atlas, settings: AccuracySettings): TemplateResult {
    const pointed = cursor && shown[0] ? numbersAt(shown[0].map.request, cursor[0], cursor[1]) : '';
    const [first] = atlas.maps;
    const card = pickedNow();
    const confirmed = [...new Set(shown.map(({ probe }) => confirmedWords(probe)))].join(' ');
    return html`<div class="atlas-pointed">
        <h3>Pointed at</h3>
        ${
          cursor && pointed
            ? html`<p class="atlas-numbers">${pointed}</p>
              ${shown.map(
                ({ map, frame }) =>
                  html`<p>${frame && cursor ? pointedAt(map, frame, cursor) : nothing}</p>`,
              )}`
            : html`<p class="acc-hint">Each pixel is a ray; a click chooses it. ${
                first
                  ? html`A pixel is ${pixelSize(first.request, 0)} of ${atlas.axes[0].id} wide and
                    ${pixelSize(first.request, 1)} of ${atlas.axes[1].id} high.`
                  : nothing
              }</p>`
        }
      </div>
      ${pickedCard(card, {
        take: (card, withSteps) => {
          const { at, map } = card;
          if (!at) return;
          dispatch({ type: 'open', state: (now) => withPixel(now, map, at, withSteps) });
          toRay(withSteps);
        },
        explore: (card) => {
          const { at, map } = card;
          if (!at) return;
          dispatch({
            type: 'open',
            state: (now) => ({ ...withPixel(now, map, at, true), page: 'explore', problems: [] }),
          });
        },
        tryProgram: (card) => {
          if (!card.at) return;
          const key = card.words;
          void tryProgram(sandbox, inUnits(card), (words) => {
            tried = { key, words };
            changed();
          });
        },
        tried: tried?.key === card?.words ? (tried?.words ?? '') : '',
      })}
      <div class="atlas-rectangle">
        <button type="button" class="button" aria-pressed=${isMarking}
          @click=${() => {
            isMarking = !isMarking;
            if (!isMarking) corners = null;
            changed();
          }}>Mark a rectangle</button>
        ${isMarking || corners ? html`<p class="acc-hint">${rectangleWords()}</p>` : nothing}
      </div>
      ${legend(shown, first?.request.start !== undefined)}
      <p class="provenance">${confirmed}</p>
      <p class="acc-take">Take home: ${saveButtons(exports(), ({ title }) => title)}</p>
      <button type="button" class="button atlas-close" @click=${() =>
        set({ atlas: '', zoom: 0, by: 'lengths', at: '', maps: '', start: '' })}
        ?hidden=${settings.atlas === ''}>Close the map</button>`;
  }

  function rectangleWords(): string {
    if (!corners) return 'Drag over the map: its rays become test cases, the failing ones first.';
    const [a, b] = corners.cells;
    const [width, height] = [Math.abs(a[0] - b[0]) + 1, Math.abs(a[1] - b[1]) + 1];
    return `${width} by ${height} pixels: saved as test cases below, the failing ones first.`;
  }
}

function pointedAt(
  { title, request }: AtlasMap,
  frame: MapFrame,
  [column, row]: Cell,
): TemplateResult {
  return html`<b>${title}</b>: ${saidAt(title, request, frame, row * SIDE + column)}`;
}

/** The chosen ray as the kernel gets it. */
function inUnits({ map: { request }, at }: Picked): Question {
  const { shape, ray } = at as Question;
  if (!request.unit) return { shape, ray };
  return { shape, ray: { origin: ray.origin, direction: unitVector(ray.direction) } };
}

/** The number that the present ray has on an axis. */
function presentOf({ maps, axes }: Atlas, which: 0 | 1): number {
  const [first] = maps;
  if (!first) return Number.NaN;
  const { shape, ray } = first.request;
  return numberOn(axes[which], { shape, ray });
}

function mapHead(title: string, { summary, probe, request, running }: MapState): TemplateResult {
  const words = summary
    ? mapSentence(title, summary, probe, request?.start !== undefined)
    : `${title}: ${running ? 'being drawn …' : 'not drawn'}`;
  return html`<h2 class="atlas-sentence"><span data-say>${words}</span></h2>`;
}

function mapFoot(
  { request }: AtlasMap,
  { axes }: Atlas,
  { running, share, failed, summary, frame }: MapState,
  jobs: { cancel(): void; again(): void },
): TemplateResult {
  const stopped = !running && !summary && frame;
  const places = summary ? placeWords(summary, request.start !== undefined) : '';
  return html`<p class="atlas-axes">
      <span>→ ${axisWords(axes[0], request, 0)}</span>
      <span>↑ ${axisWords(axes[1], request, 1)}</span>
    </p>
    <div class="atlas-progress">
      ${
        running
          ? html`<progress class="measure-progress" max="1" .value=${share}
              aria-label="Drawing the map"></progress>
            <button type="button" class="acc-link" @click=${jobs.cancel}>Cancel</button>`
          : failed || stopped
            ? html`<p data-say>${failed || `Stopped at ${Math.round(100 * share)} %.`}</p>
              <button type="button" class="acc-link" @click=${jobs.again}>Draw it again</button>`
            : html`<p class="acc-hint">${places}</p>`
      }
    </div>`;
}

/** A text that is equal for equal windows. */
const windowKey = ({ axes, measure, zoom, at, shape, ray, unit }: MapRequest): string =>
  JSON.stringify([axes, measure, zoom, at.map(shortest), shape, ray, unit]);

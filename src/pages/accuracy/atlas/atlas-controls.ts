import { html, nothing, type TemplateResult } from 'lit';
import { live } from 'lit/directives/live.js';
import type { Cell } from '../../../charts/map-gestures.ts';
import type { MapAxis } from '../../../lab/atlas/axes.ts';
import { clampZoom, MEASURES, type Measure, MIDDLE, ZOOMS } from '../../../lab/atlas/window.ts';
import { type Choice, tabs } from '../../../panels/choices.ts';
import { type Atlas, MAP_CHOICES } from '../../../state/accuracy/atlas.ts';
import type { AccuracySettings } from '../../../state/accuracy/settings.ts';
import { readStartRule, START_TEXTS, startWords } from '../../../state/picture/start-rule.ts';
import { display } from '../../../text/format.ts';

interface Actions {
  readonly set: (values: Partial<AccuracySettings>) => void;
  readonly zoomBy: (decades: number, about: Cell) => void;
  readonly home: () => void;
}

const CENTRE: Cell = [MIDDLE, MIDDLE];
const NONE = 'none of its own';

/** Which numbers are the axes, how far is zoomed in, and whose maps are shown. */
export function atlasControls(
  atlas: Atlas,
  settings: AccuracySettings,
  { set, zoomBy, home }: Actions,
): TemplateResult {
  const [x, y] = atlas.axes;
  const [first] = atlas.maps;
  const axis = (
    label: string,
    sign: string,
    [chosen, other]: readonly [MapAxis, MapAxis],
    write: (id: string) => string,
  ): TemplateResult =>
    select(
      label,
      atlas.choices.filter(({ id }) => id !== other.id).map(({ id }) => ({ id, title: id })),
      chosen.id,
      (id) => set({ atlas: write(id), at: '' }),
      sign,
    );
  return html`<div class="atlas-row">
      ${axis('To the right', '→', [x, y], (id) => `${id},${y.id}`)}
      ${axis('Upwards', '↑', [y, x], (id) => `${x.id},${id}`)}
      ${tabs('Window in', MEASURES, settings.by, (by) => set(measuredIn(settings, by as Measure)))}
      <span class="atlas-zoom" role="group" aria-label="Zoom">
        <button type="button" class="button" aria-label="Zoom out by a decade"
          @click=${() => zoomBy(-1, CENTRE)}>−</button>
        <span class="atlas-zoomed">${zoomWords(first?.request.zoom ?? 0)}</span>
        <button type="button" class="button" aria-label="Zoom in by a decade"
          @click=${() => zoomBy(1, CENTRE)}>+</button>
      </span>
      <button type="button" class="button" ?disabled=${isFinest(settings)}
        @click=${() => set({ by: 'ulps', zoom: ZOOMS.ulps[1] })}>Down to doubles</button>
      <button type="button" class="button" ?disabled=${settings.at === ''}
        @click=${home}>To the ray</button>
    </div>
    <div class="atlas-row">
      ${whose(atlas, settings, set)}
    </div>
    ${atlas.problem ? html`<p data-say="problem">${atlas.problem}</p>` : nothing}`;
}

export const zoomWords = (zoom: number): string => `zoom ${display(zoom, 4)}`;

const isFinest = ({ by, zoom }: AccuracySettings): boolean =>
  by === 'ulps' && zoom >= ZOOMS.ulps[1];

/** Another measure has other limits; the zoom stays where both have it. */
const measuredIn = ({ zoom }: AccuracySettings, by: Measure): Partial<AccuracySettings> => ({
  by,
  zoom: clampZoom(by, zoom),
});

/** Controls for the method of each map, and for the question that the maps answer. */
function whose({ maps }: Atlas, settings: AccuracySettings, set: Actions['set']): TemplateResult {
  const ids = maps.map(({ isOwn, request }) => (isOwn ? 'own' : request.method));
  const starts = settings.start === '' ? [] : settings.start.split(',');
  const isTwo = maps.length > 1;
  const [left = 'textbook', right = left] = ids;
  const put = (methods: readonly string[], rules: readonly string[]): void =>
    set({ maps: methods.join(','), start: rules.join(',') });
  const rulesFor = (count: number): string[] =>
    starts.length === 0
      ? []
      : Array.from({ length: count }, (_, i) => starts[i] ?? starts[0] ?? 'from');
  const rule = (i: 0 | 1): TemplateResult => {
    const now = rulesFor(2);
    return select(
      i === 0 ? 'Where its rays start' : 'Where the other’s start',
      RULES,
      now[i] ?? 'from',
      (id) => {
        now[i] = id;
        put(isTwo ? [left, right] : [left], isTwo ? now : now.slice(0, 1));
      },
    );
  };
  const second = [{ id: NONE, title: 'no second map' }, ...MAP_CHOICES];
  return html`${select('Map of', MAP_CHOICES, left, (id) =>
    put(isTwo ? [id, right] : [id], rulesFor(isTwo ? 2 : 1)),
  )}
    ${select('Beside it', second, isTwo ? right : NONE, (id) =>
      id === NONE ? put([left], rulesFor(1)) : put([left, id], rulesFor(2)),
    )}
    ${select('Asks about', ASKED, starts.length > 0 ? 'leaving' : 'ray', (id) =>
      set({ start: id === 'ray' ? '' : isTwo ? 'none,from' : 'none' }),
    )}
    ${starts.length > 0 ? html`${rule(0)}${isTwo ? rule(1) : nothing}` : nothing}`;
}

const ASKED: readonly Choice[] = [
  { id: 'ray', title: 'the ray' },
  { id: 'leaving', title: 'the ray that leaves its hit' },
];
const RULES: readonly Choice[] = START_TEXTS.map((id) => ({
  id,
  title: startWords(readStartRule(id)),
}));

function select(
  label: string,
  choices: readonly Choice[],
  chosen: string,
  choose: (id: string) => void,
  sign = label,
): TemplateResult {
  const all = choices.some(({ id }) => id === chosen)
    ? choices
    : [...choices, { id: chosen, title: chosen }];
  return html`<label class="atlas-choice"><span aria-hidden="true">${sign}</span>
    <select aria-label=${label}
      @change=${(event: Event) => choose((event.target as HTMLSelectElement).value)}>
      ${all.map(
        ({ id, title }) =>
          html`<option value=${id} .selected=${live(id === chosen)}>${title}</option>`,
      )}
    </select></label>`;
}

import { axesOf, type MapAxis, numberOn } from '../../lab/atlas/axes.ts';
import type { MapRequest } from '../../lab/atlas/request.ts';
import { clampZoom } from '../../lab/atlas/window.ts';
import { METHODS } from '../../math/index.ts';
import { findMethod, quote } from '../../math/shapes.ts';
import { shortest } from '../../text/format.ts';
import { readStartRule, startWords } from '../picture/start-rule.ts';
import { type AppState, shapeOf } from '../state.ts';
import { type AccuracySettings, numbersIn, OWN } from './settings.ts';

/** A map of the window: what it asks, and by whom. */
export interface AtlasMap {
  /** Of a student's program `method` is 'certified', which gives the truth. */
  readonly request: MapRequest;
  readonly isOwn: boolean;
  /** Who says what is shown: textbook; your program; certified with no start rule. */
  readonly title: string;
}

/** One window, and one or two maps of it. */
export interface Atlas {
  readonly maps: readonly AtlasMap[];
  readonly axes: readonly [MapAxis, MapAxis];
  /** Every number that can be an axis. */
  readonly choices: readonly MapAxis[];
  /** A sentence on settings that could not be used; '' if all could. */
  readonly problem: string;
}

/** The axes that a map has before any are chosen. */
export const FIRST_AXES = 'E.z,E.y';

/** The maps that the settings call for. */
export function atlasOf(state: AppState, settings: AccuracySettings): Atlas {
  const shape = shapeOf(state);
  const choices = axesOf(shape);
  const { axes, problem } = axesIn(settings.atlas, choices);
  const ray = { origin: state.E, direction: state.d };
  const present = [numberOn(axes[0], { shape, ray }), numberOn(axes[1], { shape, ray })] as const;
  const given = numbersIn(settings.at);
  const at = [given[0] ?? present[0], given[1] ?? present[1]] as const;
  const methods = listed(settings.maps, state.method);
  const starts = settings.start === '' ? [] : settings.start.split(',').map(readStartRule);
  const count = Math.max(methods.length, starts.length);
  const maps = Array.from({ length: count }, (_, i): AtlasMap => {
    const method = methods[i] ?? methods[0] ?? state.method;
    const start = starts[i] ?? starts[0];
    const isOwn = method === OWN;
    const who = isOwn ? 'your program' : (findMethod(method)?.title ?? method);
    return {
      request: {
        shape,
        ray,
        unit: state.unit,
        axes: [axes[0].id, axes[1].id],
        measure: settings.by,
        zoom: clampZoom(settings.by, settings.zoom),
        at,
        method: isOwn ? 'certified' : method,
        // A start rule is a setting of Graze's methods: a student's program has none.
        ...(start && !isOwn && { start }),
      },
      isOwn,
      title: start && !isOwn ? `${who} with ${startWords(start)}` : who,
    };
  });
  return { maps, axes, choices, problem };
}

const listed = (text: string, otherwise: string): readonly string[] =>
  text === '' ? [otherwise] : text.split(',');

function axesIn(text: string, choices: readonly MapAxis[]): Pick<Atlas, 'axes' | 'problem'> {
  const wanted = (text || FIRST_AXES).split(',');
  const find = (id: string | undefined): MapAxis | undefined =>
    choices.find((axis) => axis.id === id);
  const missing = wanted.filter((id) => !find(id));
  const usual = FIRST_AXES.split(',').map(find);
  const first = find(wanted[0]) ?? usual.find((axis) => axis?.id !== wanted[1]);
  const second = find(wanted[1]) ?? usual.find((axis) => axis?.id !== first?.id);
  if (!first || !second) throw new RangeError('every shape is met by a ray with E.y and E.z');
  const names = missing.map(quote).join(' and ');
  const problem =
    missing.length === 0
      ? ''
      : `${names} ${missing.length === 1 ? 'is no number' : 'are no numbers'} of this shape: ` +
        `the axes are ${first.id} and ${second.id}.`;
  return { axes: [first, second], problem };
}

/** The choices for a map: every method, and the student's program. */
export const MAP_CHOICES = [
  ...METHODS.map(({ id, title }) => ({ id: id as string, title })),
  { id: OWN, title: 'your program' },
];

/**
 * The state with the ray and the shape of a pixel; the window stays where it is.
 *
 * @param withMethod whether the map's method becomes the chosen one; then other maps keep theirs.
 */
export function withPixel(
  state: AppState,
  { request, isOwn }: AtlasMap,
  { shape, ray }: PixelNumbers,
  withMethod: boolean,
): AppState {
  const { accuracy } = state.settings;
  const maps = accuracy.maps ?? state.method;
  const kept = { at: request.at.map(shortest).join(','), ...(withMethod && { maps }) };
  return {
    ...state,
    shapes: { ...state.shapes, [shape.kind]: shape },
    E: ray.origin,
    d: ray.direction,
    // Hidden results were those of the ray before.
    revealed: null,
    ...(withMethod && !isOwn && { method: request.method }),
    settings: { ...state.settings, accuracy: { ...accuracy, ...kept } },
  };
}

type PixelNumbers = Pick<MapRequest, 'shape' | 'ray'>;

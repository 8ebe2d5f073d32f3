import { walkLength } from '../math/formula.ts';
import { type Ray, SHAPES, type Shape, type Vec3 } from '../math/index.ts';
import { DEFAULT_METHOD, type Param, type ShapeKind, unitVector } from '../math/shapes.ts';
import type { View } from './camera-view.ts';
import type { LinkTheme, Part } from './embed.ts';
import type { Between } from './heights.ts';
import type { Ask } from './prediction-ask.ts';

export interface PageEntry {
  readonly id: string;
  readonly title: string;
  /** Whether the page uses the ray and shape of Explore, so that its link carries them. */
  readonly ray: boolean;
  /** Key of the setting that is written in the path of its link, after the page's id. */
  readonly part?: string;
}

export const PAGES = [
  { id: 'explore', title: 'Explore', ray: true },
  { id: 'lesson', title: 'Lessons', ray: false, part: 'id' },
  { id: 'accuracy', title: 'Accuracy', ray: true },
  { id: 'picture', title: 'Picture', ray: false },
  { id: 'check', title: 'Check', ray: true },
] as const satisfies readonly PageEntry[];
export type PageId = (typeof PAGES)[number]['id'];

/**
 * The settings of a page in its link, besides ray and method: a text for each key. Only the page's
 * own code, which is loaded late, reads them. Keys are words, since single letters are parameters.
 */
export type Settings = Readonly<Record<string, string>>;

/**
 * Everything that a page shows follows from this. A link carries all of it except the shapes that
 * are not shown and their typed texts, which only a file has; `problems`, `example` and `ghost`,
 * which last while the page is open; and `told` and the number in `revealed`, which a reload keeps.
 */
export interface AppState {
  readonly page: PageId;
  readonly kind: ShapeKind;
  /** The parameters of every shape, which stay while another shape is shown. */
  readonly shapes: Readonly<Record<ShapeKind, Shape>>;
  readonly E: Vec3;
  /** The direction as entered; with `unit` the kernel gets d / |d| instead. */
  readonly d: Vec3;
  readonly unit: boolean;
  /** Typed texts of numbers of E, d and the shapes that are not the double's shortest text. */
  readonly typed: Readonly<Record<string, string>>;
  readonly method: string;
  readonly view: View;
  /** t of the bead; null for its resting place, `restingBead`. */
  readonly bead: number | null;
  /** Heights between which a curved shape is kept; null for all of it. A flat one is whole. */
  readonly between: Between | null;
  /** Whether discs close the shape at these heights; false without heights. */
  readonly caps: boolean;
  /** The settings of each page as it was left. */
  readonly settings: Readonly<Record<PageId, Settings>>;
  /** Messages on what was wrong with the link or file that was opened. */
  readonly problems: readonly string[];
  /** Id of the example that was opened last, also after changes: see example.ts. */
  readonly example: string | null;
  /** How many lines of the result are shown, for predicting first; null shows everything. */
  readonly revealed: number | null;
  /** The question that is asked while lines are hidden; null for the page's default. */
  readonly ask: Ask | null;
  /** Whether the answer to the example's question is shown. */
  readonly told: boolean;
  /** The step of the derivation that is open beside the scene, from 1; null while it is closed. */
  readonly derive: number | null;
  /** A ray and its shape that were kept to compare with. */
  readonly ghost: Ghost | null;
  /** The parts of Explore that are shown in a host's page; null shows Graze as a whole. */
  readonly embed: readonly Part[] | null;
  /** Symbols whose values stay as the link gave them. */
  readonly lock: readonly string[];
  /** The theme that the link asks for. */
  readonly theme: LinkTheme | null;
}

export interface Ghost {
  readonly shape: Shape;
  readonly ray: Ray;
}

/** Parameter entries for E and d, like those that shapes declare. */
export const RAY_PARAMS = {
  E: {
    type: 'vector',
    key: 'origin',
    symbol: 'E',
    title: 'eye, where the ray starts',
    initial: [2.5, 3, 2],
    linkDefault: [3, 1, 1],
    range: [-5, 5],
    step: 0.1,
  },
  d: {
    type: 'vector',
    key: 'direction',
    symbol: 'd',
    title: 'direction',
    initial: [-2, -1, -1],
    linkDefault: [-0.8, -0.2, -0.3],
    range: [-2, 2],
    step: 0.05,
    nonZero: true,
  },
} as const satisfies Record<string, Param>;

export function initialShape(kind: ShapeKind): Shape {
  const definition = SHAPES.find((shape) => shape.kind === kind);
  const params = (definition?.params ?? []).map(({ key, initial }) => [key, initial] as const);
  return { kind, ...Object.fromEntries(params) } as unknown as Shape;
}

/**
 * The state of an empty address: a ray and shapes whose coefficients, roots and points are short
 * decimals. A number that a link leaves out is the parameter's `linkDefault`, which never changes.
 */
export const INITIAL: AppState = {
  page: 'explore',
  kind: 'cone',
  shapes: Object.fromEntries(
    SHAPES.map(({ kind }) => [kind, initialShape(kind)]),
  ) as AppState['shapes'],
  E: RAY_PARAMS.E.initial,
  d: RAY_PARAMS.d.initial,
  unit: false,
  typed: {},
  method: DEFAULT_METHOD,
  view: 'iso',
  bead: null,
  between: null,
  caps: false,
  settings: Object.fromEntries(PAGES.map(({ id }) => [id, {}])) as unknown as AppState['settings'],
  problems: [],
  example: null,
  revealed: null,
  ask: null,
  told: false,
  derive: null,
  ghost: null,
  embed: null,
  lock: [],
  theme: null,
};

/** The shape that is shown. */
export function shapeOf(state: Pick<AppState, 'kind' | 'shapes'>): Shape {
  return state.shapes[state.kind];
}

/** The step of the derivation that is shown; null while it is closed. */
export const stepShown = (state: Pick<AppState, 'kind' | 'shapes' | 'derive'>): number | null =>
  state.derive && Math.min(state.derive, walkLength(shapeOf(state)));

/** The ray that the kernel gets. */
export function rayOf({ E, d, unit }: AppState): Ray {
  return { origin: E, direction: unit ? unitVector(d) : d };
}

/** The value of one of a shape's parameters. */
export function paramValue(shape: Shape, key: string): Vec3 | number | string {
  return (shape as unknown as Readonly<Record<string, Vec3 | number | string>>)[key] ?? 0;
}

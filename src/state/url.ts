import { walkLength } from '../math/formula.ts';
import { InvalidInput, type Shape, type Vec3 } from '../math/index.ts';
import {
  checkParam,
  DEFAULT_METHOD,
  findMethod,
  findShape,
  knownAs,
  type Param,
  quote,
  type ShapeKind,
} from '../math/shapes.ts';
import { parseNumber } from '../text/parse.ts';
import type { ParamValue } from './actions.ts';
import { isView, type View } from './camera-view.ts';
import { LINK_THEMES, type LinkTheme, listOf, PARTS, type Part } from './embed.ts';
import type { Between } from './heights.ts';
import { type Ask, isAsk } from './prediction-ask.ts';
import {
  type AppState,
  INITIAL,
  initialShape,
  PAGES,
  type PageEntry,
  type PageId,
  paramValue,
  RAY_PARAMS,
  type Settings,
  shapeOf,
  stepShown,
} from './state.ts';
import {
  linkedTexts,
  linkNumber,
  rayPlaces,
  shapePlaces,
  type TypedNumberSlot,
} from './typed-texts.ts';

/** Writes and reads the text of one key. `read` throws InvalidInput that quotes the text. */
interface Codec<V> {
  write(value: V): string;
  read(text: string): V;
}

const number: Codec<number> = {
  write: linkNumber,
  read(text) {
    const parsed = parseNumber(text);
    if (!parsed.ok) throw new InvalidInput(parsed.reason);
    return parsed.value;
  },
};

const vector: Codec<Vec3> = {
  write: (v) => v.map(number.write).join(','),
  read(text) {
    const parts = text.split(',').map(number.read);
    const [x, y, z] = parts;
    if (parts.length !== 3 || x === undefined || y === undefined || z === undefined) {
      throw new InvalidInput(`${quote(text)} is not three numbers`);
    }
    return [x, y, z];
  },
};

const heights: Codec<Between> = {
  write: (all) => all.map(number.write).join(','),
  read(text) {
    const [low, high, ...more] = text.split(',').map(number.read);
    if (low === undefined || high === undefined || more.length > 0 || !(low < high)) {
      throw new InvalidInput(`${quote(text)} is not two heights, the lower one first`);
    }
    return [low, high];
  },
};

const word: Codec<string> = { write: (text) => text, read: (text) => text };

const view: Codec<View> = {
  write: (v) =>
    typeof v === 'string'
      ? v
      : [v.azimuth, v.elevation, ...(v.zoom === null ? [] : [v.zoom])].map(number.write).join(','),
  read(text) {
    if (isView(text as View)) return text as View;
    try {
      const [azimuth = 0, elevation, zoom = null, ...more] = text.split(',').map(number.read);
      const given = { azimuth, elevation, zoom } as View;
      if (elevation !== undefined && more.length === 0 && isView(given)) return given;
    } catch {
      // The message below quotes the whole text.
    }
    throw new InvalidInput(`${quote(text)} is not a view`);
  },
};

export const viewText = view.write;

/** The value of a parameter that a link leaves out. */
function unsaid(param: Param): ParamValue {
  return param.linkDefault ?? param.initial;
}

function codecOf(param: Param): Codec<ParamValue> {
  const codec = param.type === 'vector' ? vector : param.type === 'number' ? number : word;
  return codec as Codec<ParamValue>;
}

/**
 * The link of a state, readable and writable by hand. Values equal to their link defaults are left
 * out; the method never is, since its default may change.
 */
export function encode(state: AppState): string {
  const { page } = state;
  const pairs: [string, string][] = aboutRay(page) ? rayPairs(state) : [];
  const part = partOf(page);
  const { [part ?? '']: place, ...settings }: Settings = state.settings[page];
  if (part === undefined) pairs.push(['method', state.method]);
  if (page === 'explore') pairs.push(...lookPairs(state));
  else if (aboutRay(page)) pairs.push(...endPairs(state), ...hidePairs(state));
  pairs.push(...hostPairs(state));
  for (const [key, value] of Object.entries(settings)) pairs.push([escaped(key), escaped(value)]);
  const path = place ? `#/${page}/${escaped(place)}` : `#/${page}`;
  const query = pairs.map(([k, v]) => `${k}=${v}`).join('&');
  return query ? `${path}?${query}` : path;
}

const entryOf = (page: PageId): PageEntry | undefined => PAGES.find(({ id }) => id === page);
const partOf = (page: PageId): string | undefined => entryOf(page)?.part;
const aboutRay = (page: PageId): boolean => entryOf(page)?.ray === true;

/** The text with characters percent-encoded that would end the pair or not survive a link. */
function escaped(text: string): string {
  // encodeURIComponent throws for half a surrogate pair, which UTF-8 cannot encode.
  return text
    .replace(/\p{Surrogate}/gu, '\ufffd')
    .replace(/[^\w.,:;/~!*()'-]/gu, encodeURIComponent);
}

function rayPairs(state: AppState): [string, string][] {
  const shape = shapeOf(state);
  const pairs: [string, string][] = [['shape', state.kind]];
  const add = (key: string, value: string, initial: string): void => {
    if (value !== initial) pairs.push([key, value]);
  };
  /** The numbers of one parameter, each as typed. */
  const written = (places: readonly TypedNumberSlot[], symbol: string): string =>
    places
      .filter((place) => place.symbol === symbol)
      .map(({ key, value }) => escaped(state.typed[key] ?? linkNumber(value)))
      .join(',');
  add('E', written(rayPlaces(state), 'E'), vector.write(RAY_PARAMS.E.linkDefault));
  add('d', written(rayPlaces(state), 'd'), vector.write(RAY_PARAMS.d.linkDefault));
  add('unit', state.unit ? '1' : '0', '0');
  for (const param of findShape(state.kind)?.params ?? []) {
    const { write } = codecOf(param);
    const value = written(shapePlaces(shape), param.symbol);
    add(param.symbol, value || write(paramValue(shape, param.key)), write(unsaid(param)));
  }
  return pairs;
}

function lookPairs(state: AppState): [string, string][] {
  const pairs: [string, string][] = [];
  const looked = view.write(state.view);
  if (looked !== view.write(INITIAL.view)) pairs.push(['view', looked]);
  if (state.bead !== null) pairs.push(['t', number.write(state.bead)]);
  pairs.push(...endPairs(state), ...hidePairs(state));
  if (state.ask) pairs.push(['ask', state.ask]);
  if (state.derive) pairs.push(['derive', String(stepShown(state))]);
  return pairs;
}

/** On every page about the ray: it leads back to the same shape. */
const endPairs = ({ between, caps }: AppState): [string, string][] => [
  ...(between ? [['between', heights.write(between)] satisfies [string, string]] : []),
  ...(between && caps ? [['caps', '1'] satisfies [string, string]] : []),
];

/** On every page about the ray, since a page may tell what is hidden on another one. */
const hidePairs = ({ revealed }: AppState): [string, string][] =>
  revealed === null ? [] : [['hide', '1']];

/** What a host's page asks for. */
function hostPairs({ embed, lock, theme }: AppState): [string, string][] {
  const pairs: [string, string][] = [];
  if (embed) pairs.push(['embed', embed.join(',')]);
  if (lock.length > 0) pairs.push(['lock', lock.join(',')]);
  if (theme) pairs.push(['theme', theme]);
  return pairs;
}

/**
 * The state of a link. It never throws: what cannot be read gets its default, with a message in
 * `problems`. The other shapes stay as in `before`.
 */
export function decode(hash: string, before: AppState = INITIAL): AppState {
  const problems: string[] = [];
  const { page, given, empty } = split(hash, problems);
  const known = new Set<string>();
  const read: Read = (key, codec, initial, check) => {
    known.add(key);
    const text = given.get(key);
    if (text === undefined) return initial;
    try {
      const value = codec.read(text);
      check?.(value);
      return value;
    } catch (error) {
      if (!(error instanceof InvalidInput)) throw error;
      problems.push(`opened without ${key}: ${error.message}`);
      return initial;
    }
  };
  const ray = empty
    ? { ...INITIAL, shapes: { ...before.shapes, [INITIAL.kind]: shapeOf(INITIAL) } }
    : aboutRay(page)
      ? readRay(read, before)
      : before;
  // A page with a part in its path (lessons) shows states of its own, with their methods.
  const method = partOf(page)
    ? before.method
    : read('method', word, DEFAULT_METHOD, (v) => {
        if (!findMethod(v)) throw new InvalidInput(`${quote(v)} is not a method`);
      });
  const look =
    page === 'explore'
      ? readLook(read, before, walkLength(shapeOf(ray)))
      : { ...before, hidden: aboutRay(page) ? readHidden(read, before) : before.revealed !== null };
  const { between, caps } = before;
  const ends = aboutRay(page) ? readEnds(read) : { between, caps };
  const host = readHost(read, ray.kind);
  const own: [key: string, text: string][] = [];
  for (const [key, text] of given) {
    if (known.has(key)) continue;
    // Explore has one setting: the start rule of a ray that comes from a picture.
    if (page !== 'explore' || key === 'start') own.push([key, text]);
    else problems.push(`${quote(key)} means nothing for a ${ray.kind}`);
  }
  return {
    page,
    kind: ray.kind,
    shapes: ray.shapes,
    E: ray.E,
    d: ray.d,
    unit: ray.unit,
    typed: aboutRay(page) ? linkedTexts(given, ray, before.typed) : before.typed,
    method,
    view: look.view,
    bead: look.bead,
    ...ends,
    settings: { ...before.settings, [page]: Object.fromEntries(own) },
    problems,
    example: null,
    revealed: look.hidden ? 0 : null,
    ask: look.ask,
    told: false,
    derive: look.derive,
    ghost: before.ghost,
    ...host,
  };
}

type Read = <V>(key: string, codec: Codec<V>, initial: V, check?: (v: V) => void) => V;

function readRay(
  read: Read,
  before: AppState,
): Pick<AppState, 'kind' | 'shapes' | 'E' | 'd' | 'unit'> {
  const kind = read('shape', word, INITIAL.kind, knownKind) as ShapeKind;
  const shape = readShape(kind, (param) =>
    read(param.symbol, codecOf(param), unsaid(param), (v) => checkParam(param, v)),
  );
  return {
    kind,
    shapes: { ...before.shapes, [kind]: shape },
    E: read('E', vector, RAY_PARAMS.E.linkDefault, (v) => checkParam(RAY_PARAMS.E, v)),
    d: read('d', vector, RAY_PARAMS.d.linkDefault, (v) => checkParam(RAY_PARAMS.d, v)),
    unit: read('unit', word, '0', flag) === '1',
  };
}

interface Look extends Pick<AppState, 'view' | 'bead' | 'ask' | 'derive'> {
  readonly hidden: boolean;
}

/**
 * A link without `hide` keeps lines hidden or shown, so that a lecture can go from link to link.
 */
const readHidden = (read: Read, { revealed }: AppState): boolean =>
  read('hide', word, revealed === null ? '0' : '1', flag) === '1';

function readEnds(read: Read): Pick<AppState, 'between' | 'caps'> {
  const between = read<Between | null>('between', heights, null);
  const caps = read('caps', word, '0', (text) => {
    flag(text);
    if (text === '1' && !between)
      throw new InvalidInput("'caps' needs 'between', which is missing");
  });
  return { between, caps: caps === '1' };
}

function readLook(read: Read, before: AppState, steps: number): Look {
  return {
    hidden: readHidden(read, before),
    ask: read<string | null>('ask', word as Codec<string | null>, null, knownAsk) as Ask | null,
    view: read('view', view, INITIAL.view),
    bead: read<number | null>('t', number, null),
    derive: read<number | null>('derive', number, null, (given) => {
      const step = Number(given);
      if (step % 1 !== 0 || step < 1 || step > steps) {
        throw new InvalidInput(`${quote(step)} is not a step from 1 to ${steps}`);
      }
    }),
  };
}

function readHost(read: Read, kind: ShapeKind): Pick<AppState, 'embed' | 'lock' | 'theme'> {
  const symbols = (findShape(kind)?.params ?? []).map(({ symbol }) => symbol);
  const list = <T extends string>(names: readonly T[], what: string): Codec<T[]> => ({
    write: (all) => all.join(','),
    read: (text) => listOf(text, names, what),
  });
  return {
    embed: read<Part[] | null>('embed', list(PARTS, 'a part') as Codec<Part[] | null>, null),
    lock: read('lock', list(['E', 'd', 'between', ...symbols], `a symbol of a ${kind}`), []),
    theme: read<LinkTheme | null>(
      'theme',
      { write: String, read: (text) => listOf(text, LINK_THEMES, 'a theme')[0] ?? null },
      null,
    ),
  };
}

function readShape(kind: ShapeKind, read: (param: Param) => Vec3 | number | string): Shape {
  const params = (findShape(kind)?.params ?? []).map((param) => [param.key, read(param)] as const);
  return { ...initialShape(kind), ...Object.fromEntries(params) } as Shape;
}

/** Most keys that are read; no link that Graze writes has as many. */
export const MAX_KEYS = 40;

function split(
  hash: string,
  problems: string[],
): { page: PageId; given: ReadonlyMap<string, string>; empty: boolean } {
  const body = hash.replace(/^#?\/?/, '');
  const [path = '', ...rest] = body.split('?');
  const [name = '', ...places] = path.split('/');
  const known = PAGES.find(({ id }) => id === name)?.id;
  const part = known && partOf(known);
  const page = places.length === 0 || part ? known : undefined;
  if (!page && path !== '') problems.push(`there is no page ${quote(plain(path))}`);
  const given = new Map<string, string>();
  if (part && places.join('/') !== '') given.set(part, plain(places.join('/')));
  const pairs = rest.join('?').split('&').filter(Boolean);
  for (const pair of pairs.slice(0, MAX_KEYS)) {
    const [key = '', ...value] = pair.split('=').map(plain);
    if (given.has(key)) problems.push(`${quote(key)} stands there twice: the later one is taken`);
    given.set(key, value.join('='));
  }
  if (pairs.length > MAX_KEYS)
    problems.push(`only the first ${MAX_KEYS} of ${pairs.length} keys are read`);
  return { page: page ?? INITIAL.page, given, empty: path === '' && given.size === 0 };
}

/** The percent-decoded text, or the text itself if it cannot be decoded. */
function plain(text: string): string {
  try {
    return decodeURIComponent(text);
  } catch {
    return text;
  }
}

function knownKind(kind: string): void {
  if (findShape(kind)) return;
  const known = knownAs(kind);
  throw new InvalidInput(
    known ? `${quote(kind)} is called ${known} here` : `${quote(kind)} is not a shape`,
  );
}

function knownAsk(ask: string | null): void {
  if (ask === null || !isAsk(ask))
    throw new InvalidInput(`${quote(ask ?? '')} is nothing to predict`);
}

function flag(text: string): void {
  if (text !== '0' && text !== '1') throw new InvalidInput(`${quote(text)} is not 0 or 1`);
}

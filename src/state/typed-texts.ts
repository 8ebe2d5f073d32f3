import { SHAPES, type Shape, type Vec3 } from '../math/index.ts';
import { AXES, findShape, type Param, type ShapeKind } from '../math/shapes.ts';
import { shortest } from '../text/format.ts';
import { normalise } from '../text/normalise.ts';
import { parseNumber } from '../text/parse.ts';
import { type AppState, paramValue, RAY_PARAMS } from './state.ts';

/**
 * Texts that were typed for numbers, by name: 'E.x', 'cone.c'. Only those that differ from the
 * shortest text of the stored double: 1/3, sqrt(2), 1e7.
 */
export type TypedTexts = Readonly<Record<string, string>>;

/** One number of the ray or of a shape. */
export interface TypedNumberSlot {
  /** Its name in TypedTexts. */
  readonly key: string;
  /** The parameter's letter. */
  readonly symbol: string;
  /** Which component it is; null for a parameter that is one number. */
  readonly index: 0 | 1 | 2 | null;
  readonly value: number;
}

export function rayPlaces({ E, d }: Pick<AppState, 'E' | 'd'>): TypedNumberSlot[] {
  return [...places('', RAY_PARAMS.E, E), ...places('', RAY_PARAMS.d, d)];
}

export function shapePlaces(shape: Shape): TypedNumberSlot[] {
  const params = findShape(shape.kind)?.params ?? [];
  return params.flatMap((param) => places(`${shape.kind}.`, param, paramValue(shape, param.key)));
}

function places(owner: string, param: Param, value: Vec3 | number | string): TypedNumberSlot[] {
  const { symbol } = param;
  if (typeof value === 'number') return [{ key: owner + symbol, symbol, index: null, value }];
  if (typeof value === 'string') return [];
  return ([0, 1, 2] as const).map((index) => ({
    key: `${owner}${symbol}.${AXES[index]}`,
    symbol,
    index,
    value: value[index],
  }));
}

/**
 * The text to keep, with decimal points, since a comma separates numbers in a link; undefined if it
 * is the double's own text.
 */
function keptText(text: string | undefined, value: number): string | undefined {
  const plain = text?.trim().replace(/,(?=\d)/g, '.');
  if (plain === undefined || spelled(plain) === linkNumber(value)) return undefined;
  const parsed = parseNumber(plain);
  return parsed.ok && Object.is(parsed.value, value) ? plain : undefined;
}

/**
 * The shortest text of x without the + of an exponent: some programs turn a + in a link to a space.
 */
export const linkNumber = (x: number): string => withoutPlus(shortest(x));

/**
 * The text with an ASCII minus and no leading plus, so that +3 and −3 count as the double's text.
 */
const spelled = (text: string): string => withoutPlus(normalise(text)).replace(/^\+/, '');

const withoutPlus = (text: string): string => text.replace('e+', 'e');

/** The state after a change with `texts` as typed; other numbers that changed lose their texts. */
export function retyped(before: AppState, after: AppState, texts: TypedTexts = {}): AppState {
  const old = new Map(allPlaces(before).map(({ key, value }) => [key, value]));
  const typed = textsWhere(allPlaces(after), ({ key, value }) => {
    if (Object.hasOwn(texts, key)) return keptText(texts[key], value);
    return Object.is(old.get(key), value) ? before.typed[key] : undefined;
  });
  return sameTexts(after.typed, typed) ? after : { ...after, typed };
}

/** The texts without those of these shapes ('cone') or letters of the ray ('E'). */
export function untyped(texts: TypedTexts, letters: readonly string[]): TypedTexts {
  const stays = ([key]: [string, string]): boolean =>
    !letters.some((letter) => key === letter || key.startsWith(`${letter}.`));
  const entries = Object.entries(texts);
  const staying = entries.filter(stays);
  return staying.length === entries.length ? texts : Object.fromEntries(staying);
}

/** The typed texts in a file that belong to numbers of these shapes. */
export function readTexts(given: unknown, shapes: AppState['shapes']): TypedTexts {
  const texts = (given ?? {}) as Readonly<Record<string, unknown>>;
  return textsWhere(Object.values(shapes).flatMap(shapePlaces), ({ key, value }) => {
    const text = texts[key];
    return typeof text === 'string' ? keptText(text, value) : undefined;
  });
}

/** The typed texts of a link, for the ray and the shown shape; other shapes keep theirs. */
export function linkedTexts(
  given: ReadonlyMap<string, string>,
  state: Pick<AppState, 'E' | 'd' | 'shapes' | 'kind'>,
  before: TypedTexts,
): TypedTexts {
  const shape = state.shapes[state.kind];
  const own = textsWhere([...rayPlaces(state), ...shapePlaces(shape)], (place) => {
    const text = given.get(place.symbol);
    return keptText(place.index === null ? text : text?.split(',')[place.index], place.value);
  });
  return { ...untyped(before, ['E', 'd', state.kind]), ...own };
}

function textsWhere(
  among: readonly TypedNumberSlot[],
  textOf: (place: TypedNumberSlot) => string | undefined,
): TypedTexts {
  const texts: Record<string, string> = {};
  for (const place of among) {
    const text = textOf(place);
    if (text !== undefined) texts[place.key] = text;
  }
  return texts;
}

const KINDS = SHAPES.map(({ kind }) => kind) as readonly ShapeKind[];

const allPlaces = (state: AppState): TypedNumberSlot[] => [
  ...rayPlaces(state),
  ...KINDS.flatMap((kind) => shapePlaces(state.shapes[kind])),
];

function sameTexts(a: TypedTexts, b: TypedTexts): boolean {
  const keys = Object.keys(a);
  return keys.length === Object.keys(b).length && keys.every((key) => a[key] === b[key]);
}

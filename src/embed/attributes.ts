import { SHAPES } from '../math/index.ts';
import { definitionOf } from '../math/shapes.ts';
import { type AppState, INITIAL, shapeOf } from '../state/state.ts';
import { decode, encode } from '../state/url.ts';

/** Keys of links that an attribute may carry, besides the shape's own symbols. */
const KEYS = [
  ...['shape', 'E', 'd', 'unit', 'method', 'view', 't', 'between', 'caps', 'hide', 'ask', 'theme'],
];
/** Keys that may be there without a value: hide, for hide=1. */
const FLAGS = ['hide', 'caps', 'unit'];
/** Attributes that are called otherwise than their key. */
const RENAMED: Readonly<Record<string, string>> = { show: 'embed', lock: 'lock' };

const lower = (key: string): string => key.toLowerCase();

/** HTML knows no capital letters in names of attributes; no shape has both `C` and `c`. */
export const ATTRIBUTES: readonly string[] = [
  ...new Set([
    ...[...KEYS, ...Object.keys(RENAMED)].map(lower),
    ...SHAPES.flatMap(({ params }) => params.map(({ symbol }) => lower(symbol))),
  ]),
];

/** The link's key that an attribute means for a shape. */
function keyOf(attribute: string, kind: string): string {
  const params = SHAPES.find((shape) => shape.kind === kind)?.params ?? [];
  const symbols = params.map(({ symbol }) => symbol);
  const found = [...KEYS, ...symbols].find((key) => lower(key) === attribute);
  return RENAMED[attribute] ?? found ?? attribute;
}

/**
 * The state with these attributes put in; null takes one back to its default. What cannot be read
 * is said in `problems`.
 */
export function withAttributes(
  state: AppState,
  given: ReadonlyMap<string, string | null>,
): AppState {
  const link = encode(state);
  const pairs = new Map(
    (link.split('?')[1] ?? '')
      .split('&')
      .filter(Boolean)
      .map((pair) => pair.split(/=(.*)/s, 2) as [string, string]),
  );
  const kind = given.get('shape') ?? (given.has('shape') ? INITIAL.kind : state.kind);
  if (kind !== state.kind) {
    // Another shape has other symbols.
    for (const { symbol } of definitionOf(shapeOf(state)).params) pairs.delete(symbol);
  }
  for (const [attribute, value] of given) {
    const key = keyOf(attribute, kind);
    if (value === null) pairs.delete(key);
    else pairs.set(key, encodeURIComponent(value === '' && FLAGS.includes(key) ? '1' : value));
  }
  return decode(
    `#/explore?${[...pairs].map(([key, value]) => `${key}=${value}`).join('&')}`,
    state,
  );
}

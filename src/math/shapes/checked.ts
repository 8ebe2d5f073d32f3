import { countFields, InvalidInput, refused, requireFields } from '../invalid-input.ts';
import { type Given, plainVector } from '../vec3.ts';
import type { Heights } from './body.ts';
import type { ShapeDefinition } from './define.ts';
import { checkParam, type Param } from './params.ts';

/**
 * Beside a curved shape's own numbers: only its part with low ≤ y ≤ high is there, and with `caps`
 * discs close both ends. Rims and edges belong to it.
 */
export interface Ends {
  /** Heights of y, the lower one first; in units of length. */
  readonly between?: Heights | undefined;
  /** False where it is left out: the ends are open. */
  readonly caps?: boolean | undefined;
}

/** Ends that were checked. */
export interface Cut {
  readonly low: number;
  readonly high: number;
  readonly caps: boolean;
}

type Kind = { readonly kind: string };

const keysOf = ({ params }: { readonly params: readonly Param[] }): readonly string[] =>
  params.map(({ key }) => key);

/**
 * The shape with its vectors as plain arrays: itself, where they are.
 *
 * @throws InvalidInput unless every parameter of `entry` is there and in its range, and nothing
 *   else.
 */
export function checkedBy<S extends Kind>(
  { kind, params }: ShapeDefinition<S>,
  shape: Given<S>,
): S {
  const given = shape as unknown as Readonly<Record<string, unknown>>;
  const odd = countFields(given) !== params.length + 1;
  let plain = true;
  for (const param of params) {
    const value = given[param.key];
    if (odd || value === undefined) requireFields(kind, given, keysOf({ params }), 'kind');
    checkParam(param, value);
    if (param.type === 'vector' && !Array.isArray(value)) plain = false;
  }
  if (plain) return shape as S;
  const own = params.map(({ key, type }) => [
    key,
    type === 'vector' ? plainVector(given[key] as ArrayLike<number>) : given[key],
  ]);
  return { kind, ...Object.fromEntries(own) } as S;
}

/**
 * As `checkedBy`, with the shape's ends apart from it; null where it has none.
 *
 * @throws InvalidInput also for ends of a flat shape, and for heights that do not go up.
 */
export function checkedSolid<S extends Kind>(
  entry: ShapeDefinition<S>,
  given: Given<S> & Ends,
): { readonly shape: S; readonly cut: Cut | null } {
  const between = Object.hasOwn(given ?? {}, 'between') ? given.between : undefined;
  const caps = Object.hasOwn(given ?? {}, 'caps') ? given.caps : undefined;
  if (between === undefined && caps === undefined) {
    return { shape: checkedBy(entry, given), cut: null };
  }
  const { between: _, caps: __, ...bare } = given;
  const shape = checkedBy(entry, bare as unknown as Given<S>);
  if (entry.formula(shape).family !== 'curved') {
    requireFields(entry.kind, given, keysOf(entry), 'kind');
  }
  if (between === undefined) throw new InvalidInput("'caps' needs 'between', which is missing");
  if (caps !== undefined && typeof caps !== 'boolean') {
    throw refused('caps', 'must be true or false', caps);
  }
  return { shape, cut: { ...heightsOf(between), caps: caps === true } };
}

function heightsOf(between: unknown): { readonly low: number; readonly high: number } {
  const list = between as ArrayLike<unknown> | null;
  if (typeof list !== 'object' || list === null || list.length !== 2) {
    throw refused('between', 'must be two heights', between);
  }
  const [low, high] = [list[0], list[1]];
  const finite =
    typeof low === 'number' && typeof high === 'number' && low - low + high - high === 0;
  if (!finite) throw refused('between', 'must be two finite heights', between);
  if (!(low < high)) throw refused('between', 'must go up', between);
  return { low, high };
}

import { SHAPES } from '../math/index.ts';
import type { Param } from '../math/shapes.ts';

/** Which colour a symbol of a formula has, and which symbol lights up with it. */

const PARAMS: readonly Param[] = SHAPES.flatMap(({ params }): readonly Param[] => params);

/** A direction of a shape is its normal; every other parameter has the shape's own colour. */
const roleOf = (param: Param): string =>
  param.type === 'vector' && param.nonZero ? 'normal' : 'shape';

const rolesOf = (type: 'number' | 'vector'): [string, string][] =>
  PARAMS.flatMap((param) => (param.type === type ? [[param.symbol, roleOf(param)]] : []));

const SCALAR_ROLES: ReadonlyMap<string, string> = new Map(rolesOf('number'));
const VECTOR_ROLES: ReadonlyMap<string, string> = new Map([
  ...rolesOf('vector'),
  ['E', 'E'],
  ['d', 'd'],
]);

type Sort = 'scalar' | 'vector';

/** The class that carries the colour: sym-E, sym-d, sym-shape, sym-normal, or none. */
export function classOf(id: string, sort: Sort): string {
  const role = (sort === 'scalar' ? SCALAR_ROLES : VECTOR_ROLES).get(id);
  return role ? `sym sym-${role}` : 'sym';
}

/**
 * The name in data-symbol. The centre C and the coefficient C are two symbols that look the same.
 */
export function highlightOf(id: string, sort: Sort): string {
  return sort === 'scalar' && /^[ABCD]$/.test(id) ? `coefficient-${id}` : id;
}

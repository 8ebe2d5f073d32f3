import { SHAPES } from '../math/index.ts';
import type { Param } from '../math/shapes.ts';

/* The colour of a formula's symbols, and the name by which they are highlighted together. */

const PARAMS: readonly Param[] = SHAPES.flatMap(({ params }): readonly Param[] => params);

/** A direction of a shape has the normals' colour, every other parameter the shape's. */
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

/** The name in data-symbol; `coefficient-C` tells the coefficient C from a centre C. */
export function highlightOf(id: string, sort: Sort): string {
  return sort === 'scalar' && /^[ABCD]$/.test(id) ? `coefficient-${id}` : id;
}

/** Which colour a symbol of a formula has, and which symbol lights up with it. */

const SCALAR_ROLES: Readonly<Record<string, string>> = {
  r: 'shape',
  c: 'shape',
  a: 'shape',
  L: 'shape',
};
const VECTOR_ROLES: Readonly<Record<string, string>> = {
  E: 'E',
  d: 'd',
  N: 'normal',
  P: 'shape',
  C: 'shape',
  V: 'shape',
};

type Sort = 'scalar' | 'vector';

/** The class that carries the colour: sym-E, sym-d, sym-shape, sym-normal, or none. */
export function classOf(id: string, sort: Sort): string {
  const role = (sort === 'scalar' ? SCALAR_ROLES : VECTOR_ROLES)[id];
  return role ? `sym sym-${role}` : 'sym';
}

/** The name in data-symbol. The centre C and the coefficient C are two symbols that look the same. */
export function highlightOf(id: string, sort: Sort): string {
  return sort === 'scalar' && /^[ABCD]$/.test(id) ? `coefficient-${id}` : id;
}

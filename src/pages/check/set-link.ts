import { CHOSEN, partsOf } from '../../check/sets.ts';

/** The link of a set's questions, from # on: of letters that links hold as they are. */
export function setLink(set: string, seed: number): string {
  const { base, chosen } = partsOf(set);
  const pairs = [
    ['set', base],
    ...CHOSEN.flatMap((key) => (chosen[key] ? [[key, chosen[key]]] : [])),
    ['seed', String(seed)],
  ];
  return `#/check?${pairs.map(([key, text]) => `${key}=${text}`).join('&')}`;
}

/** The IRI of a set: its link here, or one that no host has where this page has no address. */
export function activityOf(hash: string): string {
  const isServed = location.protocol.startsWith('http');
  return `${isServed ? location.href.split(/[?#]/)[0] : 'https://graze.invalid/'}${hash}`;
}

import { SHAPES, type Shape } from '../math/index.ts';
import { definitionOf, findShape } from '../math/shapes.ts';
import type { Scene, Thing } from './types.ts';

/*
 * What things are called. An id is a name that somebody gave (glass cone), or the word for a shape
 * and perhaps a number (cone 2). A word that is no longer true, since the thing's shape was changed
 * or an older version called it by the kind of its formula, is replaced where the name is shown.
 */

/** The word for a thing of this shape; that of its kind if only an axis or a point is left. */
export function wordFor(shape: Shape): string {
  const { named, title } = definitionOf(shape);
  const { name } = named(shape);
  return words().has(name) ? thingWord(name) : title;
}

/** Surfaces whose things have another name. */
const THINGS = new Map([['sphere', 'ball']]);
const thingWord = (name: string): string => THINGS.get(name) ?? name;

let known: ReadonlySet<string> | null = null;

/** All words for shapes: kinds, what else they are called, and what things of them are called. */
function words(): ReadonlySet<string> {
  known ??= new Set(
    SHAPES.flatMap(({ kind }) => {
      const entry = findShape(kind);
      if (!entry) return kind;
      const { title, alsoCalled = {}, params } = entry;
      const values = params.map(({ key, initial }) => [key, initial]);
      const { name } = entry.named({ kind, ...Object.fromEntries(values) } as Shape);
      return [kind, title, ...Object.keys(alsoCalled), name, thingWord(name)];
    }),
  );
  return known;
}

const cache = new WeakMap<Scene, ReadonlyMap<string, string>>();

/** The names of the scene's things and lights by their ids; no two are the same. */
function namesOf(scene: Scene): ReadonlyMap<string, string> {
  const found = cache.get(scene);
  if (found) return found;
  const isTrue = (thing: Thing): boolean => {
    const word = thing.id.replace(/ \d+$/, '');
    return !words().has(word) || word === wordFor(thing.shape);
  };
  const names = new Map<string, string>();
  for (const { id } of [...scene.things.filter(isTrue), ...scene.lights]) names.set(id, id);
  for (const { id, shape } of scene.things) {
    if (!names.has(id)) names.set(id, free(wordFor(shape), [...names.values()]));
  }
  cache.set(scene, names);
  return names;
}

/** What the thing or light with this id is called. */
export const nameIn = (scene: Scene, id: string): string => namesOf(scene).get(id) ?? id;

/** An id for a new thing or light, by which it is also called: this word, or with a number. */
export const freeId = (scene: Scene, word: string): string =>
  free(word, [...namesOf(scene)].flat());

function free(word: string, taken: readonly string[]): string {
  if (!taken.includes(word)) return word;
  let k = 2;
  while (taken.includes(`${word} ${k}`)) k += 1;
  return `${word} ${k}`;
}

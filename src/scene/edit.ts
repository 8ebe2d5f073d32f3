import type { Shape } from '../math/index.ts';
import { GREY, type Light, type Placed, type Scene } from './types.ts';

/* Edits of a scene. Each returns a new scene that shares the unchanged parts with the old one. */

/** The first of `word`, `word 2`, `word 3`, … that is no id in the scene. */
export function freeId(scene: Scene, word: string): string {
  const taken = new Set([...scene.things, ...scene.lights].map(({ id }) => id));
  if (!taken.has(word)) return word;
  let k = 2;
  while (taken.has(`${word} ${k}`)) k += 1;
  return `${word} ${k}`;
}

/** Puts a shape into the scene, grey, named after its kind. */
export function addShape(scene: Scene, shape: Shape): Scene {
  return addThing(scene, { id: freeId(scene, shape.kind), shape, material: GREY });
}

export const addThing = (scene: Scene, thing: Placed): Scene => ({
  ...scene,
  things: [...scene.things, thing],
});

export const addLight = (scene: Scene, light: Light): Scene => ({
  ...scene,
  lights: [...scene.lights, light],
});

/** The scene without the thing or light of this id. */
export const remove = (scene: Scene, id: string): Scene => ({
  ...scene,
  things: scene.things.filter((thing) => thing.id !== id),
  lights: scene.lights.filter((light) => light.id !== id),
});

export const changeThing = (
  scene: Scene,
  id: string,
  change: (thing: Placed) => Placed,
): Scene => ({
  ...scene,
  things: scene.things.map((thing) => (thing.id === id ? change(thing) : thing)),
});

export const changeLight = (scene: Scene, id: string, change: (light: Light) => Light): Scene => ({
  ...scene,
  lights: scene.lights.map((light) => (light.id === id ? change(light) : light)),
});

import type { Shape, Vec3 } from '../math/index.ts';
import { definitionOf, type Param } from '../math/shapes.ts';
import type { Light, Scene, Thing } from './types.ts';

/* Edits of a scene. Each returns a new scene that shares the unchanged parts with the old one. */

export const addThing = (scene: Scene, thing: Thing): Scene => ({
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

export const changeThing = (scene: Scene, id: string, change: (thing: Thing) => Thing): Scene => ({
  ...scene,
  things: scene.things.map((thing) => (thing.id === id ? change(thing) : thing)),
});

export const changeLight = (scene: Scene, id: string, change: (light: Light) => Light): Scene => ({
  ...scene,
  lights: scene.lights.map((light) => (light.id === id ? change(light) : light)),
});

/** Whether a parameter is a position: changing it moves the whole shape. */
export const isPlace = (param: Param): boolean => param.type === 'vector' && !param.nonZero;

/** The thing somewhere else, its heights with it: from where it is, or where it was taken. */
export function moved(thing: Thing, by: Vec3, from = thing): Thing {
  const { shape } = thing;
  const { between } = from;
  const given = from.shape as unknown as Readonly<Record<string, Vec3>>;
  const places = definitionOf(shape)
    .params.filter(isPlace)
    .flatMap(({ key }) => {
      const [x, y, z] = given[key] ?? [0, 0, 0];
      return [[key, [sum(x, by[0]), sum(y, by[1]), sum(z, by[2])]] as const];
    });
  const there = { ...thing, shape: { ...shape, ...Object.fromEntries(places) } as Shape };
  return between && thing.between
    ? { ...there, between: [sum(between[0], by[1]), sum(between[1], by[1])] }
    : there;
}

/** Rounded to 14 digits, so that a sum of short decimals is a short decimal. */
export const sum = (a: number, b: number): number =>
  b === 0 ? a : Number((a + b).toPrecision(14));

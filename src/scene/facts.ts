import type { Vec3 } from '../math/index.ts';
import { definitionOf, sideOf } from '../math/shapes.ts';
import { nameIn } from './names.ts';
import type { Scene, Thing } from './types.ts';

/* Facts on a scene by which effects decide whether they are needed. */

export const isGlass = ({ material }: Thing): boolean => material.glass !== undefined;

export const isColouredGlass = ({ material }: Thing): boolean =>
  material.glass?.absorption.some((x) => x > 0) ?? false;

/** Whether a thing blocks light. Glass does not: shadow rays pass it straight (docs/FAKED.md). */
export const blocks = (thing: Thing): boolean => !isGlass(thing);

/** Whether a thing shows light on its paint or as a highlight. */
export const isLit = ({ material }: Thing): boolean =>
  material.mirror < 1 && (material.glass === undefined || material.shine.strength > 0);

/**
 * Why nothing can be in a shadow; null if something may be. `glass`: glass alone could cast one.
 */
export function whyNoShadow(
  scene: Scene,
): { readonly reason: string; readonly glass: boolean } | null {
  const no = (reason: string, glass = false) => ({ reason, glass });
  if (scene.things.length === 0) return no('there is nothing in the scene');
  const lit = scene.things.filter(isLit);
  if (lit.length === 0) return no('nothing shows light but what it mirrors or lets through');
  const [blocker, another] = scene.things.filter(blocks);
  if (!blocker) return no('glass is let through: a simplification', true);
  const alone = !another && lit.every((thing) => thing === blocker);
  if (!alone || !shadesNothing(blocker, scene.camera.eye)) return null;
  const own = `${nameIn(scene, blocker.id)} cannot shade itself on the side that is seen`;
  return scene.things.length > 1
    ? no(`glass is let through: a simplification; ${own}`, true)
    : no(`${own}, and it is alone`);
}

/**
 * Whether a thing cannot cast a shadow on the parts of itself that are seen: a flat shape, or a
 * whole convex one seen from outside.
 */
function shadesNothing({ shape, between }: Thing, eye: Vec3): boolean {
  const side = sideOf(shape, eye);
  if (side === null) return true;
  return !between && definitionOf(shape).body().convex(shape) && side > 0;
}

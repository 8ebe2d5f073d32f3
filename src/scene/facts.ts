import type { Vec3 } from '../math/index.ts';
import { definitionOf, sideOf } from '../math/shapes.ts';
import type { Placed, Scene } from './types.ts';

/* What effects ask of a scene. */

export const isGlass = ({ material }: Placed): boolean => material.glass !== undefined;

/**
 * Glass lets light through (without bending a shadow ray: see docs/FAKED.md), so it stands in no
 * light's way.
 */
export const blocks = (thing: Placed): boolean => !isGlass(thing);

/** Shows light on itself: on its paint, or as a highlight. */
const isLit = ({ material }: Placed): boolean =>
  material.mirror < 1 && (material.glass === undefined || material.shine.strength > 0);

/**
 * Why nothing in the scene can lie in a shadow, or null if something may. `glass`: but for that of
 * glass, which casts none here.
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
  const own = `${blocker.id} cannot shade itself on the side that is seen`;
  return scene.things.length > 1
    ? no(`glass is let through: a simplification; ${own}`, true)
    : no(`${own}, and it is alone`);
}

/**
 * A flat shape, or a whole convex one seen from outside: a line from a seen point to a light on its
 * outer side does not meet it again.
 */
function shadesNothing({ shape, between }: Placed, eye: Vec3): boolean {
  const side = sideOf(shape, eye);
  if (side === null) return true;
  return !between && definitionOf(shape).body.convex(shape) && side > 0;
}

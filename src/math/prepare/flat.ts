import { CONTAINED, createAnswers, createRays, ONE } from '../batch/batch.ts';
import { exactEnding } from '../ends.ts';
import { placeInPlane } from '../methods/certified/hits.ts';
import { certifiedSlot } from '../methods/certified/numbers.ts';
import { planarRoots, solvePlanarSlowly } from '../methods/certified/planar.ts';
import type { ShapeDefinition } from '../shapes/define.ts';
import type { Planar } from '../shapes/numbers.ts';
import { curvedSurface, exactHit, MISSED, neverTold, type Surface } from './lines.ts';

/** By `certified`: any shape, flat ones by their numbers too. */
export function anySurface<S extends { readonly kind: string }>(
  entry: ShapeDefinition<S>,
  shape: S,
): Surface {
  const { numbers } = entry;
  if (numbers?.family === 'planar') return planarSurface(numbers.read(shape));
  return curvedSurface(entry, shape);
}

function planarSurface(s: Planar): Surface {
  const rays = Object.assign(createRays(1), { count: 1 });
  const out = createAnswers(1);
  const left = { count: 0, open: new Int32Array(1) };
  const slot = certifiedSlot();
  const place: Surface['place'] = (ray, k, t, whole) =>
    placeInPlane(s, ray, t) ?? exactHit(whole, k, t);
  return {
    ask: null,
    settle: neverTold,
    quadric: null,
    isExact: true,
    ending: (ray, whole) => exactEnding(ray, null, whole),
    place,
    roots(ray, whole) {
      const { origin: E, direction: d } = ray;
      rays.Ex[0] = E[0];
      rays.Ey[0] = E[1];
      rays.Ez[0] = E[2];
      rays.dx[0] = d[0];
      rays.dy[0] = d[1];
      rays.dz[0] = d[2];
      planarRoots(s, rays, out, left);
      let t = out.t0[0] as number;
      if (left.count > 0) {
        const verdict = solvePlanarSlowly(s, rays, 0, out, slot);
        if (verdict === CONTAINED) return { verdict: 'contained', hits: [] };
        t = verdict === ONE ? slot.t0 : Number.NaN;
      }
      return Number.isNaN(t) ? MISSED : { verdict: 'one', hits: [place(ray, 0, t, whole)] };
    },
  };
}

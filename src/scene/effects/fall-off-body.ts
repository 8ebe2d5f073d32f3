import type { LightBody, WorldLight } from './body.ts';

/** The inverse square law, from the distance on at which the lamp has its full strength. */
export const body = (lampOf: (light: WorldLight) => { readonly full: number }): LightBody => ({
  at: 'light',
  run(_wave, lit, _tools, all) {
    const { full } = lampOf(lit.light);
    if (lit.light.sun || (full === 0 && !all)) return;
    for (let k = 0; k < lit.count; k++) {
      // Forced on for a lamp that does not fall off: all of its light.
      const near = full === 0 ? 1 : Math.min(1, full / (lit.distance[k] as number));
      lit.reach[k] = (lit.reach[k] as number) * near * near;
    }
  },
});

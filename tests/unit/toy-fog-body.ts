import type { Vec3 } from '../../src/math/vec3.ts';
import type { MediumBody, World } from '../../src/scene/effects/body.ts';

/** Density in 1/length; the colour is linear light. */
interface Air {
  readonly density: number;
  readonly colour: Vec3;
}

export const body = (airOf: (world: World) => Air): MediumBody => ({
  at: 'medium',
  run(wave, world, _all, add) {
    const { density, colour } = airOf(world);
    for (let i = 0; i < wave.count; i++) {
      const t = wave.t[i] as number;
      // 0 · ∞ is no number: a ray that meets nothing goes on for the largest length there is.
      const through = Math.exp(-density * (Number.isNaN(t) ? Number.MAX_VALUE : t));
      const red = wave.red[i] as number;
      const green = wave.green[i] as number;
      const blue = wave.blue[i] as number;
      const [r, g, b] = colour;
      const joins = 1 - through;
      add(i, red * joins * r, green * joins * g, blue * joins * b);
      wave.red[i] = red * through;
      wave.green[i] = green * through;
      wave.blue[i] = blue * through;
    }
  },
  brightest: (world, behind) => Math.max(behind, ...airOf(world).colour),
});

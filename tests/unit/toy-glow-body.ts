import type { Vec3 } from '../../src/math/vec3.ts';
import type {
  MediumBody,
  SurfaceMaterial,
  World,
  WorldLight,
} from '../../src/scene/effects/body.ts';

export const body = (
  auraOf: (material: SurfaceMaterial) => { readonly power: number },
  lampOf: (light: WorldLight) => { readonly feeds: string },
): MediumBody => {
  /** The light of all lamps that feed it. */
  const fed = ({ lights }: World): Vec3 =>
    lights
      .filter((light) => lampOf(light).feeds === 'glow')
      .map(({ colour }) => colour)
      .reduce<Vec3>(([r, g, b], [x, y, z]) => [r + x, g + y, b + z], [0, 0, 0]);
  return {
    at: 'medium',
    run(wave, world, _all, add) {
      const [r, g, b] = fed(world);
      for (let i = 0; i < wave.count; i++) {
        const material = world.materials[wave.surface[i] as number];
        const power = material ? auraOf(material).power : 0;
        const red = power * (wave.red[i] as number);
        const green = power * (wave.green[i] as number);
        const blue = power * (wave.blue[i] as number);
        add(i, red * r, green * g, blue * b);
      }
    },
    brightest(world, behind) {
      const powers = world.materials.map((material) => auraOf(material).power);
      return behind + Math.max(0, ...powers) * Math.max(...fed(world));
    },
  };
};

import { fresnel } from '../optics.ts';
import { type BounceBody, type Look, REFRACTED, type Wave } from './body.ts';
import { follow, mirrored, weightOf } from './bounce.ts';

export const body: BounceBody = {
  at: 'bounce',
  run(wave, { looks }, tools, all) {
    const next = tools.next(2 * wave.hitCount);
    let reflected = 0;
    let refracted = 0;
    for (let h = 0; h < wave.hitCount; h++) {
      const i = wave.hits[h] as number;
      const { index, mirror, shine } = looks[wave.surface[i] as number] as Look;
      const forced = index === 0 && all && wave.depth === 0;
      if (index === 0 && !forced) continue;
      const share = forced ? 0 : (1 - mirror) * (1 - shine);
      const inside = wave.back[i] === 1;
      const eta = forced ? 1 : inside ? index : 1 / index;
      const cosine = cosineOf(wave, i);
      const back = fresnel(eta, cosine);
      const weight = share * weightOf(wave, i);
      if (back > 0 && share > 0 && tools.worth(back * weight)) {
        mirrored(wave, i, next, share * back);
        reflected += 1;
      }
      if (back < 1 && (forced || (share > 0 && tools.worth((1 - back) * weight)))) {
        bent(wave, i, next, share * (1 - back), eta, cosine);
        refracted += 1;
      }
    }
    tools.fired('reflected', reflected);
    tools.fired('refracted', refracted);
  },
};

const cosineOf = ({ rays, Nx, Ny, Nz }: Wave, i: number): number =>
  -(
    (rays.dx[i] as number) * (Nx[i] as number) +
    (rays.dy[i] as number) * (Ny[i] as number) +
    (rays.dz[i] as number) * (Nz[i] as number)
  );

/** Snell's law: d's tangential part times eta, and a normal part that makes the length 1. */
function bent(
  wave: Wave,
  i: number,
  next: Wave,
  weight: number,
  eta: number,
  cosine: number,
): void {
  const j = follow(wave, i, next, weight, REFRACTED);
  const inwards = Math.sqrt(Math.max(0, 1 - eta * eta * (1 - cosine * cosine)));
  const along = eta * cosine - inwards;
  next.rays.dx[j] = eta * (wave.rays.dx[i] as number) + along * (wave.Nx[i] as number);
  next.rays.dy[j] = eta * (wave.rays.dy[i] as number) + along * (wave.Ny[i] as number);
  next.rays.dz[j] = eta * (wave.rays.dz[i] as number) + along * (wave.Nz[i] as number);
  next.medium[j] = wave.back[i] === 1 ? -1 : (wave.surface[i] as number);
}

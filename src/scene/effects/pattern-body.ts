import type { PaintBody, SurfaceMaterial, Wave } from './body.ts';

export const body: PaintBody = {
  at: 'paint',
  run(wave, { materials }, all) {
    for (let h = 0; h < wave.hitCount; h++) {
      const i = wave.hits[h] as number;
      const material = materials[wave.surface[i] as number] as SurfaceMaterial;
      if (material.pattern.length === 0 && !all) continue;
      const colour = isOdd(wave, i, material) ? material.other : material.colour;
      wave.paintR[i] = colour[0];
      wave.paintG[i] = colour[1];
      wave.paintB[i] = colour[2];
    }
  },
};

/** Whether the hit is in an odd cube or slice of the pattern. */
function isOdd(wave: Wave, i: number, { pattern, size }: SurfaceMaterial): boolean {
  let sum = 0;
  for (const axis of pattern) {
    const at = axis === 0 ? wave.Px[i] : axis === 1 ? wave.Py[i] : wave.Pz[i];
    sum += Math.floor((at as number) / size);
  }
  return sum % 2 !== 0;
}

import type { MediumBody } from './body.ts';

export const body: MediumBody = {
  at: 'medium',
  run(wave, { materials }, all) {
    for (let i = 0; i < wave.count; i++) {
      const medium = wave.medium[i] as number;
      const material = materials[medium];
      if (material)
        fade(wave.red, wave.green, wave.blue, i, material.absorption, chordOf(wave.t, i));
      else if (all) fade(wave.red, wave.green, wave.blue, i, CLEAR, chordOf(wave.t, i));
    }
  },
  brightest: (_, behind) => behind,
};

const CLEAR = [0, 0, 0] as const;

/** Length of the ray in glass: t, since d has length 1; the largest double if it hits nothing. */
function chordOf(t: Float64Array, i: number): number {
  const chord = t[i] as number;
  return Number.isNaN(chord) ? Number.MAX_VALUE : chord;
}

/** Absorption by Beer and Lambert: e^(−σ · chord). */
function fade(
  red: Float64Array,
  green: Float64Array,
  blue: Float64Array,
  i: number,
  sigma: readonly [number, number, number],
  chord: number,
): void {
  red[i] = (red[i] as number) * Math.exp(-sigma[0] * chord);
  green[i] = (green[i] as number) * Math.exp(-sigma[1] * chord);
  blue[i] = (blue[i] as number) * Math.exp(-sigma[2] * chord);
}

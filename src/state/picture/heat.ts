/** Numbers of a picture's pixels, and how they are shown as shades. */
export interface Heat {
  /** The least number above 0; 0 if there is none. */
  readonly least: number;
  readonly most: number;
  readonly sum: number;
  readonly mean: number;
  /** Share of the sum that the dearest tenth of the pixels have, 0 … 1. */
  readonly tenth: number;
  /** Numbers to write at the scale: least, powers of ten between, most. */
  readonly ticks: readonly number[];
}

/** Shade of the least number. */
const FAINTEST = 0.05;

export function heatOf(values: Uint32Array): Heat {
  const ascending = values.slice().sort();
  const sum = ascending.reduce((all, x) => all + x, 0);
  const least = ascending.find((x) => x > 0) ?? 0;
  const most = ascending.at(-1) ?? 0;
  const few = Math.ceil(values.length / 10);
  const dearest = ascending.subarray(values.length - few).reduce((all, x) => all + x, 0);
  const tens: number[] = [];
  // A tick too near to an end has no room for its number.
  const apart = (most / least) ** (1 / 7);
  for (let ten = 10; ten * apart <= most; ten *= 10) if (ten >= least * apart) tens.push(ten);
  return {
    least,
    most,
    sum,
    mean: sum / Math.max(1, values.length),
    tenth: sum > 0 ? dearest / sum : 0,
    ticks: [...new Set([least, ...tens, most])],
  };
}

/** Place of a number on the logarithmic scale, 0 at the least and 1 at the most. */
export function placeOf({ least, most }: Heat, value: number): number {
  if (!(value > least)) return 0;
  return most > least ? Math.log(value / least) / Math.log(most / least) : 0;
}

/** Darkness of a number, 0 (nothing) or FAINTEST … 1. */
export const shadeOf = (heat: Heat, value: number): number =>
  value === 0 ? 0 : FAINTEST + (1 - FAINTEST) * placeOf(heat, value);

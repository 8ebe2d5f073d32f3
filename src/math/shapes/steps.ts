/**
 * The largest of 1, 2, 5 times a power of ten that is not above x > 0.
 *
 * @param x above 0, in any unit.
 * @returns in the unit of x.
 * @see NUMERICS.md, section 7
 * @example
 * [0.3, 7, 12].map(roundStep); // → [0.2, 5, 10]
 */
export function roundStep(x: number): number {
  const power = 10 ** Math.floor(Math.log10(x));
  const lead = x / power;
  // 1 ± a few ε: a quotient that should be 1, 2 or 5 may come out just below.
  const slack = 1 + 1e-9;
  return (lead * slack >= 5 ? 5 : lead * slack >= 2 ? 2 : 1) * power;
}

/**
 * Multiples of `step` strictly between `from` and `to`; at most 200 of them.
 *
 * @param from and `to` and `step` have one unit; step > 0.
 * @returns in the unit of `step`, ascending.
 * @see NUMERICS.md, section 7
 * @example
 * multiplesWithin(0, 1, 0.25); // → [0.25, 0.5, 0.75]
 */
export function multiplesWithin(from: number, to: number, step: number): number[] {
  const found: number[] = [];
  for (let k = Math.floor(from / step) + 1; k * step < to && found.length < 200; k++) {
    found.push(k * step);
  }
  return found;
}

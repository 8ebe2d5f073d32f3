/*
 * The second stage: everything once more in double-double, on a ray whose max |d| and largest
 * length lie in 2^-40 … 2^40, or are scaled by powers of two into [1, 2). Errors, in ε = 5u² < 2^-103, a bound for every sum and product of float/double-double.ts;
 * products of two doubles are exact, and so are p = E − C (a sum of two doubles), c² and r².
 *
 *   A = dx² + dz² − a·dy²     the last product ε, two sums ε each:                        |δA| ≤ 3ε Am (1 + ε)² < 4ε Am
 *   b = dx px + dz pz − a·dy·py   products ε (the last 2ε), two sums:                     |δb| < 5ε bm ≤ 5ε √(Am Cm)
 *   C = px² + pz² − a·py² − ρ     products ε (the last 2ε), three sums:                   |δC| < 6ε Cm
 *   m = d × p                 products ε, one sum:                                        |δmi| < 3ε Si
 *   mi²                       2|mi|·3ε Si + 9ε² Si² + ε mi²:                              < 8ε Si²
 *   D/4 = ρA + a(mx² + mz²) − my²   (4 + 1)ε of ρAm; (8 + 1 + 1)ε of a(Sx² + Sz²), 8ε of Sy², two sums: < 13ε S
 *
 * where Am = dx² + dz² + |a|dy², Pm = px² + pz² + |a|py², Cm = Pm + ρ, Si = |dj pk| + |dk pj|,
 * bm = |dx px| + |dz pz| + |a dy py| ≤ √(Am Pm) (Cauchy–Schwarz), and
 * S = ρAm + |a|(Sx² + Sz²) + Sy² ≤ ρAm + 2AmPm ≤ 2AmCm, since (|α| + |β|)² ≤ 2α² + 2β² and every dj²pk² of the three
 * sums appears in AmPm. Hence |δ(D/4)| < 26ε AmCm < 2^-98 AmCm. Am and Cm, evaluated in doubles, are off by a few u;
 * DISCRIMINANT_ERROR has room for it (26 · 2^-103 = 2^-98.3).
 *
 * Underflow: a product that leaves the doubles is off by 2^-1073 at most, and what multiplies it afterwards is at most
 * |a|² |d|² |p|² < 2^400 · 2^82 · 2^84; with fewer than 2^10 operations this is below ABSOLUTE_ERROR.
 */
export const EPSILON = 2 ** -103;
export const DISCRIMINANT_ERROR = 2 ** -98;
export const ABSOLUTE_ERROR = 2 ** -440;
/** max |d| and the largest length between 2^-40 and 2^40 need no scale. */
export const ORDINARY = 2 ** 40;
/** Beyond this a·dy² and the absolute term above lose their meaning: such shapes go to the exact stage at once. */
export const LARGEST_FLARE = 2 ** 200;
export const SMALLEST_SQUARED = 2 ** -400;

/**
 * A result hi + lo with relative error η is faithful when rounded to hi if η < u/2: neighbours of x are at least u|x| away.
 * Half of that is left to the double-precision evaluation of η itself.
 */
export const FAITHFUL = 2 ** -55;

/** Of C once more from the exact terms of its expansion, of Cm: see near-surface.ts. */
export const ACCUMULATED_ERROR = 2 ** -180;

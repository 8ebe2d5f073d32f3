/*
 * The second stage: everything once more in double-double, on a ray whose max |d| and largest length lie in 2^-40 … 2^40, or are scaled by powers of two
 * into [1, 2). Errors in u² = 2^-106, from float/double-double.ts: a sum 3u², a product 5u², none if both are doubles. p = E − C is exact, and so are c² and r².
 *
 * Two products of d's doubles with double-doubles, added: each 3u² of itself, their rests together 2u² and beside the sum 2u² and u² of that; of doubles alone
 * 2u² of both and u² of the sum.
 *
 *   A = dx² + dz² − a·dy²         the pair 3u², one sum; a·dy² 5u², one sum:                   |δA| ≤ 8u² Am
 *   b = dx px + dz pz − a·dy·py   the pair 8u², one sum; 10u², one sum:                        |δb| ≤ 13u² bm, bm ≤ √(Am Cm)
 *   C = px² + pz² − a·py² − ρ     5u², three sums; 10u², two; ρ one:                           |δC| ≤ 16u² Cm
 *   m = d × p                     the pair:                                                    |δmi| ≤ 7u² Si + u²|mi|
 *   mi²                           2|mi||δmi| and 5u² mi², |mi| ≤ Si:                           ≤ 21u² Si²
 *   D/4 = (ρA − my²) + a(mx² + mz²)   ρA: 8 + 5 + 3 + 3; my²: 21 + 3 + 3; a(…): 21 + 3 + 5 + 3:      ≤ 32u² S
 *
 * where Am = dx² + dz² + |a|dy², Pm = px² + pz² + |a|py², Cm = Pm + ρ, Si = |dj pk| + |dk pj|, bm = |dx px| + |dz pz| + |a dy py| ≤ √(Am Pm)
 * (Cauchy–Schwarz), and S = ρAm + |a|(Sx² + Sz²) + Sy². With y in units of √|a|, w = (|dx px|, |dy py|, |dz pz|):
 *   ΣSi² = Σj≠k dj²pk² + 2 Σj<k wj wk = (Am Pm − Σw²) + ((Σw)² − Σw²), and Σw² ≥ (Σw)²/3, (Σw)² ≤ Am Pm, so
 *   ΣSi² ≤ 4/3 Am Pm,  S ≤ 4/3 Am Cm  and  |δ(D/4)| ≤ 43u² Am Cm.
 * The constants have room for the terms in u³ and for Am, bm and Cm being rounded.
 *
 * Underflow: a product that leaves the doubles is off by LOST at most, and so are a square c² and a component of d that is scaled. With |d|, |E|, |C| and r below
 * ORDINARY and |a| ≤ LARGEST_FLARE the most comes of d: 2^42 LOST in m, times 2^83 in its square, times 2^200. ABSOLUTE_ERROR is above all of that together.
 * A cone's c² < 2^-968 is not exact; where it counts, |d|²|p|² c² and D with it are below ABSOLUTE_ERROR, so no zero is believed because of it.
 */
const UU = 2 ** -106;
export const ERROR_A = 9 * UU;
export const ERROR_B = 14 * UU;
export const ERROR_C = 17 * UU;
export const DISCRIMINANT_ERROR = 44 * UU;
/** Of a double-double's sum, product, quotient and root: float/double-double.ts. */
export const ERROR_SUM = 3 * UU;
export const ERROR_QUOTIENT = 10 * UU;
export const ERROR_ROOT = 3.2 * UU;
/** productError's 2^-1073, and the rounding of the two cross products. */
export const LOST = 2 ** -1072;
export const ABSOLUTE_ERROR = 2 ** -745;
/** max |d| and the largest length between 2^-40 and 2^40 need no scale. */
export const ORDINARY = 2 ** 40;
/** Beyond this the absolute term above loses its meaning: such shapes go to the exact stage at once. */
export const LARGEST_FLARE = 2 ** 200;
/**
 * Of Cm: C once more from the exact terms of its expansion. There are 38 (three squares for each coordinate of p, twice as many products with c² for the one
 * along y, each of which is two doubles, and ρ), the sum of their sizes is < 2Cm, and `accumulate` is off by (2n u)^4 of it.
 */
export const ACCUMULATED_ERROR = 2 * (2 * 38 * 2 ** -53) ** 4;
/** And adding up its levels, each sum 3u² of itself. */
export const ERROR_LEVELS = 9 * UU;

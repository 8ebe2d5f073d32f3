/*
 * D/4 by the moment. u = 2^-53. Coordinates along y are multiplied by k = √|a|: Y = k·dy, PY = k·(Ey − Cy), so all three
 * are alike. p = fl(E − C) is off by u; k by u, so Y by 2u and PY by 3u.
 *
 *   m = d × p: each of its two products is off by ≤ 4u, the difference by u|m|:           |δmi| ≤ 4u Si + u|mi|
 *   mi²:       2|mi|(4u Si + u|mi|) + (4u Si + u|mi|)² + u mi²:                           ≤ 8u |mi| Si + 3u mi² + 16u² Si² + 9u² |mi| Si
 *   ρA:        A: dx² 3u, Y² (4 + 2)u; ρ u; the product u:                                ≤ 8u ρ Am
 *   D/4 = ρA ± (mx² + mz²) − my²: three more sums, each of which adds u of what it adds:
 *              |δ(D/4)| ≤ Σ ((8u + 9u²)|mi|Si + 6u mi²) + 10u ρAm + 16u² Σ Si²  ≤ u·(14.1 M S + 10 ρAm + 4u S²)
 *
 * with Si = |dj pk| + |dk pj|, S = |d|₁|p|₁ ≥ ΣSi, M = Σ|mi|, mi² ≤ |mi| Si, all as they are computed. In the last term Si² ≤ mi² + 4 wj wk for wj = |dj pj|, and
 * Σj<k wj wk ≤ (Σ√wj)⁴/16 ≤ S²/16 (most for two of them alike and no third), so Σ Si² ≤ Σ mi² + S²/4. MOMENT_ERROR, SQUARE_ERROR and RHO_ERROR are these
 * constants with room for terms in u² and for evaluating the bound in doubles (a relative 20u). Unlike 13u·S² it stays sharp
 * however far away E is, where M ≪ S.
 *
 * Underflow: inside the box (|d|₁ from 2^-100 to 2^100, |p|₁ and r and k up to 2^100) a lost product is ≤ 2^-1074, and at
 * most 2^600 multiplies it; SMALLEST_D is far above.
 */
export const MOMENT_ERROR = 16 * 2 ** -53;
export const SQUARE_ERROR = 5 * 2 ** -106;
export const RHO_ERROR = 12 * 2 ** -53;
export const SMALLEST_D = 2 ** -200;

/** Below |A| = LEAST_A·Am nothing is said about A: above, A ≠ 0, and it is known to 6u·2^20 < 2^-30. */
export const LEAST_A = 2 ** -20;

/** The bound on |δ(D/4)| that is derived above. */
export const momentError = (S: number, M: number, rhoAm: number): number =>
  S * (MOMENT_ERROR * M + SQUARE_ERROR * S) + RHO_ERROR * rhoAm + SMALLEST_D;

/** The bound of the direct form, b² − AC, in units of Am·Cm; derived in class-quadric.ts. */
export const DIRECT_ERROR = 27 * 2 ** -53;

import { float64 } from '../arithmetic/float64.ts';
import { momentForm } from './forms.ts';
import { stableSolver } from './solvers.ts';
import { coefficientsBy, intersectBy } from './tree-method.ts';
import type { TreeMethod } from './tree-parts.ts';

/*
 * The error of D/4, in units of u = 2^-53 and to first order (second-order terms are 1e-15 of
 * these), without over- and underflow. p = E − C is off by 1 of itself, a product dy·pz by 2, and
 * mx by 3 of Sx = |dy pz| + |dz py|, since its subtraction adds 1 of |mx| ≤ Sx. Then
 *   mx² + mz²   2·3 + 1 + 1 = 8 of Sx² + Sz²;  times a: 9, or 10 if a = c² is rounded itself
 *   my²         2·3 + 1 = 7 of Sy²
 *   ρA          ρ = r²: 1; A: dy² 1, a dy² 2 (or 3), the two sums 2; the product 1: 6 of ρ·Am,
 *               where Am = dx² + dz² + |a|dy²
 * and each of the three is in at most two more additions: 12 of ρ·Am + |a|(Sx² + Sz²) + Sy² covers
 * them all. The 4 is exact.
 */
export const moment: TreeMethod<number> = {
  id: 'moment',
  title: 'moment',
  hint: 'D from d × (E − C), then q',
  idea:
    'D/4 = ρA + a(mx² + mz²) − my² from the ray’s moment m = d × (E − C), which does not ' +
    'grow when E slides back along the ray.',
  promise:
    'No hit is lost to distance: the error of D/4 is at most 12 u (ρ·Am + |a|(Sx² + Sz²) + ' +
    'Sy²), where Am and S are A and m with every term taken positive. Roots by the stable ' +
    'formula; C still loses digits near the surface. Circle and square are decided by |m × ' +
    'N|² ≤ r²(N·d)² and its like.',
  source:
    'Lagrange’s identity; Haines, Günther, Akenine-Möller 2019, Precision improvements for ' +
    'ray/sphere intersection, in Ray Tracing Gems, for the idea of moving E.',
  arithmetic: float64,
  form: momentForm,
  solver: stableSolver,
  decidedBy: 'formula',
  coefficients: (shape, ray) => coefficientsBy(moment, shape, ray),
  intersect: (shape, ray) => intersectBy(moment, shape, ray),
  parts: (use) => use(moment),
};

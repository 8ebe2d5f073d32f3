import { intersectCertified } from './certified/object.ts';
import type { Method } from './define.ts';
import { exact } from './exact.ts';

export const certified: Method = {
  id: 'certified',
  title: 'certified',
  hint: 'a filter, then more digits if needed',
  idea:
    'Floating point with a proven error bound decides nearly every ray; what it leaves open ' +
    'goes to twice the digits, and the rest to whole numbers.',
  promise:
    'For every finite input: the class of exact arithmetic, and each root one of the two doubles ' +
    'around the exact one, itself where that is a double. The coordinates of a point likewise, ' +
    'from the exact root; the direction of its normal within 2^-50, unless it leaves the ' +
    'doubles.',
  source:
    'Shewchuk 1997, Adaptive precision floating-point arithmetic and fast robust geometric ' +
    'predicates, for the stages; Dekker 1971 and Rump, Ogita, Oishi 2008 for the grids.',
  proven: 'faithful',
  // The exact method's coefficients are correctly rounded, which is more than is promised here.
  coefficients: exact.coefficients,
  intersect: intersectCertified,
};

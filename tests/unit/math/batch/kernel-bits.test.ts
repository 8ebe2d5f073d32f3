import { expect, test } from 'vitest';
import { FAMILIES } from '../../../../src/math/families.ts';
import { seeded } from '../../../../src/math/rng.ts';
import { bent } from '../../../fuzz/bent.ts';
import { atKernelLimits, unlikeTrees } from '../../../fuzz/kernel-bits.ts';

/* `npm run fuzz -- --only kernels` asks the same about as many rays as wanted. */

test.each(FAMILIES().map((family) => [family.id, family] as const))(
  'every kernel that is made of trees has their bits: %s, bent and in other units (seed 307)',
  (_, { make }) => {
    const random = seeded(307);
    const found = Array.from({ length: 24 }, () =>
      unlikeTrees(atKernelLimits(bent(make(random), random), random)),
    );
    expect(found.filter((told) => told !== null)).toEqual([]);
  },
);

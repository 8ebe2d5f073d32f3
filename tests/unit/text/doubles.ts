import fc from 'fast-check';

export const SEED = 20_250_611;

const view = new DataView(new ArrayBuffer(8));

/**
 * Any finite double, all bit patterns alike likely: half of them are beyond 1e±150, which fc.double
 * rarely visits.
 */
export const anyDouble = fc
  .bigInt({ min: 0n, max: 2n ** 64n - 1n })
  .map((bits) => {
    view.setBigUint64(0, bits);
    return view.getFloat64(0);
  })
  .filter(Number.isFinite);

/*
 * The two laws at a boundary, as closed forms. `eta` is n₁/n₂, from the ray's side to the other;
 * cosines are taken with the normal on the ray's side.
 */

/** The cosine on the other side by Snell, n₁ sin θ₁ = n₂ sin θ₂; NaN beyond the critical angle. */
export function snell(eta: number, cosine: number): number {
  return Math.sqrt(1 - eta * eta * (1 - cosine * cosine));
}

/**
 * The share of unpolarised light that is sent back: the mean of both polarisations' (Fresnel); 1
 * beyond the critical angle.
 */
export function fresnel(eta: number, cosine: number): number {
  const other = snell(eta, cosine);
  if (Number.isNaN(other)) return 1;
  const across = (eta * cosine - other) / (eta * cosine + other);
  const along = (cosine - eta * other) / (cosine + eta * other);
  const share = (across * across + along * along) / 2;
  // At a grazing ray both sums are 0.
  return share <= 1 ? share : 1;
}

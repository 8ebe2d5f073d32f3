/*
 * Snell's and Fresnel's laws. `eta` is n₁/n₂, with n₁ on the ray's side; cosines are those of
 * angles with the normal on the ray's side.
 */

/** cos θ₂ by Snell, n₁ sin θ₁ = n₂ sin θ₂; NaN beyond the critical angle. */
export function snell(eta: number, cosine: number): number {
  return Math.sqrt(1 - eta * eta * (1 - cosine * cosine));
}

/** Reflected share of unpolarised light, the mean of both polarisations; 1 in total reflection. */
export function fresnel(eta: number, cosine: number): number {
  const other = snell(eta, cosine);
  if (Number.isNaN(other)) return 1;
  const across = (eta * cosine - other) / (eta * cosine + other);
  const along = (cosine - eta * other) / (cosine + eta * other);
  const share = (across * across + along * along) / 2;
  // For a grazing ray it is 0/0.
  return share <= 1 ? share : 1;
}

import type { Ray } from '../math/index.ts';
import { display } from '../text/format.ts';
import { subscript } from '../text/scripts.ts';

/** Heights between which a thing of a scene is kept: low ≤ y ≤ high. */
export type Between = readonly [low: number, high: number];

/** The height of a point, computed as the tracer does. */
const heightAt = ({ origin, direction }: Ray, t: number): number => origin[1] + t * direction[1];

/** "y = 1.774 > 1", if the point at t is cut off; null otherwise. */
export function whyCut(ray: Ray, t: number, [low, high]: Between): string | null {
  const y = heightAt(ray, t);
  if (y >= low && y <= high) return null;
  const above = y > high;
  const [own, limit] = told(y, above ? high : low);
  return `y = ${own} ${above ? '>' : '<'} ${limit}`;
}

/** Both numbers with as many digits as it takes to tell them apart, at least four. */
function told(y: number, limit: number): readonly [string, string] {
  for (let digits = 4; digits < 17; digits++) {
    const [a, b] = [display(y, digits), display(limit, digits)];
    if (a !== b) return [a, b];
  }
  return [display(y, 17), display(limit, 17)];
}

/** A sentence on how a scene cuts the shape off, and which of the roots at these t it cuts. */
export function heightsLine(
  name: string,
  between: Between,
  ray: Ray,
  roots: readonly { readonly t: number }[],
): string {
  const [low, high] = between.map((y) => display(y));
  const cuts = roots.flatMap(({ t }, i) => {
    const why = whyCut(ray, t, between);
    return why === null ? [] : [` t${subscript(i + 1)} is cut off there: ${why}.`];
  });
  return (
    `In the scene this ${name} is kept between y = ${low} and ${high}; here it is ` +
    `whole.${cuts.join('')}`
  );
}

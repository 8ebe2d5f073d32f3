import { type HardCase, hardCases } from '../../src/lab/hard-cases.ts';
import { FAMILIES, type Family, type Question, seeded } from '../../src/math/families.ts';
import { InvalidInput, intersect } from '../../src/math/index.ts';

export { DIGITS } from '../../src/lab/hard-cases.ts';

export interface Asked {
  readonly families: readonly Family[];
  readonly seed: number;
  /** Of each family. */
  readonly count: number;
  /** All numbers are rounded to 32 bits before they are answered. */
  readonly float32?: boolean;
}

/**
 * The families with these ids, separated by commas; 'all' are all of them.
 *
 * @throws InvalidInput for an id that there is not.
 */
export function familiesFrom(ids: string): readonly Family[] {
  if (ids === 'all') return FAMILIES();
  return ids.split(',').map((id) => {
    const found = FAMILIES().find((family) => family.id === id);
    if (found) return found;
    const known = FAMILIES()
      .map((family) => family.id)
      .join(', ');
    throw new InvalidInput(`unknown family '${id}': there are all, ${known}`);
  });
}

/** The file's text. Each family draws from the seed anew: it is the same beside any other. */
export function casesText({ families, seed, count, float32 = false }: Asked): string {
  const cases = families.flatMap((family): HardCase[] => {
    const random = seeded(seed);
    return Array.from({ length: count }, (_, i) => ({
      id: `${family.id}/${i + 1}`,
      family: family.id,
      ...family.make(random),
    }));
  });
  const asked = float32 ? cases.flatMap((one) => inFloat32(one) ?? []) : cases;
  return hardCases(asked, seed, float32);
}

/** The same with 32-bit numbers, by which it may be another class; null where it is none then. */
function inFloat32<Q extends Question>(one: Q): Q | null {
  const rounded = JSON.parse(JSON.stringify(one), (_, x) =>
    typeof x === 'number' ? Math.fround(x) : x,
  );
  try {
    intersect(rounded.shape, rounded.ray);
    return rounded;
  } catch (error) {
    if (error instanceof InvalidInput) return null;
    throw error;
  }
}

import { type HardCase, hardCases } from '../../src/lab/hard-cases.ts';
import { FAMILIES, type Family, seeded } from '../../src/math/families.ts';
import { InvalidInput } from '../../src/math/index.ts';

export { DIGITS } from '../../src/lab/hard-cases.ts';

export interface Asked {
  readonly families: readonly Family[];
  readonly seed: number;
  /** Of each family. */
  readonly count: number;
}

/**
 * The families with these ids, separated by commas; 'all' are all of them.
 *
 * @throws InvalidInput for an id that there is not.
 */
export function familiesFrom(ids: string): readonly Family[] {
  if (ids === 'all') return FAMILIES;
  return ids.split(',').map((id) => {
    const found = FAMILIES.find((family) => family.id === id);
    if (found) return found;
    const known = FAMILIES.map((family) => family.id).join(', ');
    throw new InvalidInput(`unknown family '${id}': there are all, ${known}`);
  });
}

/** The file's text. Each family draws from the seed anew: it is the same beside any other. */
export function casesText({ families, seed, count }: Asked): string {
  const cases = families.flatMap((family): HardCase[] => {
    const random = seeded(seed);
    return Array.from({ length: count }, (_, i) => ({
      id: `${family.id}/${i + 1}`,
      family: family.id,
      ...family.make(random),
    }));
  });
  return hardCases(cases, seed);
}

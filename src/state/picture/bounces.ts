import { InvalidInput } from '../../math/index.ts';
import { quote } from '../../math/shapes.ts';

/** Numbers of bounces that are offered; the last one is all that there are. */
export const BOUNCES = [0, 1, 2, 3, 4, 6, 8, 16, 32, 64] as const;

export function readBounces(text: string): number {
  const most = BOUNCES.at(-1) ?? 0;
  if (!/^\d{1,2}$/.test(text) || Number(text) > most) {
    throw new InvalidInput(`${quote(text)} is not a number of bounces from 0 to ${most}`);
  }
  return Number(text);
}

import type { Picture } from './compare.ts';

/** Most levels that a pixel differs by, in any channel, from the four beside it. */
export function differencesBeside({ width, height, rgba }: Picture): Uint8Array<ArrayBuffer> {
  const most = new Uint8Array(width * height);
  const compare = (a: number, b: number): void => {
    let apart = 0;
    for (let k = 0; k < 3; k++) {
      const levels = Math.abs((rgba[4 * a + k] as number) - (rgba[4 * b + k] as number));
      if (levels > apart) apart = levels;
    }
    if (apart > (most[a] as number)) most[a] = apart;
    if (apart > (most[b] as number)) most[b] = apart;
  };
  for (let at = 0; at < width * height; at++) {
    if ((at + 1) % width !== 0) compare(at, at + 1);
    if (at + width < width * height) compare(at, at + width);
  }
  return most;
}

import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import { gzipSync } from 'node:zlib';

/** Bytes of gzip as a good server sends it. */
export const packed = (bytes: Uint8Array): number => gzipSync(bytes, { level: 9 }).length;

/**
 * The scripts that a page of the built site asks for before it shows anything, with their packed
 * sizes.
 */
export function firstLoad(site: string): ReadonlyMap<string, number> {
  const page = readFileSync(join(site, 'index.html'), 'utf8');
  const files = [...page.matchAll(/(?:src|href)="\.\/(assets\/[^"]+\.js)"/g)].map(
    ([, file = '']) => file,
  );
  return new Map(files.map((file) => [file, packed(readFileSync(join(site, file)))]));
}

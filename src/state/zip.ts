import { strToU8, zipSync } from 'fflate';

/** Files in a zip, the same bytes each time: their date is that of the format's beginning. */
export const zipOf = (files: Readonly<Record<string, string>>): Uint8Array =>
  zipSync(Object.fromEntries(Object.entries(files).map(([name, text]) => [name, strToU8(text)])), {
    level: 9,
    mtime: '1980-01-02T00:00:00',
  });

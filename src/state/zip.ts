import { strToU8, type ZipOptions, zip, zipSync } from 'fflate';

/** The same bytes each time: the date of files is that of the format's beginning. */
const OPTIONS: ZipOptions = { level: 9, mtime: '1980-01-02T00:00:00' };

const bytesOf = (files: Readonly<Record<string, string>>): Record<string, Uint8Array> =>
  Object.fromEntries(Object.entries(files).map(([name, text]) => [name, strToU8(text)]));

/** Files in a zip. */
export const zipOf = (files: Readonly<Record<string, string>>): Uint8Array =>
  zipSync(bytesOf(files), OPTIONS);

/** Large files in a zip, packed beside the page. */
export const zipLater = (files: Readonly<Record<string, string>>): Promise<Uint8Array> =>
  new Promise((done, fail) => {
    zip(bytesOf(files), OPTIONS, (error, packed) => (error ? fail(error) : done(packed)));
  });

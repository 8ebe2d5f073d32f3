import { build } from 'vite';

/**
 * The text of `program.ts` with all that it needs in one module, made small as for a site; asked
 * for from the project's root.
 */
export async function bundle(): Promise<string> {
  const made = await build({
    configFile: false,
    logLevel: 'warn',
    build: {
      write: false,
      minify: true,
      target: 'es2022',
      lib: {
        entry: 'tests/accelerated/program.ts',
        formats: ['es'],
        fileName: 'program',
      },
    },
  });
  const [{ output }] = made as unknown as [{ output: [{ code: string }] }];
  return output[0].code;
}

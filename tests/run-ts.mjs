// Runs a TypeScript program of the tests in Node, which cannot read TypeScript everywhere: bundled
// by Vite, then started with the rest of the arguments. `node tests/run-ts.mjs tests/fuzz/page.ts
// --actions 1000`
import { spawnSync } from 'node:child_process';
import { basename, join } from 'node:path';
import { fileURLToPath } from 'node:url';
import { build } from 'vite';

const root = fileURLToPath(new URL('..', import.meta.url));
const outDir = 'test-results/programs';

export async function runTs(file, args = []) {
  process.chdir(root);
  await build({
    configFile: false,
    logLevel: 'warn',
    build: {
      ssr: file,
      outDir,
      emptyOutDir: false,
      target: 'node20',
      rollupOptions: { output: { entryFileNames: '[name].mjs' } },
    },
  });
  const program = join(outDir, `${basename(file, '.ts')}.mjs`);
  return spawnSync(process.execPath, [program, ...args], { stdio: 'inherit' }).status ?? 1;
}

if (process.argv[1] === fileURLToPath(import.meta.url)) {
  const [file, ...args] = process.argv.slice(2);
  process.exitCode = await runTs(file, args);
}

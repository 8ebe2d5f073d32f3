// Builds every tests/bench/*.bench.ts for Node (which cannot read TypeScript everywhere) and runs it; then measures the
// built page in a browser. `npm run bench -- NAME` runs only those whose file name contains NAME.
import { spawnSync } from 'node:child_process';
import { readdirSync } from 'node:fs';
import { basename, join } from 'node:path';
import { fileURLToPath } from 'node:url';
import { build } from 'vite';

const root = fileURLToPath(new URL('../..', import.meta.url));
process.chdir(root);
const wanted = process.argv.slice(2).find((arg) => !arg.startsWith('-')) ?? '';
const outDir = 'test-results/bench';
const names = readdirSync('tests/bench')
  .filter((name) => name.endsWith('.bench.ts') && name.includes(wanted))
  .map((name) => basename(name, '.ts'));

for (const name of names) {
  await build({
    configFile: false,
    logLevel: 'warn',
    build: {
      ssr: `tests/bench/${name}.ts`,
      outDir,
      emptyOutDir: false,
      target: 'node20',
      rollupOptions: { output: { entryFileNames: '[name].mjs' } },
    },
  });
  console.log(`\n## ${name}\n`);
  const ran = spawnSync(process.execPath, [join(outDir, `${name}.mjs`)], { stdio: 'inherit' });
  if (ran.status !== 0) process.exitCode = 1;
}

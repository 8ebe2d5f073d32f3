// `npm run bench`: every tests/bench/*.bench.ts, or with `npm run bench -- NAME` those whose name contains NAME.
import { readdirSync } from 'node:fs';
import { runTs } from '../run-ts.mjs';

const here = new URL('.', import.meta.url);
const [wanted = ''] = process.argv.slice(2).filter((arg) => !arg.startsWith('-'));
for (const name of readdirSync(here).sort()) {
  if (!name.endsWith('.bench.ts') || !name.includes(wanted)) continue;
  console.log(`\n## ${name.replace('.bench.ts', '')}\n`);
  if ((await runTs(`tests/bench/${name}`)) !== 0) process.exitCode = 1;
}

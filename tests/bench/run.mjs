// `npm run bench`: every tests/bench/*.bench.ts, or with `npm run bench -- NAME` those whose name
// contains NAME. What begins with -- and comes after it is handed on: `npm run bench -- ladder
// --families typical,mix --rounds 3`.
import { readdirSync } from 'node:fs';
import { runTs } from '../run-ts.mjs';

const here = new URL('.', import.meta.url);
const given = process.argv.slice(2);
const wanted = given[0]?.startsWith('--') ? '' : (given[0] ?? '');
const options = wanted ? given.slice(1) : given;
for (const name of readdirSync(here).sort()) {
  if (!name.endsWith('.bench.ts') || !name.includes(wanted)) continue;
  console.log(`\n## ${name.replace('.bench.ts', '')}\n`);
  if ((await runTs(`tests/bench/${name}`, options)) !== 0) process.exitCode = 1;
}

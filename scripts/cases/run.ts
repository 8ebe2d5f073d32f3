import { writeFileSync } from 'node:fs';
import { parseArgs } from 'node:util';
import { casesText, familiesFrom } from './cases.ts';

/* `npm run cases -- --family near-tangent,vertex --seed 7 --count 100 --out cases.json` */

const { values } = parseArgs({
  options: {
    family: { type: 'string', default: 'all' },
    seed: { type: 'string', default: '1' },
    count: { type: 'string', default: '100' },
    out: { type: 'string' },
  },
});

/** @throws RangeError for what is no whole number from 0 to 2^32 − 1. */
function whole(name: string, given: string): number {
  const x = Number(given);
  if (given.trim() === '' || !Number.isInteger(x) || x < 0 || x >= 2 ** 32)
    throw new RangeError(`--${name} must be a whole number ≥ 0, got ${given}`);
  return x;
}

try {
  const seed = whole('seed', values.seed);
  const count = whole('count', values.count);
  const text = casesText({ families: familiesFrom(values.family), seed, count });
  if (values.out === undefined) process.stdout.write(text);
  else writeFileSync(values.out, text);
} catch (error) {
  if (!(error instanceof RangeError)) throw error;
  console.error(error.message);
  process.exitCode = 1;
}

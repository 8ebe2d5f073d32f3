// What prices are made of, and what was tried to lower them: counted and timed. With --write, or
// as a part of `npm run bench -- ladder`, into docs/bench.md.
import { readFileSync, writeFileSync } from 'node:fs';
import { FAMILIES, type Family } from '../../src/math/families.ts';
import { METHODS } from '../../src/math/methods/index.ts';
import { betweenMarks } from './ladder-report.ts';
import { REASONS, reasonLines, reasonsOf, sampleOf } from './reasons.ts';

const PLAN = { rounds: 15, least: 4, steps: 100, warmUp: 2 };

const methods = METHODS.filter(({ id }) => id !== 'exact');
const typical = FAMILIES().find(({ id }) => id === 'typical') as Family;
const lines = reasonLines(reasonsOf(typical, sampleOf(), methods, PLAN), methods);
console.log(lines.join('\n'));
if (process.argv.includes('--write')) {
  const path = 'docs/bench.md';
  writeFileSync(path, betweenMarks(readFileSync(path, 'utf8'), lines, REASONS));
}

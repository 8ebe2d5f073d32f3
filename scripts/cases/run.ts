import { writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { parseArgs } from 'node:util';
import { casesText, familiesFrom } from './cases.ts';
import cpp from './graze_cases.hpp?raw';
import html from './graze_cases.html?raw';
import rust from './graze_cases.rs?raw';
import python from './run_cases.py?raw';

/* `npm run cases -- --family near-tangent,vertex`, and the command `graze-cases` of graze-math. */

const RUNNERS: Readonly<Record<string, readonly [file: string, text: string]>> = {
  python: ['run_cases.py', python],
  cpp: ['graze_cases.hpp', cpp],
  rust: ['graze_cases.rs', rust],
  glsl: ['graze_cases.html', html],
};

const HELP = `graze-cases [--family ID,… | all] [--seed N] [--count N] [--float32] [--out FILE]

Rays that are hard for programs, with their exact answers in 40 digits, as JSON: to FILE, or here.
  --family   families of rays, by id; all of them unless given
  --seed     a whole number from which they are drawn, 1 unless given
  --count    rays of each family, 100 unless given
  --float32  numbers of 32 bits, for programs that have no others

graze-cases --runner ${Object.keys(RUNNERS).join('|')} [--out FOLDER]

A file that judges a program in that language by the cases, put into FOLDER, or here. It says at its
beginning how it is used. All of them write reports in JUnit's XML and in Markdown.
`;

const { values } = parseArgs({
  options: {
    family: { type: 'string', default: 'all' },
    seed: { type: 'string', default: '1' },
    count: { type: 'string', default: '100' },
    float32: { type: 'boolean', default: false },
    out: { type: 'string' },
    runner: { type: 'string' },
    help: { type: 'boolean', short: 'h', default: false },
  },
});

/** @throws RangeError for what is no whole number from 0 to 2^32 − 1. */
function whole(name: string, given: string): number {
  const x = Number(given);
  if (given.trim() === '' || !Number.isInteger(x) || x < 0 || x >= 2 ** 32)
    throw new RangeError(`--${name} must be a whole number ≥ 0, got ${given}`);
  return x;
}

function putRunner(name: string, folder: string): void {
  const [file, text] = RUNNERS[name] ?? [];
  if (file === undefined || text === undefined) {
    throw new RangeError(`no runner '${name}': there are ${Object.keys(RUNNERS).join(', ')}`);
  }
  const path = join(folder, file);
  writeFileSync(path, text);
  console.log(path);
}

function put(): void {
  if (values.help) {
    process.stdout.write(HELP);
    return;
  }
  if (values.runner !== undefined) {
    putRunner(values.runner, values.out ?? '.');
    return;
  }
  const seed = whole('seed', values.seed);
  const count = whole('count', values.count);
  const { family, float32, out } = values;
  const text = casesText({ families: familiesFrom(family), seed, count, float32 });
  if (out === undefined) process.stdout.write(text);
  else writeFileSync(out, text);
}

try {
  put();
} catch (error) {
  if (!(error instanceof RangeError)) throw error;
  console.error(error.message);
  process.exitCode = 1;
}

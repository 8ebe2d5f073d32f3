// npm run test:long -- --only firefox,webkit: what takes too long for `npm test`, or needs other
// browsers.
import { spawnSync } from 'node:child_process';
import { parseArgs } from 'node:util';
import { serveSite } from '../serve-site.ts';
import { accelerated } from './accelerated.ts';
import { BROWSERS, type BrowserName, chromiumFound, found, reference } from './browsers.ts';
import { type Seen, tour } from './tour.ts';
import type { Tourist } from './webdriver.ts';

/** Commands of package.json, each with what makes it long. */
const COMMANDS: Readonly<Record<string, readonly string[]>> = {
  unit: ['test:unit'],
  browser: ['test:browser'],
  rays: ['fuzz', '--rays', '1e7'],
  page: ['fuzz:page', '--actions', '5000'],
  shots: ['shots'],
  bench: ['bench'],
};
const STEPS = [...BROWSERS, ...Object.keys(COMMANDS)];

const { values } = parseArgs({
  options: { only: { type: 'string', default: STEPS.join() }, seed: { type: 'string' } },
});
const steps = values.only.split(',');
const unknown = steps.filter((step) => !STEPS.includes(step));
if (unknown.length > 0) throw new RangeError(`no step ${unknown}: there are ${STEPS.join(', ')}`);

let passed = 0;
let failed = 0;
const skipped: string[] = [];
const judge = (name: string, ok: boolean): void => {
  console.log(`${ok ? '  ok ' : 'FAILED'} ${name}`);
  if (ok) passed += 1;
  else failed += 1;
};

/** Runs a command of npm; whether it ended well. */
function run(argv: readonly string[], env: NodeJS.ProcessEnv): boolean {
  const { status } = spawnSync('npm', argv, { stdio: 'inherit', env });
  judge(`npm ${argv.join(' ')}`, status === 0);
  return status === 0;
}

const browsers = BROWSERS.filter((name) => steps.includes(name));
if (browsers.length > 0) await tours(browsers);
for (const [step, [script = '', ...args]] of Object.entries(COMMANDS)) {
  if (!steps.includes(step)) continue;
  const seed =
    values.seed === undefined || !script.startsWith('fuzz') ? [] : ['--seed', values.seed];
  const argv = ['run', script, '--', ...args, ...seed];
  // Unit and browser tests take all of their cases, not some by turns: tests/unit/many.ts.
  const env: NodeJS.ProcessEnv = { ...process.env, LONG: '1' };
  if (step === 'browser') {
    if (!env.SITE_IS_BUILT && !run(['run', 'build'], env)) continue;
    env.E2E_CHROMIUM ??= (await chromiumFound()).path;
  }
  run(argv, env);
}
for (const name of skipped)
  console.log(`NOT RUN: ${name}: it is not here and could not be installed`);
console.log(
  `${passed} passed, ${failed} failed${skipped.length > 0 ? `, ${skipped.length} skipped` : ''}`,
);
process.exitCode = failed > 0 ? 1 : 0;

/** As a plain host serves it: no headers, in a folder. */
async function tours(names: readonly BrowserName[]): Promise<void> {
  const site = await serveSite({ folder: '/x/y/', headers: {} });
  try {
    const own = await reference();
    const all = async (browser: Tourist): Promise<Seen> => ({
      ...(await tour(browser, site.url)),
      ...(await accelerated(browser)),
    });
    const wanted = await all(own).finally(own.close);
    for (const name of names) {
      console.log(`${name}:`);
      const browser = await found(name);
      if (!browser) {
        skipped.push(name);
        continue;
      }
      try {
        compare(name, wanted, await all(browser));
      } catch (error) {
        judge(`${name}: ${(error as Error).message}`, false);
      } finally {
        await browser.close();
      }
    }
  } finally {
    site.close();
  }
}

function compare(name: string, wanted: Seen, got: Seen): void {
  for (const [what, value] of Object.entries(wanted)) {
    judge(`${name}: ${what}`, got[what] === value);
    if (got[what] !== value) console.log(firstDifference(value, got[what] ?? ''));
  }
}

function firstDifference(wanted: string, got: string): string {
  const lines = got.split('\n');
  const at = wanted.split('\n').findIndex((line, i) => line !== lines[i]);
  return `    Chromium: ${wanted.split('\n')[at]}\n    here:     ${lines[at]}`;
}

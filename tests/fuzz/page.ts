// npm run fuzz:page -- --actions 5000 --seed 7: a random user on the built page, for as long as
// wanted.
import { parseArgs } from 'node:util';
import { chromium } from '@playwright/test';
import { countPending } from '../browser/support/pending.ts';
import { serveSite } from '../serve-site.ts';
import { pageTruth } from './page-truth.ts';
import { prepare, randomUser } from './random-user.ts';

const { values } = parseArgs({
  options: {
    actions: { type: 'string', default: '2000' },
    seed: { type: 'string', default: '1' },
  },
});
const actions = Number(values.actions);
const seed = Number(values.seed);

const site = await serveSite();
process.exitCode = await fuzz(site.url);
site.close();

async function fuzz(url: string): Promise<number> {
  // @ts-expect-error: a plain script, shared with the tests' runner.
  const { ensureChromium, args } = await import('../browser.mjs');
  const { executablePath } = await ensureChromium();
  const browser = await chromium.launch({ args, ...(executablePath && { executablePath }) });
  const context = await browser.newContext({
    viewport: { width: 900, height: 640 },
    hasTouch: true,
  });
  const page = await context.newPage();
  const errors: string[] = [];
  page.on('pageerror', (error) => errors.push(error.stack ?? error.message));
  await page.addInitScript(countPending);
  await prepare(page);
  await page.goto(url);
  const result = await randomUser(
    page,
    { seed, actions, every: 10 },
    () => pageTruth(page, errors),
    (done) => {
      if (done % 100 === 0) console.log(`${done} of ${actions} actions, seed ${seed}`);
    },
  );
  await browser.close();
  console.log(result.failure ?? `${result.done} actions, nothing wrong`);
  return result.failure ? 1 : 0;
}

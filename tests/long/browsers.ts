import { spawnSync } from 'node:child_process';
import { existsSync, readdirSync } from 'node:fs';
import { type Browser, type BrowserType, chromium, firefox, webkit } from '@playwright/test';
import { type Tourist, webkitGtk } from './webdriver.ts';

export const BROWSERS = ['firefox', 'webkit'] as const;
export type BrowserName = (typeof BROWSERS)[number];

/** Where the Chromium is that `npm test` takes, and how it is started; '' for Playwright's own. */
export async function chromiumFound(): Promise<{ path: string; args: string[] }> {
  // @ts-expect-error: a plain script, shared with the tests' runner.
  const { ensureChromium, args } = await import('../browser.mjs');
  const { executablePath: path = '' } = await ensureChromium();
  return { path, args };
}

/** Chromium, whose values the others are to have. */
export async function reference(): Promise<Tourist> {
  const { path: executablePath, args } = await chromiumFound();
  return byPlaywright(await chromium.launch({ args, ...(executablePath && { executablePath }) }));
}

/** The browser, installed if need be; null where it cannot be had. */
export async function found(name: BrowserName): Promise<Tourist | null> {
  for (const way of [WAYS[name], bySystem(name), byOwnBuild(name)]) {
    const made = await way().catch((error: Error) => {
      console.error(`  ${name}: ${error.message.split('\n')[0]}`);
      return null;
    });
    if (made) return made;
  }
  return null;
}

const WAYS: Readonly<Record<BrowserName, () => Promise<Tourist | null>>> = {
  async firefox() {
    const path = [process.env.FIREFOX_PATH, '/usr/bin/firefox', '/usr/bin/firefox-esr'].find(
      (one) => one && existsSync(one),
    );
    if (!path) return null;
    return byPlaywright(await firefox.launch({ channel: 'moz-firefox', executablePath: path }));
  },
  async webkit() {
    const browser = miniBrowser();
    const driver = '/usr/bin/WebKitWebDriver';
    if (!browser || !existsSync(driver) || !existsSync('/usr/bin/xvfb-run')) return null;
    return webkitGtk(driver, browser);
  },
};

/** As root on Debian. */
const bySystem = (name: BrowserName) => async (): Promise<Tourist | null> => {
  if (process.getuid?.() !== 0 || !existsSync('/usr/bin/apt-get')) return null;
  const packages = name === 'firefox' ? ['firefox-esr'] : ['webkit2gtk-driver', 'xvfb', 'xauth'];
  for (const argv of [
    ['update', '-qq'],
    ['install', '-y', '-qq', ...packages],
  ]) {
    spawnSync('apt-get', argv, { stdio: 'inherit', timeout: 600_000 });
  }
  return WAYS[name]();
};

const byOwnBuild = (name: BrowserName) => async (): Promise<Tourist | null> => {
  const types: Readonly<Record<BrowserName, BrowserType>> = { firefox, webkit };
  const cli = 'node_modules/@playwright/test/cli.js';
  spawnSync(process.execPath, [cli, 'install', name], { stdio: 'inherit', timeout: 300_000 });
  return byPlaywright(await types[name].launch());
};

function miniBrowser(): string | undefined {
  const folder = '/usr/lib';
  if (!existsSync(folder)) return undefined;
  return readdirSync(folder)
    .flatMap((arch) =>
      ['4.1', '6.0', '4.0'].map((v) => `${folder}/${arch}/webkit2gtk-${v}/MiniBrowser`),
    )
    .find((path) => existsSync(path));
}

async function byPlaywright(browser: Browser): Promise<Tourist> {
  const page = await browser.newPage({ viewport: { width: 1280, height: 844 } });
  return {
    goto: async (url) => void (await page.goto(url)),
    run: (act, given) => page.evaluate(act as never, given) as never,
    close: () => browser.close(),
  };
}
